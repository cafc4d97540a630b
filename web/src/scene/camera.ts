// SPDX-License-Identifier: Apache-2.0
import { Box3, PerspectiveCamera, Vector3 } from 'three';

export const viewNames = ['iso', 'front', 'right', 'top'] as const;
export type ViewName = (typeof viewNames)[number];

/** Up is against gravity; the dataset's y axis where there is none. */
export function upFrom(gravity: number[] | undefined): Vector3 {
  const up = new Vector3(...((gravity ?? [0, 0, 0]) as [number, number, number])).negate();
  return up.lengthSq() > 0 ? nearestAxis(up.normalize()) : new Vector3(0, 1, 0);
}

function nearestAxis(direction: Vector3): Vector3 {
  const axis = new Vector3();
  direction.toArray().forEach((value, k) => Math.abs(value) > 0.999 && axis.setComponent(k, Math.sign(value)));
  return axis.lengthSq() > 0 ? axis : direction;
}

/** Right and front (towards the viewer) for an up direction: x is to the right where it can be. */
function basis(up: Vector3): { right: Vector3; front: Vector3 } {
  const x = Math.abs(up.x) > 0.9 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0);
  const right = x.addScaledVector(up, -x.dot(up)).normalize();
  return { right, front: right.clone().cross(up) };
}

/** From the middle towards the eye. */
export function viewDirection(view: ViewName, up: Vector3): Vector3 {
  const { right, front } = basis(up);
  switch (view) {
    case 'front': return front;
    case 'right': return right;
    case 'top': return up.clone();
    case 'iso': return front.multiplyScalar(1.2).add(right.multiplyScalar(0.8)).addScaledVector(up, 0.75).normalize();
  }
}

/** A first look: flat mechanisms nearly along their normal, others from the corner. */
export function firstDirection(box: Box3, up: Vector3): Vector3 {
  const size = box.getSize(new Vector3());
  const { right, front } = basis(up);
  const across = (axis: Vector3) => Math.abs(size.dot(new Vector3(...(axis.toArray().map(Math.abs) as [number, number, number]))));
  const [width, depth, height] = [right, front, up].map(across);
  const mix = (f: number, r: number, u: number) =>
    front.clone().multiplyScalar(f).addScaledVector(right, r).addScaledVector(up, u).normalize();
  if (depth < 0.35 * Math.max(width, height)) return mix(1, 0.32, 0.26);
  if (width < 0.2 * Math.max(depth, height)) return mix(0.35, 1, 0.28);
  return viewDirection('iso', up);
}

/** Places the camera so that all points are seen, from the given direction. */
export function fitPoints(camera: PerspectiveCamera, target: Vector3, points: Float32Array, direction: Vector3): void {
  const z = direction.clone().normalize();
  const x = new Vector3().crossVectors(camera.up, z);
  if (x.lengthSq() < 1e-9) x.set(1, 0, 0).addScaledVector(z, -z.x);
  x.normalize();
  const y = new Vector3().crossVectors(z, x);
  const box = boxAlong(points, [x, y, z]);
  const middle = box.getCenter(new Vector3());
  target.set(0, 0, 0).addScaledVector(x, middle.x).addScaledVector(y, middle.y).addScaledVector(z, middle.z);
  const tall = Math.tan((camera.fov * Math.PI) / 360);
  const wide = tall * camera.aspect;
  const distance = 1.1 * farEnough(points, target, [x, y, z], wide, tall);
  const radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-12);
  camera.position.copy(target).addScaledVector(z, Math.max(distance, radius * 0.1));
  camera.near = radius / 200;
  camera.far = radius * 2000;
  camera.updateProjectionMatrix();
}

function boxAlong(points: Float32Array, axes: Vector3[]): Box3 {
  const box = new Box3();
  const point = new Vector3();
  for (let k = 0; k < points.length; k += 3) {
    point.fromArray(points, k);
    box.expandByPoint(point.set(point.dot(axes[0]), point.dot(axes[1]), point.dot(axes[2])));
  }
  return box;
}

function farEnough(points: Float32Array, target: Vector3, [x, y, z]: Vector3[], wide: number, tall: number): number {
  const point = new Vector3();
  let distance = 0;
  for (let k = 0; k < points.length; k += 3) {
    point.fromArray(points, k).sub(target);
    distance = Math.max(distance, Math.max(Math.abs(point.dot(x)) / wide, Math.abs(point.dot(y)) / tall) + point.dot(z));
  }
  return distance;
}
