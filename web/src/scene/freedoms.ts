// SPDX-License-Identifier: Apache-2.0
// Which directions a joint or primitive leaves free, and how its symbol shows them.

export interface Freedom {
  kind: 'translation' | 'rotation';
  of: 'I' | 'J';
  axis: 'x' | 'y' | 'z';
}

const free = (kind: Freedom['kind'], of: Freedom['of'], axes: string): Freedom[] =>
  [...axes].map((axis) => ({ kind, of, axis: axis as Freedom['axis'] }));

const slide = (axes: string) => free('translation', 'J', axes);
const turn = (axes: string, of: Freedom['of'] = 'J') => free('rotation', of, axes);

const table: Record<string, Freedom[]> = {
  FIXED: [],
  REVOLUTE: turn('z'),
  TRANSLATIONAL: slide('z'),
  CYLINDRICAL: [...slide('z'), ...turn('z')],
  SCREW: [...slide('z'), ...turn('z')],
  SPHERICAL: turn('xyz', 'I'),
  PLANAR: [...slide('xy'), ...turn('z')],
  UNIVERSAL: [...turn('z', 'I'), ...turn('z')],
  HOOKE: [...turn('x', 'I'), ...turn('y')],
  CONVEL: [...turn('x', 'I'), ...turn('y')],
  RACKPIN: [...slide('z'), ...turn('z', 'I')],
  ATPOINT: turn('xyz', 'I'),
  INLINE: [...slide('z'), ...turn('xyz', 'I')],
  INPLANE: [...slide('xy'), ...turn('xyz', 'I')],
  ORIENTATION: slide('xyz'),
  PARALLEL_AXES: [...slide('xyz'), ...turn('z')],
  PERPENDICULAR: [...slide('xyz'), ...turn('z', 'I'), ...turn('z')],
};

/** Null where the free directions are not those of one marker's axes. */
export function freedomsOf(kind: string, type: string | null | undefined): Freedom[] | null {
  if (kind !== 'JOINT' && kind !== 'JPRIM') return null;
  return table[(type ?? '').toUpperCase()] ?? null;
}

/** What is held, drawn in the middle of the symbol. */
export function coreOf(type: string | null | undefined): 'cube' | 'line' | 'plane' | 'ball' {
  switch ((type ?? '').toUpperCase()) {
    case 'FIXED': case 'ORIENTATION': case 'PARALLEL_AXES': case 'PERPENDICULAR': return 'cube';
    case 'INLINE': case 'TRANSLATIONAL': case 'CYLINDRICAL': case 'SCREW': return 'line';
    case 'INPLANE': case 'PLANAR': return 'plane';
    default: return 'ball';
  }
}
