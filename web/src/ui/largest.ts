// SPDX-License-Identifier: Apache-2.0
// The table of largest values. A click goes to the moment, the element and the curve.
import type { App } from '../app';
import type { Column } from '../data/columns';
import { shortNumber } from '../data/numbers';
import type { Peak, Peaks } from '../data/peaks';
import { make } from './dom';

const mostRows = 400;

export class Largest {
  readonly element = make('div', { className: 'largest' });
  private readonly rows: { row: HTMLTableRowElement; peak: Peak }[] = [];

  constructor(
    private readonly app: App,
    private readonly timeUnit: string,
    peaks: Peaks,
    private readonly describe: (element: string | null) => string,
    private readonly show: (column: Column) => void,
  ) {
    this.element.append(make('p', { className: 'hint' }, 'By magnitude, over the whole run. Click a row to go to that moment.'));
    this.addTable('Largest forces', 'Force', peaks.forces);
    this.addTable('Largest torques', 'Torque', peaks.torques);
    this.addTable('Largest values of requests', 'Value', peaks.requests);
    if (this.rows.length === 0) this.element.append(make('p', { className: 'empty' }, 'The run has no reactions and no requests.'));
    app.on('selection', () => this.showSelection());
  }

  private addTable(title: string, quantity: string, peaks: Peak[]): void {
    if (peaks.length === 0) return;
    const units = new Set(peaks.map((peak) => peak.column.unit));
    const common = units.size === 1 ? [...units][0] : null;
    const cells = ['Element', common ? `${quantity} [${common}]` : quantity, `Time [${this.timeUnit}]`];
    const head = make('tr', {}, ...cells.map((text) => make('th', { scope: 'col' }, text)));
    const most = Math.max(...peaks.map((peak) => Math.abs(peak.value)).filter(Number.isFinite));
    const body = make('tbody', {}, ...peaks.slice(0, mostRows).map((peak) => this.row(peak, common, most)));
    const more = peaks.length > mostRows && make('p', { className: 'hint' }, `The largest ${mostRows} of ${peaks.length}.`);
    this.element.append(make('table', {}, make('caption', {}, title), make('thead', {}, head), body), more || '');
  }

  private row(peak: Peak, common: string | null, most: number): HTMLTableRowElement {
    const { element, unit } = peak.column;
    const value = common ? shortNumber(peak.value) : `${shortNumber(peak.value)} ${unit}`;
    const name = make('button', { type: 'button', className: 'link', title: `Go to ${peak.label} at its largest` }, peak.label);
    const what = element && this.describe(element);
    const cell = make('td', { className: 'value' }, value);
    if (common) cell.style.setProperty('--part', `${(100 * Math.abs(peak.value)) / most}%`);
    const row = make('tr', {}, make('td', {}, name, what ? make('small', {}, what) : ''), cell, make('td', { className: 'value' }, shortNumber(peak.time)));
    row.onclick = () => this.go(peak);
    this.rows.push({ row, peak });
    return row;
  }

  private go(peak: Peak): void {
    this.app.pause();
    this.show(peak.column);
    this.app.setTime(peak.time);
    this.app.select(peak.column.element);
  }

  private showSelection(): void {
    for (const { row, peak } of this.rows) {
      row.classList.toggle('chosen', peak.column.element !== null && peak.column.element === this.app.selection);
    }
  }
}
