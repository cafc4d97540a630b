// SPDX-License-Identifier: Apache-2.0
// Things drawn many times: one InstancedMesh for each geometry, one matrix for each item.
import {
  BufferGeometry, Color, DoubleSide, FrontSide, Group, InstancedMesh, Intersection, Material, Matrix4, MeshLambertMaterial,
} from 'three';
import { Merged } from './merged';
import { runsOnProcessor } from './processor';

export interface Item {
  /** What is selected by a click on the item. */
  id: string;
  kind: string;
  /** Items of more than one id, such as a graphic of a part, are highlighted with each. */
  alsoOf?: string;
  geometry: string;
  color: Color;
  /** Either fixed in a frame, … */
  frame?: Matrix4;
  local?: Matrix4;
  /** … or placed anew at each moment; false hides it. */
  place?: (out: Matrix4) => boolean;
}

export interface Placed {
  item: Item;
  mesh: InstancedMesh;
  index: number;
}

const hidden = new Matrix4().makeScale(0, 0, 0);

export class Batch {
  readonly group = new Group();
  private readonly items: Item[] = [];
  private readonly geometries = new Map<string, BufferGeometry>();
  private placed: Placed[] = [];
  private meshes: { mesh: InstancedMesh; items: Item[]; merged: Merged | null }[] = [];
  private readonly hiddenIds = new Set<string>();

  constructor(private readonly makeMaterial: () => Material = () => new MeshLambertMaterial()) {}

  add(item: Item, make: () => BufferGeometry): void {
    if (!this.geometries.has(item.geometry)) this.geometries.set(item.geometry, make());
    this.items.push(item);
  }

  build(): void {
    for (const [name, geometry] of this.geometries) {
      const items = this.items.filter((item) => item.geometry === name);
      const material = this.makeMaterial();
      material.side = geometry.userData.open ? DoubleSide : FrontSide;
      if (geometry.hasAttribute('color')) material.vertexColors = true;
      const mesh = new InstancedMesh(geometry, material, items.length);
      mesh.frustumCulled = false;
      items.forEach((item, index) => {
        mesh.setColorAt(index, item.color);
        this.placed.push({ item, mesh, index });
      });
      const merged = runsOnProcessor() ? new Merged(mesh, material) : null;
      merged?.paint();
      this.meshes.push({ mesh, items, merged });
      this.group.add(mesh, ...(merged ? [merged.mesh] : []));
    }
  }

  /** Brings all instances to where their frames are now. */
  update(): void {
    const world = new Matrix4();
    for (const { mesh, items, merged } of this.meshes) {
      items.forEach((item, index) => {
        const shown = this.placeItem(item, world);
        (shown ? world : hidden).toArray(mesh.instanceMatrix.array, 16 * index);
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;
      merged?.place();
    }
  }

  recolor(colorOf: (item: Item, out: Color) => Color): void {
    const color = new Color();
    for (const { item, mesh, index } of this.placed) mesh.setColorAt(index, colorOf(item, color));
    for (const { mesh, merged } of this.meshes) {
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
      merged?.paint();
    }
  }

  hide(id: string, hide: boolean): void {
    if (hide) this.hiddenIds.add(id);
    else this.hiddenIds.delete(id);
  }

  /** Whether the instance is to be seen: not hidden, and with ends that differ. */
  isPlaced({ item, mesh, index }: Placed): boolean {
    return !this.hiddenIds.has(item.id) && this.hasSize(mesh, index);
  }

  all(): readonly Placed[] {
    return this.placed;
  }

  itemOf(hit: Intersection): Item | undefined {
    const entry = this.meshes.find(({ mesh }) => mesh === hit.object);
    return hit.instanceId === undefined ? undefined : entry?.items[hit.instanceId];
  }

  private hasSize(mesh: InstancedMesh, index: number): boolean {
    const { array } = mesh.instanceMatrix;
    return [0, 1, 2].some((k) => array[16 * index + k] !== 0);
  }

  private placeItem(item: Item, out: Matrix4): boolean {
    if (this.hiddenIds.has(item.id)) return false;
    if (item.place) return item.place(out);
    out.multiplyMatrices(item.frame!, item.local!);
    return true;
  }
}
