// SPDX-License-Identifier: Apache-2.0
// Springs, bushings and other forces between two markers, where no graphic shows them.
import { Matrix4 } from 'three';
import type { Element } from '../data/contract';
import type { Motion } from '../data/motion';
import type { Batch, Item } from './batch';
import type { Geometries } from './geometries';
import { roles } from './palette';
import { between, positionOf, scaling } from './place';

const round = { turns: 7, tube: 0.18 };

export class Springs {
  constructor(
    private readonly motion: Motion,
    private readonly batch: Batch,
    private readonly geometries: Geometries,
    private readonly size: number,
  ) {}

  /** Whether the element was one that is drawn here. */
  add(element: Element): boolean {
    const rotational = (element.type ?? '').toUpperCase() === 'ROTATIONAL';
    if (element.kind === 'BUSHING') this.addBushing(element);
    else if (element.kind === 'SPRINGDAMPER' && rotational) this.addSpiral(element);
    else if (element.kind === 'SPRINGDAMPER') this.addCoil(element);
    else if (element.kind === 'SFORCE' && !rotational) this.addLine(element);
    else return false;
    return true;
  }

  private item(element: Element, geometry: string, place: Item['place']): Item {
    return { id: element.id, kind: element.kind, geometry, color: roles.spring, place };
  }

  private line(element: Element, thickness: number): Item['place'] {
    const [i, j] = [this.motion.markerFrame(element.i), this.motion.markerFrame(element.j)];
    return (out) => between(positionOf(j), positionOf(i), thickness, out) !== null;
  }

  private addCoil(element: Element): void {
    const place = this.line(element, 0.018 * this.size);
    this.batch.add(this.item(element, 'coil', place), () => this.geometries.coil(round.turns));
  }

  private addLine(element: Element): void {
    this.batch.add(this.item(element, 'rod', this.line(element, 0.0025 * this.size)), this.geometries.rod);
  }

  private at(marker: number, scale: number): Item['place'] {
    const frame = this.motion.markerFrame(marker);
    const size = scaling(scale, scale, scale);
    return (out: Matrix4) => Boolean(out.multiplyMatrices(frame, size));
  }

  private addSpiral(element: Element): void {
    this.batch.add(this.item(element, 'spiral', this.at(element.j, 0.03 * this.size)), this.geometries.spiral);
  }

  private addBushing(element: Element): void {
    for (const [marker, scale] of [[element.i, 0.018], [element.j, 0.026]]) {
      this.batch.add(this.item(element, 'bush', this.at(marker, scale * this.size)), () => this.geometries.ring(round.tube));
    }
  }
}
