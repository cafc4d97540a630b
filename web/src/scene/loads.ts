// SPDX-License-Identifier: Apache-2.0
// Forces and torques on the I markers as arrows, as long as they are large.
import { Matrix4, Vector3 } from 'three';
import { columnValues, locate, type Columns } from '../data/columns';
import type { Element } from '../data/contract';
import type { Table } from '../data/load';
import type { Motion } from '../data/motion';
import type { Batch } from './batch';
import type { Geometries } from './geometries';
import { roles } from './palette';
import { along, positionOf } from './place';

const longest = 0.22;

export class Loads {
  forceScale = 1;
  torqueScale = 1;
  largestForce = 0;
  largestTorque = 0;
  private readonly table: Table | undefined;
  private at = { row: 0, fraction: 0 };

  constructor(
    private readonly motion: Motion,
    columns: Columns,
    private readonly geometries: Geometries,
    private readonly size: number,
  ) {
    this.table = motion.results.tables.find((table) => table.name === 'reactions');
    for (const load of columns.loads) {
      this.largestForce = largest(load.force.values(), this.largestForce);
      this.largestTorque = largest(load.torque.values(), this.largestTorque);
    }
  }

  add(element: Element, forces: Batch, torques: Batch): void {
    const first = element.loadOnI;
    if (first === null || first === undefined || !this.table) return;
    const at = this.motion.markerFrame(element.i);
    const force = (out: Matrix4) => this.place(at, first, this.forceScale, this.largestForce, out);
    const torque = (out: Matrix4) => this.place(at, first + 3, this.torqueScale, this.largestTorque, out);
    const { id } = element;
    forces.add({ id, kind: 'FORCE', geometry: 'arrow', color: roles.force, place: force }, () => this.geometries.arrow());
    torques.add({ id, kind: 'TORQUE', geometry: 'arrow', color: roles.torque, place: torque }, this.geometries.doubleHeadedArrow);
  }

  setTime(t: number): void {
    if (this.table) this.at = locate(this.table.time, t);
  }

  private place(frame: Matrix4, column: number, scale: number, largestValue: number, out: Matrix4): boolean {
    const vector = new Vector3(this.value(column), this.value(column + 1), this.value(column + 2));
    const magnitude = vector.length();
    if (!(magnitude > 1e-3 * largestValue) || !Number.isFinite(magnitude)) return false;
    const length = (longest * this.size * scale * magnitude) / largestValue;
    along(positionOf(frame), vector.divideScalar(magnitude), length, length, out);
    return true;
  }

  private value(column: number): number {
    const values = columnValues(this.table!, column);
    const { row, fraction } = this.at;
    return fraction === 0 ? values[row] : values[row] + fraction * (values[row + 1] - values[row]);
  }
}

function largest(values: Float64Array, start: number): number {
  let most = start;
  for (const value of values) if (value > most && value < Infinity) most = value;
  return most;
}
