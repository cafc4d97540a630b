// SPDX-License-Identifier: Apache-2.0
// What is selected: its name, its values now, and what can be done with it.
import type { App } from '../app';
import { valueAt, type Column, type Columns } from '../data/columns';
import { shortNumber } from '../data/numbers';
import type { Model } from '../scene/model';
import { button, make } from './dom';

export interface CardActions {
  describe(id: string): string;
  plot(column: Column): void;
  changed(): void;
}

export class Card {
  readonly element = make('aside', { className: 'card', hidden: true, ariaLabel: 'Selection' });
  private readonly values = make('dl');
  private shown: Column[] = [];
  private readonly hidden = new Set<string>();

  constructor(
    private readonly app: App,
    private readonly columns: Columns,
    private readonly model: Model | null,
    private readonly actions: CardActions,
  ) {
    app.on('selection', () => this.show());
    app.on('values', () => this.update());
  }

  private show(): void {
    const id = this.app.selection;
    this.element.hidden = id === null;
    if (id === null) return;
    this.shown = this.columns.ofElement(id).slice(0, 8);
    const rows = this.shown.flatMap((column) => [
      make('dt', {}, button(shortName(column, id), `Plot ${column.name}`, () => this.actions.plot(column), 'link')),
      make('dd', {}),
    ]);
    this.values.replaceChildren(...rows);
    const close = button('✕', 'Select nothing (Esc)', () => this.app.select(null), 'quiet');
    const title = make('header', {}, make('strong', {}, id), close);
    this.element.replaceChildren(title, make('p', {}, this.actions.describe(id)), this.values, this.tools(id));
    this.update();
  }

  private update(): void {
    if (this.element.hidden) return;
    this.values.querySelectorAll('dd').forEach((cell, k) => {
      const column = this.shown[k];
      cell.textContent = `${shortNumber(valueAt(column, this.app.time))} ${column.unit}`;
    });
  }

  private tools(id: string): HTMLElement | string {
    const { model } = this;
    if (!model || !model.anchor(id)) return '';
    const trace = button('Trace', 'Show the path of this point', () => {
      model.traces.toggle(id);
      trace.setAttribute('aria-pressed', String(model.traces.has(id)));
      this.actions.changed();
    }, 'toggle');
    trace.setAttribute('aria-pressed', String(model.traces.has(id)));
    const hide = button('Hide', 'Do not draw this', () => {
      const hiding = !this.hidden.has(id);
      if (hiding) this.hidden.add(id);
      else this.hidden.delete(id);
      model.hide(id, hiding);
      hide.setAttribute('aria-pressed', String(hiding));
      this.actions.changed();
    }, 'toggle');
    hide.setAttribute('aria-pressed', String(this.hidden.has(id)));
    return make('footer', {}, trace, hide);
  }
}

function shortName(column: Column, id: string): string {
  return column.name.startsWith(`${id}.`) ? column.name.slice(id.length + 1) : column.name;
}
