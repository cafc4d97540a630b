// SPDX-License-Identifier: Apache-2.0
import { Box3, Vector3 } from 'three';
import type { Motion } from '../data/motion';

const lengths = ['length', 'radius', 'top', 'bottom', 'x', 'y', 'z', 'xscale', 'yscale', 'zscale', 'major'];

/** How large the mechanism is at its start: the measure of symbols, arrows and lines. */
export function modelSize(motion: Motion): number {
  const { parts, elements, graphics } = motion.results.report;
  const box = new Box3();
  const point = new Vector3();
  parts.forEach((part, index) => {
    if (part.ground || !part.cm.every(Number.isFinite)) return;
    box.expandByPoint(point.set(part.cm[0], part.cm[1], part.cm[2]).applyMatrix4(motion.partFrames[index]));
  });
  for (const { i, j } of elements) {
    for (const id of [i, j]) if (id) box.expandByPoint(point.setFromMatrixPosition(motion.markerFrame(id)));
  }
  for (const body of motion.results.flexible) {
    for (let k = 0; k < body.points.length; k += 3) {
      box.expandByPoint(point.fromArray(body.points, k).applyMatrix4(motion.partFrames[body.part]));
    }
  }
  const diagonal = box.isEmpty() ? 0 : box.getSize(point).length();
  const largest = graphics.reduce((most, g) => Math.max(most, ...lengths.map((name) => Math.abs(g.values?.[name] ?? 0))), 0);
  return Math.max(diagonal, largest) || 1;
}
