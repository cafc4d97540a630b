// SPDX-License-Identifier: Apache-2.0
import uPlot from 'uplot';
import type { Column } from '../data/columns';

export const sameTimes = (a: Float64Array, b: Float64Array) => a === b || (a.length === b.length && a.every((t, k) => t === b[k]));

// Infinite values and those that are no numbers leave a gap.
function finite(values: Float64Array): ArrayLike<number | null> {
  return values.every(Number.isFinite) ? values : Array.from(values, (value) => (Number.isFinite(value) ? value : null));
}

/** Curves with one row of times for all, as uPlot needs it. */
export function alignedData(columns: Column[]): uPlot.AlignedData {
  const [first] = columns;
  if (columns.every((column) => sameTimes(column.time, first.time))) {
    return [first.time, ...columns.map((column) => finite(column.values()))] as unknown as uPlot.AlignedData;
  }
  const tables = columns.map((column) => [Array.from(column.time), Array.from(finite(column.values()))]);
  return uPlot.join(tables as uPlot.AlignedData[]);
}
