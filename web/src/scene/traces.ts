// SPDX-License-Identifier: Apache-2.0
// Paths of chosen points over the whole run.
import { Group, Vector3 } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Motion } from '../data/motion';
import { curveColor } from './palette';

export class Traces {
  readonly group = new Group();
  private readonly lines = new Map<string, Line2>();

  constructor(private readonly motion: Motion) {}

  has(id: string): boolean {
    return this.lines.has(id);
  }

  ids(): string[] {
    return [...this.lines.keys()];
  }

  /** Shows or removes the path of a part's mass centre, a marker, or the I marker of an element. */
  toggle(id: string): void {
    const line = this.lines.get(id);
    if (line) this.remove(id, line);
    else this.show(id);
  }

  private remove(id: string, line: Line2): void {
    this.group.remove(line);
    line.geometry.dispose();
    line.material.dispose();
    this.lines.delete(id);
  }

  private show(id: string): void {
    const path = this.pathOf(id);
    if (!path || path.length < 6) return;
    const geometry = new LineGeometry().setPositions(path);
    const line = new Line2(geometry, new LineMaterial({ linewidth: 2, color: curveColor(this.lines.size) }));
    line.frustumCulled = false;
    this.lines.set(id, line);
    this.group.add(line);
  }

  private pathOf(id: string): Float32Array | null {
    const { parts, elements } = this.motion.results.report;
    const part = parts.findIndex((p) => p.id === id);
    if (part >= 0) return this.motion.path(part, new Vector3(...(parts[part].cm as [number, number, number])));
    const element = elements.find((e) => e.id === id);
    const marker = this.motion.markers.get(element ? element.i || element.j : Number(id.replace('MARKER/', '')));
    return marker ? this.motion.path(marker.part, new Vector3().setFromMatrixPosition(marker.local), marker) : null;
  }
}
