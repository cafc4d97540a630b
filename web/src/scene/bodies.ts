// SPDX-License-Identifier: Apache-2.0
// A part without graphics: links between its markers and an ellipsoid of its inertia.
import { Color, Matrix4, Vector3 } from 'three';
import type { Part } from '../data/contract';
import { inertiaEllipsoid } from '../data/inertia';
import type { Motion } from '../data/motion';
import type { Batch } from './batch';
import type { Geometries } from './geometries';
import { between, positionOf, scaling } from './place';

const mostPoints = 60;

/** Edges of the shortest tree that joins the points (Prim). */
export function shortestTree(points: Vector3[]): [number, number][] {
  const edges: [number, number][] = [];
  const nearest = points.map((point) => ({ from: 0, distance: points[0] ? point.distanceTo(points[0]) : 0 }));
  const open = new Set(points.keys());
  open.delete(0);
  while (open.size > 0) {
    const next = [...open].reduce((a, b) => (nearest[a].distance <= nearest[b].distance ? a : b));
    open.delete(next);
    edges.push([nearest[next].from, next]);
    for (const k of open) {
      const distance = points[k].distanceTo(points[next]);
      if (distance < nearest[k].distance) nearest[k] = { from: next, distance };
    }
  }
  return edges;
}

function distinctPoints(points: Vector3[], tolerance: number): Vector3[] {
  const kept: Vector3[] = [];
  for (const point of points) {
    if (kept.length < mostPoints && kept.every((other) => other.distanceTo(point) > tolerance)) kept.push(point);
  }
  return kept;
}

export class Bodies {
  private readonly used = new Set<number>();
  private readonly markersOf: Vector3[][];

  constructor(
    private readonly motion: Motion,
    private readonly batch: Batch,
    private readonly geometries: Geometries,
    private readonly size: number,
  ) {
    const { elements, parts } = motion.results.report;
    for (const { i, j } of elements) this.used.add(i).add(j);
    this.markersOf = parts.map(() => []);
    for (const marker of motion.markers.values()) {
      if (this.used.has(marker.id)) this.markersOf[marker.part].push(positionOf(marker.local));
    }
  }

  add(index: number, color: Color): void {
    const part = this.motion.results.report.parts[index];
    const centre = new Vector3(...(part.cm as [number, number, number]));
    const points = distinctPoints([...this.markersOf[index]], 1e-4 * this.size);
    if (points.length < 3 && part.mass > 0) points.push(...distinctPoints([centre], 0));
    const distinct = distinctPoints(points, 1e-4 * this.size);
    this.addLinks(index, distinct, color);
    this.addEllipsoid(index, part, centre, extent(distinct), color);
  }

  private addLinks(index: number, points: Vector3[], color: Color): void {
    const { id } = this.motion.results.report.parts[index];
    const frame = this.motion.partFrames[index];
    const thickness = Math.min(0.009 * this.size, Math.max(0.002 * this.size, 0.05 * extent(points)));
    for (const [a, b] of shortestTree(points)) {
      const local = between(points[a], points[b], thickness);
      if (local) this.batch.add({ id, kind: 'LINK', color, geometry: 'rod', frame, local }, this.geometries.rod);
    }
  }

  private addEllipsoid(index: number, part: Part, centre: Vector3, reach: number, color: Color): void {
    const ellipsoid = inertiaEllipsoid(part.mass, part.inertia);
    const smallest = 0.012 * this.size;
    // An ellipsoid far larger than the part's markers are apart would hide the mechanism.
    const largest = Math.max(reach, 0.08 * this.size);
    const half = ellipsoid?.halfAxes ?? [smallest, smallest, smallest];
    const shrink = Math.min(1, (0.5 * largest) / Math.max(...half));
    const [x, y, z] = half.map((axis) => Math.max(axis * shrink, 0.4 * smallest));
    const local = new Matrix4().setPosition(centre).multiply(ellipsoid?.axes ?? new Matrix4()).multiply(scaling(x, y, z));
    const item = { id: part.id, kind: 'INERTIA', color, geometry: 'ball', frame: this.motion.partFrames[index], local };
    this.batch.add(item, this.geometries.ball);
  }
}

function extent(points: Vector3[]): number {
  let largest = 0;
  for (const a of points) for (const b of points) largest = Math.max(largest, a.distanceTo(b));
  return largest;
}
