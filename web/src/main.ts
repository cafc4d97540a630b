// SPDX-License-Identifier: Apache-2.0
import { App } from './app';
import { Columns } from './data/columns';
import type { Report } from './data/contract';
import { loadResults, type Results } from './data/load';
import { words } from './data/numbers';
import { findPeaks } from './data/peaks';
import { firstPlots } from './plots/firstPage';
import { PlotPanel } from './plots/panel';
import { Model } from './scene/model';
import { testInterface } from './testInterface';
import { Card } from './ui/card';
import { make } from './ui/dom';
import { listenToKeys } from './ui/keyboard';
import { Largest } from './ui/largest';
import { Picture } from './ui/picture';
import { runText } from './ui/run';
import { Show } from './ui/show';
import { Tabs } from './ui/tabs';
import { TimeBar } from './ui/timeBar';
import { Tree } from './ui/tree';

const mostPartsPlayedUnasked = 300;

function describer(report: Report): (id: string | null) => string {
  const partOf = new Map(report.markers.map(({ id, part }) => [id, report.parts[part]?.id ?? '']));
  const ground = report.parts.find((part) => part.ground)?.id ?? 'ground';
  const elements = new Map(report.elements.map((element) => [element.id, element]));
  const parts = new Map(report.parts.map((part) => [part.id, part]));
  return (id) => {
    const element = elements.get(id ?? '');
    const part = parts.get(id ?? '');
    if (part) return part.ground ? 'ground' : `part, ${Number(part.mass.toPrecision(5))} ${report.units.mass}`;
    if (!element) return id?.startsWith('MARKER/') ? `marker of ${partOf.get(Number(id.slice(7))) ?? ground}` : '';
    const ends = [element.i, element.j].map((marker) => partOf.get(marker) ?? ground);
    return `${words(element.type || element.kind)}, ${ends.join(' – ')}`;
  };
}

function makePicture(app: App, results: Results, columns: Columns): Picture | Error {
  try {
    return new Picture(app, new Model(results, columns), results.report.title);
  } catch (error) {
    return error as Error;
  }
}

function header(report: Report, openRun: () => void): HTMLElement {
  const warnings = report.text.warnings?.length ?? 0;
  const freedoms = report.text.freedoms;
  const facts = [report.text.file, freedoms === null || freedoms === undefined ? '' : `${freedoms} degree${freedoms === 1 ? '' : 's'} of freedom`];
  return make('header', { className: 'page-head' },
    make('h1', {}, report.title),
    make('span', { className: 'facts' }, facts.filter(Boolean).join(' · ')),
    warnings > 0 && make('button', { type: 'button', className: 'badge', onclick: openRun }, `${warnings} warning${warnings === 1 ? '' : 's'}`));
}

function buildPage(root: HTMLElement, results: Results): void {
  const { report } = results;
  const columns = new Columns(results);
  const peaks = findPeaks(columns);
  const describe = describer(report);
  const app = new App(results.time, report.units.time);
  const picture = makePicture(app, results, columns);
  const drawn = picture instanceof Error ? null : picture;
  const plots = new PlotPanel(app, columns, report.units.time, report.title);
  const largest = new Largest(app, report.units.time, peaks, describe, (column) => plots.show(column));
  const card = new Card(app, columns, drawn?.model ?? null, { describe, plot: (column) => plots.addCurve(column), changed: () => drawn?.viewer.invalidate() });
  drawn?.element.append(card.element);
  const show = drawn ? [{ name: 'Show', content: new Show(drawn.model, drawn.viewer, report.units.length).element }] : [];
  const tabs = new Tabs([
    { name: 'Largest values', content: largest.element },
    { name: 'Model', content: new Tree(app, report).element },
    ...show,
    { name: 'Run', content: runText(report) },
  ]);
  const failed = make('p', { className: 'empty' }, `The picture needs WebGL: ${picture instanceof Error ? picture.message : ''}`);
  document.title = `${report.title} – jprim`;
  root.replaceChildren(
    header(report, () => tabs.open(show.length + 2)),
    make('main', {}, drawn?.element ?? failed, new TimeBar(app, report.units.time).element, plots.element),
    tabs.element,
  );
  for (const curves of firstPlots(columns, peaks, report.parts.length)) plots.addPlot(curves);
  listenToKeys(app, drawn?.viewer ?? null, () => plots.search.input.focus());
  drawn?.viewer.resize(drawn.element.clientWidth, drawn.element.clientHeight);
  drawn?.viewer.first();
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (drawn && !calm && report.parts.length <= mostPartsPlayedUnasked) app.play(true);
  Object.assign(window.jprim, testInterface(app, columns, plots, drawn));
}

async function start(): Promise<void> {
  const root = document.getElementById('app')!;
  try {
    const results = await loadResults();
    if (results) buildPage(root, results);
    else root.replaceChildren(make('p', { className: 'empty' }, 'This page has no data. jprim run MODEL --report FILE.html writes one that has.'));
  } catch (error) {
    root.replaceChildren(make('p', { className: 'empty' }, `The data cannot be shown: ${(error as Error).message}`));
    throw error;
  }
}

window.jprim = { ready: start() };
