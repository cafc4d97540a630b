// SPDX-License-Identifier: Apache-2.0
// One of everything that a page can be given, with names that try to break out.
import { Blocks } from './page.mjs';

export const hostile = {
  title: `</script><script>window.broken = 'title'</script> "quoted" & 'Größe' 日本語`,
  request: `R"1</script><img src=x onerror="window.broken='column'">.é,F1`,
  dataset: `<!-- </script><script>window.broken = 'dataset'</script> \u2028 "ü" -->`,
  warning: `<img src=x onerror="window.broken='warning'"> & <b>bold</b>`,
  option: `</title><svg onload="window.broken='option'">`,
};

export const graphics = {
  CYLINDER: { marker: 20, values: { radius: 0.4, length: 1.5 } },
  BOX: { marker: 20, values: { x: 1, y: 0.8, z: 0.6 } },
  ELLIPSOID: { marker: 20, values: { xscale: 2, yscale: 1, zscale: 0.8 } },
  FRUSTUM: { marker: 20, values: { length: 1.2, top: 0.2, bottom: 0.6 } },
  CIRCLE: { marker: 20, values: { radius: 1 } },
  ARC: { marker: 20, values: { radius: 1, rangle: 2 } },
  TORUS: { marker: 20, values: { major: 1, minor: 0.2 } },
  OUTLINE: { points: [20, 21, 22, 10] },
  SPDP: { i: 21, j: 10, values: { coils: 5, da: 0.4, db: 0.2, dc: 0.12, la: 0.1, lb: 0.1 } },
};

const rows = 21;
const times = Array.from({ length: rows }, (_, k) => k / (rows - 1));
export const digits = (k) => 0.1 * k + 1e-17 * k + 1 / 3;

function flexible(blocks, part) {
  const points = [0, 1, 2, 3].flatMap((x) => [[x, 0, 0], [x, 0.4, 0], [x, 0, 0.4]]).flat();
  const faces = [0, 1, 2].flatMap((k) => [[3 * k, 3 * k + 3, 3 * k + 1], [3 * k + 1, 3 * k + 3, 3 * k + 4], [3 * k, 3 * k + 2, 3 * k + 3], [3 * k + 2, 3 * k + 5, 3 * k + 3]]);
  const mode = points.map((_, k) => (k % 3 === 1 ? 0.05 * points[k - 1] ** 2 : 0));
  return {
    part, points: blocks.array('f32', [12, 3], points), edges: [[0, 3], [3, 6], [6, 9], [1, 4], [4, 7], [7, 10]], faces,
    modes: blocks.array('f32', [1, 12, 3], mode), amplitudes: blocks.array('f32', [rows, 1], times.map((t) => Math.sin(6 * t))),
  };
}

const partData = (id, parent, joint) => ({ id, ground: false, mass: 1, cm: [0.5, 0, 0], inertia: [0.02, 0.1, 0.1, 0, 0, 0], parent, joint });

function elements() {
  const joint = (id, kind, type, i, j, loadOnI = null, isForce = false) => ({ id: `${kind}/${id}`, kind, type, i, j, isForce, loadOnI });
  const joints = ['REVOLUTE', 'TRANSLATIONAL', 'CYLINDRICAL', 'SPHERICAL', 'PLANAR', 'FIXED', 'UNIVERSAL', 'HOOKE', 'CONVEL', 'SCREW', 'RACKPIN'];
  const primitives = ['ATPOINT', 'INLINE', 'INPLANE', 'ORIENTATION', 'PARALLEL_AXES', 'PERPENDICULAR'];
  return [
    ...joints.map((type, k) => joint(k + 1, 'JOINT', type, 21, 10, k === 0 ? 0 : null)),
    ...primitives.map((type, k) => joint(k + 1, 'JPRIM', type, 22, 10)),
    joint(1, 'MOTION', 'ROTATIONAL', 20, 10), joint(1, 'GCON', null, 20, 0),
    joint(1, 'SPRINGDAMPER', 'TRANSLATIONAL', 22, 11, null, true), joint(2, 'SPRINGDAMPER', 'ROTATIONAL', 22, 11, null, true),
    joint(1, 'SFORCE', 'TRANSLATIONAL', 21, 11, null, true), joint(1, 'BUSHING', null, 30, 11, null, true), joint(1, 'GFORCE', null, 30, 0, null, true),
    joint(1, 'REQUEST', null, 30, 10),
  ];
}

