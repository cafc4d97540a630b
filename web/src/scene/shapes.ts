// SPDX-License-Identifier: Apache-2.0
// GRAPHICS statements as items.
import { BufferGeometry, Color, Matrix4, Vector3 } from 'three';
import type { Graphic } from '../data/contract';
import type { Motion } from '../data/motion';
import type { Batch, Item } from './batch';
import type { Geometries } from './geometries';
import { between, positionOf, scaling, shifted } from './place';
import { roles } from './palette';

interface Solid {
  geometry: string;
  make: (geometries: Geometries) => BufferGeometry;
  local: Matrix4;
}

const turn = 2 * Math.PI;
const value = (g: Graphic, name: string, otherwise = 0) => g.values?.[name] ?? otherwise;
const round = (x: number) => Number(x.toPrecision(3));

function angleOf(g: Graphic): number {
  const angle = value(g, 'angle', value(g, 'rangle', turn));
  return Math.abs(angle) > turn ? turn : angle;
}

function cylinder(radius: number, length: number): Solid {
  return { geometry: 'rod24', make: (g) => g.cylinder(), local: scaling(radius, radius, length).multiply(flip(length)) };
}

// A negative scale would turn the surface inside out.
function flip(length: number): Matrix4 {
  return length < 0 ? scaling(1, 1, -1).multiply(shifted(0, 0, -1)) : new Matrix4();
}

function frustumSolid(g: Graphic): Solid {
  const [bottom, top, length] = [value(g, 'bottom'), value(g, 'top'), value(g, 'length')];
  const widest = Math.max(Math.abs(bottom), Math.abs(top), 1e-30);
  const [a, b] = [round(Math.abs(bottom) / widest), round(Math.abs(top) / widest)];
  const [first, last] = length < 0 ? [b, a] : [a, b];
  const place = shifted(0, 0, Math.min(0, length)).multiply(scaling(widest, widest, Math.abs(length)));
  return { geometry: `frustum ${first} ${last}`, make: (geometries) => geometries.frustum(first, last), local: place };
}

function boxSolid(g: Graphic): Solid {
  const [x, y, z] = ['x', 'y', 'z'].map((name) => value(g, name));
  const size = scaling(Math.abs(x), Math.abs(y), Math.abs(z));
  return { geometry: 'box', make: (geometries) => geometries.box(), local: shifted(x / 2, y / 2, z / 2).multiply(size) };
}

function ellipsoidSolid(g: Graphic): Solid {
  const [x, y, z] = ['xscale', 'yscale', 'zscale'].map((name) => Math.abs(value(g, name)) / 2);
  return { geometry: 'ball', make: (geometries) => geometries.ball(), local: scaling(x, y, z) };
}

function ringSolid(g: Graphic, line: number): Solid {
  const radius = Math.abs(value(g, 'radius')) || line;
  const tube = round(Math.min(0.2, line / radius));
  const angle = g.shape === 'ARC' ? round(angleOf(g)) : turn;
  return { geometry: `ring ${tube} ${angle}`, make: (geometries) => geometries.ring(tube, angle), local: scaling(radius, radius, radius) };
}

function torusSolid(g: Graphic): Solid {
  const major = Math.abs(value(g, 'major', value(g, 'radius'))) || 1;
  const tube = round(Math.abs(value(g, 'minor', major / 5)) / major);
  return { geometry: `ring ${tube} ${turn}`, make: (geometries) => geometries.ring(tube), local: scaling(major, major, major) };
}

// Only part of the way round: a wall seen from both sides.
function sector(g: Graphic): Solid {
  const angle = round(angleOf(g));
  const solid = g.shape === 'FRUSTUM' ? frustumSolid(g) : cylinder(Math.abs(value(g, 'radius')), Math.abs(value(g, 'length')));
  const [bottom, top] = g.shape === 'FRUSTUM' ? solid.geometry.split(' ').slice(1).map(Number) : [1, 1];
  return { ...solid, geometry: `sector ${bottom} ${top} ${angle}`, make: () => wall(bottom, top, angle) };
}

function wall(bottom: number, top: number, angle: number): BufferGeometry {
  const geometry = new BufferGeometry();
  const steps = 32;
  const points: Vector3[] = [];
  for (let k = 0; k < steps; ++k) {
    const [a, b] = [(angle * k) / steps, (angle * (k + 1)) / steps];
    const at = (radius: number, phi: number, z: number) => new Vector3(radius * Math.cos(phi), radius * Math.sin(phi), z);
    const [p, q, r, s] = [at(bottom, a, 0), at(bottom, b, 0), at(top, a, 1), at(top, b, 1)];
    points.push(p, q, s, p, s, r);
  }
  geometry.setFromPoints(points);
  geometry.computeVertexNormals();
  geometry.userData.open = true;
  return geometry;
}

