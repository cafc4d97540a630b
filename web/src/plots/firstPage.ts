// SPDX-License-Identifier: Apache-2.0
// What is plotted before anybody asks.
import type { Column, Columns } from '../data/columns';
import type { Peaks } from '../data/peaks';

const mostCurves = 4;

function span(column: Column): number {
  let [low, high] = [Infinity, -Infinity];
  for (const value of column.values()) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return high - low;
}

function varies(column: Column): boolean {
  const size = column.values().reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return span(column) > 1e-9 * size;
}

// The first request that has something to show, in at most two units.
function firstRequest(columns: Columns): Column[] {
  const requests = columns.all.filter((column) => column.table === 'requests');
  const elements = [...new Set(requests.map((column) => column.element ?? column.name))];
  for (const element of elements) {
    const shown = requests.filter((column) => (column.element ?? column.name) === element && varies(column));
    const units = [...new Set(shown.map((column) => column.unit))].slice(0, 1);
    if (shown.length > 0) return shown.filter((column) => units.includes(column.unit)).slice(0, mostCurves);
  }
  return [];
}

const isPosition = /(\.|_)[XYZ]( \(origin\))?$/;

// Of each part, the coordinate that changes most.
function mostMoving(columns: Columns, partCount: number): Column[] {
  const positions = columns.all.filter((column) => ['parts', 'frames'].includes(column.table) && isPosition.test(column.name));
  if (partCount > 200) return positions.slice(0, 3);
  const best = new Map<string | null, { column: Column; span: number }>();
  for (const column of positions) {
    const candidate = { column, span: span(column) };
    if (candidate.span > (best.get(column.element)?.span ?? -1)) best.set(column.element, candidate);
  }
  return [...best.values()].sort((a, b) => b.span - a.span).slice(0, 3).map(({ column }) => column);
}

export function firstPlots(columns: Columns, peaks: Peaks, partCount: number): Column[][] {
  const energy = columns.all.filter((column) => column.table === 'energy');
  const isError = (column: Column) => /error|violation/i.test(column.name);
  const request = firstRequest(columns);
  const largest = peaks.forces.slice(0, 3).map((peak) => peak.column);
  const plots = [
    request.length > 0 ? request : mostMoving(columns, partCount),
    largest,
    energy.filter((column) => !isError(column)).slice(0, mostCurves),
    energy.filter(isError).slice(0, 2),
  ];
  return plots.filter((plot) => plot.length > 0);
}
