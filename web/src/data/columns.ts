// SPDX-License-Identifier: Apache-2.0
// All curves that can be plotted: columns of the tables, magnitudes of loads, and poses of parts.
import type { Results, Table } from './load';

export interface Column {
  table: string;
  name: string;
  unit: string;
  element: string | null;
  time: Float64Array;
  values(): Float64Array;
}

/** Six columns FX FY FZ TX TY TZ that stand together. */
export interface Load {
  name: string;
  element: string | null;
  first: number;
  table: Table;
  force: Column;
  torque: Column;
}

const loadSuffixes = ['FX', 'FY', 'FZ', 'TX', 'TY', 'TZ'];

export function columnValues(table: Table, column: number): Float64Array {
  const rows = table.time.length;
  return table.data.subarray(column * rows, (column + 1) * rows);
}

function lazily(make: () => Float64Array): () => Float64Array {
  let values: Float64Array | undefined;
  return () => (values ??= make());
}

function magnitude(table: Table, first: number): Float64Array {
  const [x, y, z] = [0, 1, 2].map((k) => columnValues(table, first + k));
  const values = new Float64Array(x.length);
  for (let k = 0; k < values.length; ++k) values[k] = Math.sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
  return values;
}

function tableColumn(table: Table, index: number): Column {
  const { name, unit, element } = table.columns[index];
  return { table: table.name, name, unit, element, time: table.time, values: () => columnValues(table, index) };
}

function magnitudeColumn(table: Table, first: number, name: string): Column {
  const { unit, element } = table.columns[first];
  return { table: table.name, name, unit, element, time: table.time, values: lazily(() => magnitude(table, first)) };
}

function loadAt(table: Table, first: number): Load | null {
  const prefix = table.columns[first].name.slice(0, -2);
  const complete = loadSuffixes.every((suffix, k) => table.columns[first + k]?.name === prefix + suffix);
  if (!complete) return null;
  return {
    name: prefix.replace(/[._]$/, ''),
    element: table.columns[first].element,
    first,
    table,
    force: magnitudeColumn(table, first, prefix + 'FM'),
    torque: magnitudeColumn(table, first + 3, prefix + 'TM'),
  };
}

function findLoads(tables: Table[]): Load[] {
  const loads: Load[] = [];
  for (const table of tables.filter((t) => t.name === 'reactions')) {
    for (let k = 0; k < table.columns.length; ++k) {
      const load = table.columns[k].name.endsWith('FX') ? loadAt(table, k) : null;
      if (load) loads.push(load);
    }
  }
  return loads;
}

const poseNames = ['X', 'Y', 'Z', 'E0', 'E1', 'E2', 'E3'];

function poseColumns(results: Results): Column[] {
  const { parts, units } = results.report;
  const width = parts.length * 7;
  const column = (part: number, k: number): Column => ({
    table: 'frames',
    name: `${parts[part].id}.${poseNames[k]} (origin)`,
    unit: k < 3 ? units.length : '',
    element: parts[part].id,
    time: results.time,
    values: lazily(() => Float64Array.from(results.time, (_, row) => results.poses[row * width + part * 7 + k])),
  });
  return parts.flatMap((part, index) => (part.ground ? [] : poseNames.map((_, k) => column(index, k))));
}

export class Columns {
  readonly all: Column[];
  readonly loads: Load[];

  constructor(results: Results) {
    this.loads = findLoads(results.tables);
    const hasParts = results.tables.some((table) => table.name === 'parts' && table.columns.length > 0);
    this.all = [
      ...this.loads.flatMap((load) => [load.force, load.torque]),
      ...results.tables.flatMap((table) => table.columns.map((_, index) => tableColumn(table, index))),
      ...(hasParts ? [] : poseColumns(results)),
    ];
  }

  find(table: string, name: string): Column | undefined {
    return this.all.find((column) => column.table === table && column.name === name);
  }

  /** Columns whose name, element or table hold every word that was typed. */
  search(typed: string, limit: number): Column[] {
    const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
    const found: Column[] = [];
    for (const column of this.all) {
      const text = `${column.name} ${column.element ?? ''} ${column.table} ${column.unit}`.toLowerCase();
      if (words.every((word) => text.includes(word))) found.push(column);
      if (found.length >= limit) break;
    }
    return found;
  }

  ofElement(id: string): Column[] {
    return this.all.filter((column) => column.element === id);
  }
}

/** Row k with time[k] <= t < time[k + 1], and how far t is on the way to the next. */
export function locate(time: ArrayLike<number>, t: number): { row: number; fraction: number } {
  const last = time.length - 1;
  if (last < 1 || t <= time[0]) return { row: 0, fraction: 0 };
  if (t >= time[last]) return { row: last, fraction: 0 };
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= t) low = middle;
    else high = middle;
  }
  return { row: low, fraction: (t - time[low]) / (time[high] - time[low]) };
}

export function valueAt(column: { time: Float64Array; values(): Float64Array }, t: number): number {
  const values = column.values();
  const { row, fraction } = locate(column.time, t);
  return fraction === 0 ? values[row] : values[row] + fraction * (values[row + 1] - values[row]);
}