function solidOf(g: Graphic, line: number): Solid | null {
  const partial = Math.abs(angleOf(g)) < turn - 1e-6;
  switch (g.shape) {
    case 'CYLINDER': return partial ? sector(g) : cylinder(Math.abs(value(g, 'radius')), value(g, 'length'));
    case 'FRUSTUM': return partial ? sector(g) : frustumSolid(g);
    case 'BOX': return boxSolid(g);
    case 'ELLIPSOID': return ellipsoidSolid(g);
    case 'CIRCLE': case 'ARC': return ringSolid(g, line);
    case 'TORUS': return torusSolid(g);
    default: return null;
  }
}

export class Shapes {
  constructor(
    private readonly motion: Motion,
    private readonly batch: Batch,
    private readonly geometries: Geometries,
    private readonly line: number,
    private readonly colorOfPart: (part: number) => Color,
  ) {}

  add(g: Graphic): void {
    if (g.shape === 'OUTLINE') this.addOutline(g);
    else if (g.shape === 'SPDP') this.addSpring(g);
    else this.addSolid(g);
  }

  private addSolid(g: Graphic): void {
    const solid = solidOf(g, this.line);
    if (solid) this.batch.add(this.fixed(g, g.marker ?? 0, solid), () => solid.make(this.geometries));
  }

  private addOutline(g: Graphic): void {
    const markers = g.points ?? [];
    for (let k = 0; k + 1 < markers.length; ++k) this.addSegment(g, markers[k], markers[k + 1]);
  }

  private addSegment(g: Graphic, first: number, second: number): void {
    const [a, b] = [this.motion.markers.get(first), this.motion.markers.get(second)];
    if (!a || !b) return;
    if (a.part === b.part && !a.flexible) {
      const local = between(positionOf(a.local), positionOf(b.local), this.line);
      const frame = this.motion.partFrames[a.part];
      if (local) this.batch.add({ ...this.describe(g, a.part), geometry: 'rod', frame, local }, this.geometries.rod);
      return;
    }
    const place = (out: Matrix4) => between(positionOf(a.frame), positionOf(b.frame), this.line, out) !== null;
    this.batch.add({ ...this.describe(g, a.part), geometry: 'rod', place }, this.geometries.rod);
  }

  private addSpring(g: Graphic): void {
    const [i, j] = [this.motion.markerFrame(g.i), this.motion.markerFrame(g.j)];
    const part = this.motion.markers.get(g.i ?? 0)?.part ?? this.motion.ground;
    const ends = { from: i, to: j, startGap: value(g, 'la'), endGap: value(g, 'lb') };
    const turns = Math.min(60, Math.max(1, Math.round(value(g, 'coils', 6))));
    const radius = value(g, 'da') / 2 || 6 * this.line;
    const item = (geometry: string, place: Item['place']) => ({ ...this.describe(g, part), color: roles.spring, geometry, place });
    this.batch.add(item(`coil ${turns}`, (out) => placeBetween(ends, radius, 0, 1, out)), () => this.geometries.coil(turns));
    const damper = { from: i, to: j, startGap: value(g, 'lc'), endGap: value(g, 'ld') };
    const [outer, inner] = [value(g, 'db') / 2, value(g, 'dc') / 2];
    if (outer > 0) this.batch.add(item('rod24', (out) => placeBetween(damper, outer, 0, 0.6, out)), this.geometries.cylinder);
    if (inner > 0) this.batch.add(item('rod24', (out) => placeBetween(damper, inner, 0.4, 1, out)), this.geometries.cylinder);
  }

  private describe(g: Graphic, part: number): Omit<Item, 'geometry'> {
    const owner = this.motion.results.report.parts[part]?.id ?? g.id;
    return { id: owner, alsoOf: g.id, kind: g.shape, color: this.colorOfPart(part) };
  }

  private fixed(g: Graphic, markerId: number, solid: Solid): Item {
    const marker = this.motion.markers.get(markerId);
    const part = marker?.part ?? this.motion.ground;
    const about = { ...this.describe(g, part), geometry: solid.geometry };
    if (marker?.flexible) {
      const place = (out: Matrix4) => Boolean(out.multiplyMatrices(marker.frame, solid.local));
      return { ...about, place };
    }
    const local = marker ? marker.local.clone().multiply(solid.local) : solid.local;
    return { ...about, frame: this.motion.partFrames[part] ?? new Matrix4(), local };
  }
}

interface Ends {
  from: Matrix4;
  to: Matrix4;
  startGap: number;
  endGap: number;
}

/** From one fraction to another of the line between two frames, less the gaps at its ends. */
function placeBetween(ends: Ends, thickness: number, start: number, end: number, out: Matrix4): boolean {
  const [a, b] = [positionOf(ends.from), positionOf(ends.to)];
  const length = a.distanceTo(b);
  const gaps = ends.startGap + ends.endGap < length ? [ends.startGap, ends.endGap] : [0, 0];
  const at = (fraction: number) => (length > 0 ? (gaps[0] + fraction * (length - gaps[0] - gaps[1])) / length : 0);
  const first = new Vector3().lerpVectors(a, b, at(start));
  return between(first, new Vector3().lerpVectors(a, b, at(end)), thickness, out) !== null;
}
