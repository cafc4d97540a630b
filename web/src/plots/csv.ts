// SPDX-License-Identifier: Apache-2.0
import type { Column } from '../data/columns';
import { sameTimes } from './data';

function cell(text: string): string {
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

// JavaScript writes the fewest digits that give the same number again.
function number(value: number): string {
  if (Number.isFinite(value)) return String(value);
  return Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf';
}



/** The curves with all digits. Where their times differ, each block of rows has the values of one set of times. */
export function toCsv(columns: Column[]): string {
  const lines = [['time', ...columns.map((column) => cell(column.name))].join(',')];
  const groups: Column[][] = [];
  for (const column of columns) {
    const group = groups.find(([first]) => sameTimes(first.time, column.time));
    if (group) group.push(column);
    else groups.push([column]);
  }
  for (const group of groups) {
    group[0].time.forEach((t, row) => {
      const values = columns.map((column) => (group.includes(column) ? number(column.values()[row]) : ''));
      lines.push([number(t), ...values].join(','));
    });
  }
  return lines.join('\n') + '\n';
}
