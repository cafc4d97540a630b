// SPDX-License-Identifier: Apache-2.0
// All plots, and the field in which a curve is found by typing.
import type { App } from '../app';
import type { Column, Columns } from '../data/columns';
import { onSchemeChange } from '../scene/palette';
import { button, download, fileName, make } from '../ui/dom';
import { toCsv } from './csv';
import { Plot } from './plot';
import { ColumnSearch } from './search';

export class PlotPanel {
  readonly element = make('section', { className: 'plots', ariaLabel: 'Plots' });
  readonly plots: Plot[] = [];
  readonly search: ColumnSearch;
  private readonly row = make('div', { className: 'plot-row' });
  private active: Plot | null = null;

  constructor(
    private readonly app: App,
    columns: Columns,
    private readonly timeUnit: string,
    private readonly title: string,
  ) {
    this.search = new ColumnSearch(columns, (column, inNewPlot) => this.addCurve(column, inNewPlot));
    const bar = make('div', { className: 'plot-bar' },
      this.search.element, button('New plot', 'New plot', () => this.activate(this.addPlot())));
    this.element.append(bar, this.row);
    app.on('time', () => this.plots.forEach((plot) => plot.showTime()));
    app.on('values', () => this.plots.forEach((plot) => plot.showValues()));
    app.on('selection', () => this.rebuild());
    onSchemeChange(() => this.rebuild());
  }

  addPlot(columns: Column[] = []): Plot {
    const tools = make('span', { className: 'tools' });
    const plot = new Plot(this.app, this.timeUnit, [tools]);
    tools.append(
      button('CSV', 'Save these curves as CSV', () => this.saveCsv(plot), 'quiet'),
      button('PNG', 'Save this plot as PNG', () => this.savePng(plot), 'quiet'),
      button('✕', 'Close this plot', () => this.close(plot), 'quiet'),
    );
    plot.columns.push(...columns);
    plot.element.addEventListener('pointerdown', () => this.activate(plot));
    plot.element.addEventListener('focusin', () => this.activate(plot));
    this.plots.push(plot);
    this.row.append(plot.element);
    plot.rebuild();
    if (!this.active) this.activate(plot);
    return plot;
  }

  /** Into the plot that was used last, or a new one. */
  addCurve(column: Column, inNewPlot = false): void {
    const plot = inNewPlot || !this.active ? this.addPlot() : this.active;
    this.activate(plot);
    plot.add(column);
    this.reveal(plot);
  }

  /** Makes sure that a curve is to be seen: where it already is, or in the plot used last if its unit fits. */
  show(column: Column): void {
    const present = this.plots.find((plot) => plot.columns.includes(column));
    const fitting = [this.active, ...this.plots].find((plot) => plot?.columns.some((other) => other.unit === column.unit && other.table === column.table));
    if (present) this.activate(present);
    else if (fitting) this.activate(fitting);
    if (!present) this.addCurve(column, !fitting);
    if (this.active) this.reveal(this.active);
  }

  csv(): string {
    return toCsv((this.active ?? this.plots[0])?.columns ?? []);
  }

  // Within the row of plots only: the page itself stays where it is.
  private reveal({ element }: Plot): void {
    const { scrollLeft, clientWidth, offsetLeft } = this.row;
    const start = element.offsetLeft - offsetLeft;
    const end = start + element.offsetWidth;
    if (start < scrollLeft) this.row.scrollLeft = start;
    else if (end > scrollLeft + clientWidth) this.row.scrollLeft = end - clientWidth;
  }

  private activate(plot: Plot): void {
    this.active = plot;
    for (const other of this.plots) other.element.classList.toggle('active', other === plot);
    this.search.describe(plot.columns.length > 0 ? `into the plot of ${plot.columns[0].name}` : 'into the empty plot');
  }

  private close(plot: Plot): void {
    this.plots.splice(this.plots.indexOf(plot), 1);
    plot.element.remove();
    this.active = null;
    if (this.plots[0]) this.activate(this.plots[0]);
  }

  private rebuild(): void {
    for (const plot of this.plots) plot.rebuild();
  }

  private saveCsv(plot: Plot): void {
    download(fileName(this.title, '.csv'), new Blob([toCsv(plot.columns)], { type: 'text/csv' }));
  }

  private savePng(plot: Plot): void {
    plot.canvas()?.toBlob((blob) => blob && download(fileName(this.title, '-plot.png'), blob));
  }
}

