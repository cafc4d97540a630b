// SPDX-License-Identifier: Apache-2.0
import { Matrix4, Quaternion, Vector3 } from 'three';

const zAxis = new Vector3(0, 0, 1);

/** The frame at a whose z axis leads to b, scaled by the thickness across and by the distance along. */
export function between(a: Vector3, b: Vector3, thickness: number, out = new Matrix4()): Matrix4 | null {
  const direction = new Vector3().subVectors(b, a);
  const length = direction.length();
  if (!(length > 1e-12 * (1 + a.length()))) return null;
  return along(a, direction.divideScalar(length), thickness, length, out);
}

/** The same from a direction of length 1. */
export function along(origin: Vector3, direction: Vector3, thickness: number, length: number, out = new Matrix4()): Matrix4 {
  const rotation = new Quaternion().setFromUnitVectors(zAxis, direction);
  return out.compose(origin, rotation, new Vector3(thickness, thickness, length));
}

export function positionOf(frame: Matrix4): Vector3 {
  return new Vector3().setFromMatrixPosition(frame);
}

export const scaling = (x: number, y: number, z: number) => new Matrix4().makeScale(x, y, z);

export const shifted = (x: number, y: number, z: number) => new Matrix4().makeTranslation(x, y, z);
