// SPDX-License-Identifier: Apache-2.0
import { make } from './dom';

export class Tabs {
  readonly element: HTMLElement;
  private readonly heads: HTMLButtonElement[];
  private readonly panels: HTMLElement[];

  constructor(tabs: { name: string; content: HTMLElement }[]) {
    this.heads = tabs.map(({ name }, k) => make('button', {
      type: 'button', id: `tab-${k}`, onclick: () => this.open(k), attributes: { role: 'tab', 'aria-controls': `panel-${k}` },
    }, name));
    this.panels = tabs.map(({ content }, k) => make('div', {
      id: `panel-${k}`, className: 'panel', tabIndex: 0, attributes: { role: 'tabpanel', 'aria-labelledby': `tab-${k}` },
    }, content));
    const list = make('div', { className: 'tabs', attributes: { role: 'tablist' } }, ...this.heads);
    list.onkeydown = (event) => this.key(event);
    this.element = make('aside', { className: 'side' }, list, ...this.panels);
    this.open(0);
  }

  open(index: number): void {
    this.heads.forEach((head, k) => {
      head.setAttribute('aria-selected', String(k === index));
      head.tabIndex = k === index ? 0 : -1;
      this.panels[k].hidden = k !== index;
    });
  }

  private key(event: KeyboardEvent): void {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    const now = this.heads.indexOf(document.activeElement as HTMLButtonElement);
    const next = (now + by + this.heads.length) % this.heads.length;
    this.open(next);
    this.heads[next].focus();
    event.preventDefault();
    event.stopPropagation();
  }
}
