// SPDX-License-Identifier: Apache-2.0
// The form of the data that is put into the page.

export interface ArrayRef {
  block: number;
  type: 'f32' | 'f64';
  shape: number[];
  deflate?: boolean;
}

export interface Message {
  severity: 'warning' | 'error';
  where?: string;
  message: string;
}

export interface ReportText {
  dataset?: string;
  file?: string;
  options?: [string, string][];
  versions?: [string, string][];
  summary?: string[];
  analysis?: string[];
  warnings?: Message[];
  freedoms?: number | null;
}

export interface Part {
  id: string;
  ground: boolean;
  mass: number;
  cm: number[];
  inertia: number[];
  parent?: string | null;
  joint?: string | null;
}

export interface MarkerData {
  id: number;
  part: number;
  pose: number[];
}

export interface Element {
  id: string;
  kind: string;
  type?: string | null;
  i: number;
  j: number;
  isForce?: boolean;
  loadOnI?: number | null;
}

export interface Graphic {
  id: string;
  shape: string;
  marker?: number;
  points?: number[];
  i?: number;
  j?: number;
  values?: Record<string, number>;
}

export interface FlexibleData {
  part: number;
  points: ArrayRef;
  edges?: ArrayRef | number[][];
  faces?: number[][];
  modes: ArrayRef;
  amplitudes: ArrayRef;
}

export interface TableData {
  name: string;
  columns: { name: string; unit?: string; element?: string | null }[];
  time: ArrayRef;
  data: ArrayRef;
}

export interface Report {
  format: number;
  title: string;
  units: { length: string; force: string; mass: string; time: string };
  text: ReportText;
  gravity?: number[];
  parts: Part[];
  markers: MarkerData[];
  elements: Element[];
  graphics: Graphic[];
  flexible?: FlexibleData[];
  frames: { time: ArrayRef; poses: ArrayRef };
  tables: TableData[];
}
