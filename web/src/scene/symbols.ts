// SPDX-License-Identifier: Apache-2.0
// Symbols of joints, primitives and other equations: what is held in violet, what is left free in green.
import { Color, Matrix4, Quaternion, Vector3 } from 'three';
import type { Element } from '../data/contract';
import type { Motion } from '../data/motion';
import type { Batch, Item } from './batch';
import { coreOf, freedomsOf, type Freedom } from './freedoms';
import type { Geometries } from './geometries';
import { roles } from './palette';
import { scaling } from './place';

const toAxis = {
  x: new Matrix4().makeRotationFromQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(1, 0, 0))),
  y: new Matrix4().makeRotationFromQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(0, 1, 0))),
  z: new Matrix4(),
};

const cores: Record<ReturnType<typeof coreOf>, { geometry: string; make: 'box' | 'rod' | 'squareFrame' | 'smallBall'; local: Matrix4 }> = {
  cube: { geometry: 'cube', make: 'box', local: scaling(0.36, 0.36, 0.36) },
  line: { geometry: 'rod', make: 'rod', local: scaling(0.09, 0.09, 1.1).multiply(new Matrix4().makeTranslation(0, 0, -0.5)) },
  plane: { geometry: 'square', make: 'squareFrame', local: scaling(0.95, 0.95, 1) },
  ball: { geometry: 'ball', make: 'smallBall', local: scaling(0.2, 0.2, 0.2) },
};

type Make = Parameters<Batch['add']>[1];

export class Symbols {
  size = 1;

  constructor(
    private readonly motion: Motion,
    private readonly batch: Batch,
    private readonly geometries: Geometries,
  ) {}

  addElement(element: Element): void {
    const freedoms = freedomsOf(element.kind, element.type);
    if (freedoms) {
      const { geometry, make, local } = cores[coreOf(element.type)];
      this.add(element, 'core', geometry, this.geometries[make], roles.held, element.i || element.j, element.j, local);
      for (const freedom of freedoms) this.addFreedom(element, freedom);
    } else if (element.kind === 'MOTION') {
      this.add(element, 'symbol', 'round', this.geometries.roundDoubleArrow, roles.motion, element.i, element.j, scaling(0.75, 0.75, 0.75));
    } else {
      const color = element.isForce ? roles.spring : roles.held;
      this.add(element, 'symbol', 'diamond', this.geometries.diamond, color, element.i || element.j, element.j, scaling(0.24, 0.24, 0.24));
    }
  }

  addMarker(id: number, owner: string): void {
    const frame = this.motion.markerFrame(id);
    const place = (out: Matrix4) => this.placeScaled(frame, frame, scaling(0.8, 0.8, 0.8), out);
    const item: Item = { id: `MARKER/${id}`, alsoOf: owner, kind: 'MARKER', geometry: 'triad', color: roles.white, place };
    this.batch.add(item, this.geometries.triad);
  }

  private addFreedom(element: Element, freedom: Freedom): void {
    const straight = freedom.kind === 'translation';
    const marker = freedom.of === 'I' ? element.i : element.j;
    const make = straight ? this.geometries.straightDoubleArrow : this.geometries.roundDoubleArrow;
    const geometry = straight ? 'straight' : 'round';
    this.add(element, freedom.kind, geometry, make, roles.free, element.i || element.j, marker, toAxis[freedom.axis]);
  }

  // At the origin of one marker, along the axes of another.
  private add(
    element: Element, kind: string, geometry: string, make: Make, color: Color,
    at: number, axes: number, local: Matrix4,
  ): void {
    const [origin, frame] = [this.motion.markerFrame(at), this.motion.markerFrame(axes)];
    const place = (out: Matrix4) => this.placeScaled(origin, frame, local, out);
    this.batch.add({ id: element.id, kind: `${element.kind} ${kind}`, geometry, color, place }, make);
  }

  private placeScaled(origin: Matrix4, axes: Matrix4, local: Matrix4, out: Matrix4): boolean {
    const { elements } = origin;
    out.copy(axes).setPosition(elements[12], elements[13], elements[14]);
    out.multiply(scaling(this.size, this.size, this.size)).multiply(local);
    return true;
  }
}
