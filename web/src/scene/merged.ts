// SPDX-License-Identifier: Apache-2.0
// All instances of a mesh as one geometry. Where WebGL runs on the processor, each instance is a draw of its own that
// costs far more than its triangles.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, type InstancedMesh, type Material, Mesh } from 'three';

/** The layer of meshes that are there to be picked and read, and not drawn. */
export const undrawnLayer = 1;

export class Merged {
  readonly mesh: Mesh;
  private readonly points: ArrayLike<number>;
  private readonly normals: ArrayLike<number>;
  private readonly tints: ArrayLike<number> | null;
  private readonly vertices: number;

  constructor(private readonly instances: InstancedMesh, material: Material) {
    const { geometry, count } = instances;
    this.points = geometry.getAttribute('position').array;
    this.normals = geometry.getAttribute('normal').array;
    this.tints = geometry.hasAttribute('color') ? geometry.getAttribute('color').array : null;
    this.vertices = this.points.length / 3;
    const merged = new BufferGeometry().setIndex(repeatedIndex(geometry, this.vertices, count));
    for (const name of ['position', 'normal', 'color']) {
      const array = new Float32Array(this.points.length * count);
      merged.setAttribute(name, new BufferAttribute(array, 3).setUsage(DynamicDrawUsage));
    }
    material.vertexColors = true;
    this.mesh = new Mesh(merged, material);
    this.mesh.frustumCulled = false;
    this.mesh.raycast = () => undefined;
    instances.layers.set(undrawnLayer);
  }

  /** Follows the matrices of the instances. */
  place(): void {
    const { array: matrices } = this.instances.instanceMatrix;
    const [position, normal] = [this.attribute('position'), this.attribute('normal')];
    for (let k = 0; k < this.instances.count; ++k) {
      const at = 3 * this.vertices * k;
      transform(matrices, 16 * k, this.points, position.array as Float32Array, at, [1, 1, 1], 1);
      transform(matrices, 16 * k, this.normals, normal.array as Float32Array, at, inverseSquares(matrices, 16 * k), 0);
    }
    position.needsUpdate = true;
    normal.needsUpdate = true;
  }

  /** Follows the colours of the instances. */
  paint(): void {
    const colors = this.instances.instanceColor!.array;
    const color = this.attribute('color');
    for (let k = 0; k < this.instances.count * this.vertices; ++k) {
      const [instance, vertex] = [Math.floor(k / this.vertices), k % this.vertices];
      for (let c = 0; c < 3; ++c) color.array[3 * k + c] = colors[3 * instance + c] * (this.tints ? this.tints[3 * vertex + c] : 1);
    }
    color.needsUpdate = true;
  }

  private attribute(name: string): BufferAttribute {
    return this.mesh.geometry.getAttribute(name) as BufferAttribute;
  }
}

function repeatedIndex(geometry: BufferGeometry, vertices: number, count: number): BufferAttribute {
  const one = geometry.index?.array ?? Uint32Array.from({ length: vertices }, (_, k) => k);
  const index = new Uint32Array(one.length * count);
  for (let k = 0; k < index.length; ++k) index[k] = one[k % one.length] + vertices * Math.floor(k / one.length);
  return new BufferAttribute(index, 1);
}

// Normals of what is scaled differently along its axes.
function inverseSquares(m: ArrayLike<number>, o: number): number[] {
  return [0, 4, 8].map((c) => {
    const square = m[o + c] ** 2 + m[o + c + 1] ** 2 + m[o + c + 2] ** 2;
    return square > 0 ? 1 / square : 0;
  });
}

function transform(
  m: ArrayLike<number>, o: number, from: ArrayLike<number>, to: Float32Array, at: number, [sx, sy, sz]: number[], shift: number,
): void {
  const [xx, xy, xz] = [sx * m[o], sx * m[o + 1], sx * m[o + 2]];
  const [yx, yy, yz] = [sy * m[o + 4], sy * m[o + 5], sy * m[o + 6]];
  const [zx, zy, zz] = [sz * m[o + 8], sz * m[o + 9], sz * m[o + 10]];
  const [tx, ty, tz] = [shift * m[o + 12], shift * m[o + 13], shift * m[o + 14]];
  for (let k = 0; k < from.length; k += 3) {
    const [x, y, z] = [from[k], from[k + 1], from[k + 2]];
    to[at + k] = xx * x + yx * y + zx * z + tx;
    to[at + k + 1] = xy * x + yy * y + zy * z + ty;
    to[at + k + 2] = xz * x + yz * y + zz * z + tz;
  }
}