function tables(blocks) {
  const table = (name, columns, value) => ({
    name, columns, time: blocks.array('f64', [rows], times),
    data: blocks.array('f64', [columns.length, rows], columns.flatMap((_, c) => times.map((_, k) => value(c, k)))),
  });
  const load = ['FX', 'FY', 'FZ', 'TX', 'TY', 'TZ'].map((s, k) => ({ name: `JOINT/1.I.${s}`, unit: k < 3 ? 'N' : 'N mm', element: 'JOINT/1' }));
  return [
    table('requests', [{ name: hostile.request, unit: 'mm', element: 'REQUEST/1' }, { name: 'R1.F2', unit: '', element: 'REQUEST/1' }],
      (c, k) => (c === 0 ? digits(k) : k === 3 ? Infinity : k === 4 ? NaN : -k)),
    table('reactions', load, (c, k) => (c === 1 ? 30 * Math.sin(k) : c === 5 ? k : 2)),
    table('energy', [{ name: 'energy.total', unit: 'J', element: null }, { name: 'constraint error', unit: '', element: null }], (c, k) => 10 ** -c + k * 1e-3),
  ];
}

/** With all graphics, only those of some shapes, or none. */
export function everything(shapes = Object.keys(graphics), { withFlexible = true, withElements = true } = {}) {
  const blocks = new Blocks(false);
  const id = [1, 0, 0, 0];
  const marker = (number, part, x, y, z, q = id) => ({ id: number, part, pose: [x, y, z, ...q] });
  const rocking = (t, x) => [x, 0.2 * t, 0, Math.cos(t / 2), 0, 0, Math.sin(t / 2)];
  const poses = times.flatMap((t) => [[0, 0, 0, ...id], rocking(t, 0), rocking(2 * t, 2), [0, -1.5, 0, ...id]].flat());
  const report = {
    format: 1, title: hostile.title, units: { length: 'mm', force: 'N', mass: 'kg', time: 's' },
    text: {
      dataset: hostile.dataset, file: 'a "b" <c>.adm', options: [['--end', hostile.option]], versions: [['jprim', '0.2.0']], summary: ['summary & <i>'],
      analysis: ['analysis'], warnings: [{ severity: 'warning', where: 'a.adm:1:2', message: hostile.warning }], freedoms: null,
    },
    gravity: [0, 0, 0],
    parts: [{ id: 'PART/1', ground: true, mass: 0, cm: [0, 0, 0], inertia: [0, 0, 0, 0, 0, 0], parent: null, joint: null },
      partData('PART/2', 'PART/1', 'REVOLUTE'), partData('PART/3', 'PART/2', null), partData('FLEX_BODY/3', null, 'FREE')],
    markers: [marker(10, 0, 0, -0.6, 0), marker(11, 0, 3, 0, 0), marker(20, 1, 0, 0, 0), marker(21, 1, 1, 0, 0), marker(22, 1, 1, 0.7, 0), marker(30, 2, 0, 0, 0),
      marker(40, 3, 3, 0, 0)],
    elements: withElements ? elements() : [],
    graphics: shapes.map((shape, k) => ({ id: `GRAPHICS/${k + 1}`, shape, ...graphics[shape] })),
    flexible: withFlexible ? [flexible(blocks, 3)] : [],
    frames: { time: blocks.array('f64', [rows], times), poses: blocks.array('f32', [rows, 4, 7], poses) },
    tables: tables(blocks),
  };
  return { report, blocks };
}
