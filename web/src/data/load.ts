// SPDX-License-Identifier: Apache-2.0
import { Blocks } from './blocks';
import type { FlexibleData, Report } from './contract';

export interface Table {
  name: string;
  columns: { name: string; unit: string; element: string | null }[];
  time: Float64Array;
  data: Float64Array;
}

export interface Flexible {
  part: number;
  points: Float32Array;
  edges: ArrayLike<number>;
  faces: number[];
  modeCount: number;
  modes: Float32Array;
  amplitudes: Float32Array;
}

export interface Results {
  report: Report;
  time: Float64Array;
  poses: Float32Array;
  tables: Table[];
  flexible: Flexible[];
}

async function loadFlexible(blocks: Blocks, body: FlexibleData): Promise<Flexible> {
  const edges = body.edges ?? [];
  return {
    part: body.part,
    points: await blocks.floats(body.points),
    edges: Array.isArray(edges) ? edges.flat() : await blocks.numbers(edges),
    faces: (body.faces ?? []).flat(),
    modeCount: body.modes.shape[0],
    modes: await blocks.floats(body.modes),
    amplitudes: await blocks.floats(body.amplitudes),
  };
}

/** What the page was given, or null for a page without data. */
export async function loadResults(): Promise<Results | null> {
  const element = document.getElementById('jprim-report');
  if (!element) return null;
  const report = JSON.parse(element.textContent ?? '') as Report;
  if (report.format !== 1) throw new Error(`data of format ${report.format} cannot be read by this page`);
  const blocks = new Blocks();
  const table = async (data: Report['tables'][number]): Promise<Table> => ({
    name: data.name,
    columns: data.columns.map((c) => ({ name: c.name, unit: c.unit ?? '', element: c.element ?? null })),
    time: await blocks.doubles(data.time),
    data: await blocks.doubles(data.data),
  });
  return {
    report,
    time: await blocks.doubles(report.frames.time),
    poses: await blocks.floats(report.frames.poses),
    tables: await Promise.all(report.tables.map(table)),
    flexible: await Promise.all((report.flexible ?? []).map((body) => loadFlexible(blocks, body))),
  };
}
