// SPDX-License-Identifier: Apache-2.0
// Many links that hang on each other and swing.
import { Blocks } from './page.mjs';

const suffixes = ['FX', 'FY', 'FZ', 'TX', 'TY', 'TZ'];

export function chain(count, rows, end = 10) {
  const blocks = new Blocks(false);
  const times = Float64Array.from({ length: rows }, (_, k) => (k * end) / (rows - 1));
  const perRow = Math.ceil(Math.sqrt(count));
  const poses = new Float32Array(rows * (count + 1) * 7);
  for (let row = 0; row < rows; ++row) {
    for (let part = 0; part <= count; ++part) {
      const angle = part === 0 ? 0 : 0.5 * Math.sin(2 * times[row] + part);
      const pose = [part % perRow, -Math.floor(part / perRow), 0.3 * Math.sin(part), Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)];
      poses.set(part === 0 ? [0, 0, 0, 1, 0, 0, 0] : pose, (row * (count + 1) + part) * 7);
    }
  }
  const parts = Array.from({ length: count + 1 }, (_, k) => ({
    id: `PART/${k + 1}`, ground: k === 0, mass: k ? 1 : 0, cm: [0.3, 0, 0], inertia: [0.002, 0.02, 0.02, 0, 0, 0], parent: k ? `PART/${k}` : null, joint: k ? 'REVOLUTE' : null,
  }));
  const markers = parts.flatMap((_, k) => [{ id: 10 * k + 1, part: k, pose: [0, 0, 0, 1, 0, 0, 0] }, { id: 10 * k + 2, part: k, pose: [0.6, 0, 0, 1, 0, 0, 0] }]);
  const elements = Array.from({ length: count }, (_, k) => ({
    id: `JOINT/${k + 1}`, kind: 'JOINT', type: 'REVOLUTE', i: 10 * (k + 1) + 1, j: 10 * k + 2, isForce: false, loadOnI: 6 * k,
  }));
  const columns = elements.flatMap(({ id }) => suffixes.map((s, k) => ({ name: `${id}.I.${s}`, unit: k < 3 ? 'N' : 'N m', element: id })));
  const data = new Float64Array(columns.length * rows);
  for (let k = 0; k < data.length; ++k) data[k] = Math.sin(k * 0.37) * (1 + Math.floor(k / rows));
  const report = {
    format: 1, title: `${count} links`, units: { length: 'm', force: 'N', mass: 'kg', time: 's' }, text: { file: 'chain.adm', freedoms: count }, gravity: [0, -9.81, 0],
    parts, markers, elements, graphics: [], flexible: [],
    frames: { time: blocks.array('f64', [rows], times), poses: blocks.array('f32', [rows, count + 1, 7], poses) },
    tables: [{ name: 'reactions', columns, time: blocks.array('f64', [rows], times), data: blocks.array('f64', [columns.length, rows], data) }],
  };
  return { report, blocks };
}
