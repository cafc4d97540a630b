// SPDX-License-Identifier: Apache-2.0
import type { Column, Columns, Load } from './columns';

export interface Peak {
  column: Column;
  label: string;
  value: number;
  time: number;
}

export interface Peaks {
  forces: Peak[];
  torques: Peak[];
  requests: Peak[];
}

/** The value of largest magnitude of a column, and when it is first reached. */
export function peakOf(column: Column, label = column.name): Peak {
  const values = column.values();
  let best = -1;
  for (let k = 0; k < values.length; ++k) {
    if (Number.isFinite(values[k]) && (best < 0 || Math.abs(values[k]) > Math.abs(values[best]))) best = k;
  }
  return best < 0 ? { column, label, value: NaN, time: NaN } : { column, label, value: values[best], time: column.time[best] };
}

const bySize = (a: Peak, b: Peak) => b.value - a.value;

// The load on J has the force on I reversed: it is listed only where it is another one.
function distinct(peaks: Peak[]): Peak[] {
  const kept: Peak[] = [];
  const largest = new Map<string | null, Peak[]>();
  for (const peak of peaks) {
    const before = largest.get(peak.column.element) ?? [];
    const same = before.some((p) => Math.abs(p.value - peak.value) <= 1e-6 * Math.abs(p.value) && p.time === peak.time);
    if (same && peak.column.element) continue;
    largest.set(peak.column.element, [...before, peak]);
    kept.push(peak);
  }
  return kept;
}

function ofLoads(loads: Load[], which: 'force' | 'torque'): Peak[] {
  const peaks = loads.map((load) => peakOf(load[which], load.name.replace(/\.([IJ])$/, ' on $1'))).filter((peak) => Number.isFinite(peak.value));
  const overall = Math.max(0, ...peaks.map((peak) => peak.value));
  return distinct(peaks.filter((peak) => peak.value > 1e-9 * overall)).sort(bySize);
}

export function findPeaks(columns: Columns): Peaks {
  return {
    forces: ofLoads(columns.loads, 'force'),
    torques: ofLoads(columns.loads, 'torque'),
    requests: columns.all.filter((column) => column.table === 'requests').map((column) => peakOf(column)),
  };
}
