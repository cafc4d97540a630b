// SPDX-License-Identifier: Apache-2.0
// What is to be read about the run.
import type { Report } from '../data/contract';
import { make } from './dom';

const keys: [string, string][] = [
  ['Space', 'play or pause'],
  ['← →', 'one output step back or on; with Shift ten'],
  ['Home End', 'first or last moment'],
  ['F', 'fit the picture'],
  ['1 2 3 4', 'view from the corner, front, right, top; again: from the other side'],
  ['/', 'add a curve'],
  ['Esc', 'select nothing'],
  ['Drag', 'orbit; right button or two fingers: pan; wheel: zoom'],
  ['Plot', 'drag to zoom, double-click to see all, click to go to a moment'],
];

function section(title: string, ...content: (Node | string | null)[]): HTMLElement | null {
  const children = content.filter((child) => child !== null);
  return children.length === 0 ? null : make('section', {}, make('h3', {}, title), ...children);
}

function lines(texts: string[] | undefined): HTMLElement | null {
  return texts && texts.length > 0 ? make('pre', {}, texts.join('\n')) : null;
}

function pairs(rows: [string, string][] | undefined): HTMLElement | null {
  if (!rows || rows.length === 0) return null;
  return make('dl', {}, ...rows.flatMap(([name, value]) => [make('dt', {}, name), make('dd', {}, value)]));
}

function folded(title: string, text: string): HTMLElement {
  return make('details', {}, make('summary', {}, title), make('pre', { tabIndex: 0 }, text));
}

function warnings(report: Report): HTMLElement | null {
  const messages = report.text.warnings ?? [];
  if (messages.length === 0) return null;
  const item = ({ severity, where, message }: (typeof messages)[number]) =>
    make('li', { className: severity }, make('strong', {}, severity), ' ', where ? make('code', {}, where) : '', ' ', message);
  return make('ul', { className: 'messages' }, ...messages.map(item));
}

function overview(report: Report): HTMLElement | null {
  const { text, parts, units, elements } = report;
  const count = (n: number, word: string) => `${n} ${word}${n === 1 ? '' : 's'}`;
  const joints = elements.filter((element) => !element.isForce && element.kind !== 'REQUEST').length;
  const rows: [string, string][] = [
    ['Dataset', text.file ?? ''],
    ['Size', `${count(parts.filter((part) => !part.ground).length, 'part')}, ${count(joints, 'constraint')}`],
    ['Degrees of freedom', text.freedoms === null || text.freedoms === undefined ? '' : String(text.freedoms)],
    ['Units', `${units.length}, ${units.force}, ${units.mass}, ${units.time}; angles in rad`],
  ];
  return pairs(rows.filter(([, value]) => value !== ''));
}

export function runText(report: Report): HTMLElement {
  const { text } = report;
  const licences = document.getElementById('third-party-licences') as HTMLTemplateElement | null;
  const sections = [
    section('Model', overview(report)),
    section('Warnings', warnings(report)),
    section('Summary', lines(text.summary)),
    section('Analysis', lines(text.analysis)),
    section('Options', pairs(text.options)),
    section('Dataset', text.dataset ? folded(text.file ?? 'Text', text.dataset) : null),
    section('Keys and mouse', pairs(keys)),
    section('Made with', pairs(text.versions), licences ? folded('Licences of three and uPlot', licences.content.textContent ?? '') : null),
  ];
  return make('div', { className: 'run' }, ...sections);
}
