// SPDX-License-Identifier: Apache-2.0
// A combobox of all columns.
import type { Column, Columns } from '../data/columns';
import { make } from '../ui/dom';
import { label } from './plot';

const most = 60;

export class ColumnSearch {
  readonly element: HTMLElement;
  readonly input = make('input', {
    type: 'search', placeholder: 'Add a curve: type a name, such as “fx”', autocomplete: 'off', ariaLabel: 'Add a curve',
    attributes: { role: 'combobox', 'aria-expanded': 'false', 'aria-controls': 'curve-list', 'aria-autocomplete': 'list' },
  });
  private readonly list = make('ul', { id: 'curve-list', className: 'suggestions', hidden: true, attributes: { role: 'listbox' } });
  private found: Column[] = [];
  private current = 0;

  constructor(
    private readonly columns: Columns,
    private readonly choose: (column: Column, inNewPlot: boolean) => void,
  ) {
    this.element = make('div', { className: 'search' }, this.input, this.list);
    this.input.oninput = () => this.update();
    this.input.onfocus = () => this.update();
    this.input.onblur = () => this.show(false);
    this.input.onkeydown = (event) => this.key(event);
  }

  describe(target: string): void {
    this.input.title = `Enter adds the curve ${target}; Shift+Enter into a new plot`;
  }

  private update(): void {
    this.found = this.columns.search(this.input.value, most);
    this.current = 0;
    const items = this.found.map((column, k) => this.item(column, k));
    if (items.length === 0) items.push(make('li', { className: 'none' }, 'No such column'));
    if (items.length === most) items.push(make('li', { className: 'none' }, 'Type more to see others'));
    this.list.replaceChildren(...items);
    this.show(true);
    this.mark();
  }

  private item(column: Column, k: number): HTMLLIElement {
    const item = make('li', { id: `curve-${k}`, attributes: { role: 'option' } },
      make('span', {}, label(column)), make('span', { className: 'from' }, column.table));
    // mousedown comes before the field loses the focus.
    item.onmousedown = (event) => {
      event.preventDefault();
      this.take(k, event.shiftKey);
    };
    return item;
  }

  private key(event: KeyboardEvent): void {
    if (event.key === 'ArrowDown' || event.key === 'ArrowUp') this.move(event.key === 'ArrowDown' ? 1 : -1);
    else if (event.key === 'Enter') this.take(this.current, event.shiftKey);
    else if (event.key === 'Escape') this.input.blur();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private move(by: number): void {
    if (this.found.length === 0) return;
    this.current = (this.current + by + this.found.length) % this.found.length;
    this.mark();
  }

  private mark(): void {
    [...this.list.children].forEach((item, k) => item.setAttribute('aria-selected', String(k === this.current && k < this.found.length)));
    this.input.setAttribute('aria-activedescendant', `curve-${this.current}`);
    this.list.children[this.current]?.scrollIntoView({ block: 'nearest' });
  }

  private take(k: number, inNewPlot: boolean): void {
    const column = this.found[k];
    if (!column) return;
    this.input.value = '';
    this.show(false);
    this.choose(column, inNewPlot);
  }

  private show(shown: boolean): void {
    this.list.hidden = !shown;
    this.input.setAttribute('aria-expanded', String(shown));
  }
}
