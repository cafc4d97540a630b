// SPDX-License-Identifier: Apache-2.0
import { Matrix4, Vector3 } from 'three';

type Rows = number[][];

/** Eigenvalues and unit eigenvectors (columns) of a symmetric matrix by Jacobi's rotations. */
export function eigenSymmetric(matrix: Rows): { values: number[]; vectors: Rows } {
  const a = matrix.map((row) => [...row]);
  const v: Rows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 20; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) rotate(a, v, p, q);
  }
  return { values: [a[0][0], a[1][1], a[2][2]], vectors: v };
}

function rotate(a: Rows, v: Rows, p: number, q: number): void {
  if (Math.abs(a[p][q]) < 1e-300) return;
  const theta = 0.5 * Math.atan2(2 * a[p][q], a[q][q] - a[p][p]);
  const c = Math.cos(theta);
  const s = Math.sin(theta);
  for (let k = 0; k < 3; ++k) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
  for (let k = 0; k < 3; ++k) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
  for (let k = 0; k < 3; ++k) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
}

/** Axes and half axes of the homogeneous ellipsoid of this mass and inertia; null if there is none. */
export function inertiaEllipsoid(mass: number, inertia: number[]): { axes: Matrix4; halfAxes: number[] } | null {
  if (!(mass > 0) || !inertia.every(Number.isFinite)) return null;
  const [xx, yy, zz, xy, xz, yz] = inertia;
  const { values, vectors } = eigenSymmetric([[xx, -xy, -xz], [-xy, yy, -yz], [-xz, -yz, zz]]);
  const trace = values[0] + values[1] + values[2];
  const halfAxes = values.map((value) => Math.sqrt(Math.max(0, (2.5 * (trace - 2 * value)) / mass)));
  const largest = Math.max(...halfAxes);
  if (!(largest > 0) || !Number.isFinite(largest)) return null;
  const [x, y, z] = [0, 1, 2].map((k) => new Vector3(vectors[0][k], vectors[1][k], vectors[2][k]));
  if (x.clone().cross(y).dot(z) < 0) z.negate();
  return { axes: new Matrix4().makeBasis(x, y, z), halfAxes: halfAxes.map((half) => Math.max(half, largest / 20)) };
}
