// SPDX-License-Identifier: Apache-2.0
// Parts as they hang on each other, then joints, forces and other elements, then markers.
import type { App } from '../app';
import type { Element, Part, Report } from '../data/contract';
import { words } from '../data/numbers';
import { make } from './dom';

const deepest = 8;

interface Row {
  id: string;
  text: string;
  note: string;
  depth: number;
}

export class Tree {
  readonly element = make('div', { className: 'tree' });
  private readonly filter = make('input', { type: 'search', placeholder: 'Find a part, joint or marker', ariaLabel: 'Find a part, joint or marker' });
  private readonly lists = make('div');
  private readonly buttons = new Map<string, HTMLButtonElement>();

  constructor(private readonly app: App, report: Report) {
    this.element.append(this.filter, this.lists);
    this.addList('Parts', partRows(report.parts));
    const names = partNames(report);
    const constraints = report.elements.filter((element) => !element.isForce && element.kind !== 'REQUEST');
    this.addList('Joints, primitives and motions', constraints.map((element) => elementRow(element, names)));
    this.addList('Forces', report.elements.filter((element) => element.isForce).map((element) => elementRow(element, names)));
    const markers = report.markers.map(({ id, part }) => ({ id: `MARKER/${id}`, text: `MARKER/${id}`, note: report.parts[part]?.id ?? '', depth: 0 }));
    this.addList('Markers', markers, true);
    this.filter.oninput = () => this.applyFilter();
    app.on('selection', () => this.showSelection());
  }

  private addList(title: string, rows: Row[], closed = false): void {
    if (rows.length === 0) return;
    const list = make('ul', {}, ...rows.map((row) => this.item(row)));
    this.lists.append(make('details', { open: !closed }, make('summary', {}, `${title} (${rows.length})`), list));
  }

  private item({ id, text, note, depth }: Row): HTMLLIElement {
    const entry = make('button', { type: 'button', onclick: () => this.app.select(this.app.selection === id ? null : id) }, text, make('small', {}, note));
    entry.style.paddingInlineStart = `${8 + 12 * Math.min(depth, deepest)}px`;
    this.buttons.set(id, entry);
    return make('li', {}, entry);
  }

  private applyFilter(): void {
    const typed = this.filter.value.trim().toLowerCase();
    for (const button of this.buttons.values()) {
      button.parentElement!.hidden = !(button.textContent ?? '').toLowerCase().includes(typed);
    }
    if (typed) this.lists.querySelectorAll('details').forEach((details) => (details.open = true));
  }

  private showSelection(): void {
    for (const [id, button] of this.buttons) {
      const chosen = id === this.app.selection;
      if (chosen === (button.ariaCurrent === 'true')) continue;
      button.ariaCurrent = chosen ? 'true' : null;
      if (!chosen) continue;
      button.closest('details')!.open = true;
      if (button.offsetParent) button.scrollIntoView({ block: 'nearest' });
    }
  }
}

function partNames(report: Report): (marker: number) => string {
  const parts = new Map(report.markers.map(({ id, part }) => [id, report.parts[part]?.id ?? '']));
  const ground = report.parts.find((part) => part.ground)?.id ?? 'ground';
  return (marker) => parts.get(marker) ?? ground;
}

function elementRow(element: Element, partOf: (marker: number) => string): Row {
  const parts = element.i || element.j ? `${partOf(element.i)} – ${partOf(element.j)}` : '';
  return { id: element.id, text: element.id, note: [words(element.type), parts].filter(Boolean).join(', '), depth: 0 };
}

function partRows(parts: Part[]): Row[] {
  const ids = new Set(parts.map((part) => part.id));
  const children = new Map<string | null, Part[]>();
  for (const part of parts) {
    const parent = part.parent && part.parent !== part.id && ids.has(part.parent) ? part.parent : null;
    children.set(parent, [...(children.get(parent) ?? []), part]);
  }
  const rows: Row[] = [];
  const open = (children.get(null) ?? []).map((part) => ({ part, depth: 0 })).reverse();
  const seen = new Set<string>();
  while (open.length > 0) {
    const { part, depth } = open.pop()!;
    if (seen.has(part.id)) continue;
    seen.add(part.id);
    rows.push({ id: part.id, text: part.id, note: part.ground ? 'ground' : words(part.joint), depth });
    for (const child of [...(children.get(part.id) ?? [])].reverse()) open.push({ part: child, depth: depth + 1 });
  }
  return rows.concat(parts.filter((part) => !seen.has(part.id)).map((part) => ({ id: part.id, text: part.id, note: words(part.joint), depth: 0 })));
}
