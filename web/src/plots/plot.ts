// SPDX-License-Identifier: Apache-2.0
// One plot: curves over time, an axis for each unit, and the animation's time as cursor.
import uPlot from 'uplot';
import type { App } from '../app';
import { valueAt, type Column } from '../data/columns';
import { shortNumber } from '../data/numbers';
import { curveColor, isDark } from '../scene/palette';
import { button, make } from '../ui/dom';
import { alignedData } from './data';

const dashes = [[], [8, 4], [2, 3], [10, 3, 2, 3]];

const clickReach = 10;

export class Plot {
  readonly element: HTMLElement;
  readonly columns: Column[] = [];
  onChange: () => void = () => undefined;
  private readonly legend = make('ul', { className: 'legend' });
  private readonly area = make('div', { className: 'plot-area' });
  private readonly cursor = make('div', { className: 'time-cursor' });
  private chart: uPlot | null = null;
  private hover: number | null = null;

  constructor(private readonly app: App, private readonly timeUnit: string, tools: Node[]) {
    this.element = make('section', { className: 'plot', ariaLabel: 'Plot' }, make('header', {}, this.legend, ...tools), this.area);
    new ResizeObserver(() => this.fit()).observe(this.area);
  }

  add(column: Column): void {
    if (this.columns.includes(column)) return;
    this.columns.push(column);
    this.rebuild();
    this.onChange();
  }

  remove(column: Column): void {
    this.columns.splice(this.columns.indexOf(column), 1);
    this.rebuild();
    this.onChange();
  }

  /** Draws anew: with other curves, colours or selection. */
  rebuild(): void {
    const range = this.chart ? this.zoomed() : null;
    this.chart?.destroy();
    this.chart = null;
    this.area.replaceChildren();
    this.listCurves();
    if (this.columns.length === 0) {
      this.area.append(make('p', { className: 'empty' }, 'No curve yet: type a name in “Add a curve”.'));
      return;
    }
    this.chart = new uPlot(this.options(), alignedData(this.columns), this.area);
    this.chart.over.append(this.cursor);
    if (range) this.chart.setScale('x', range);
    this.showTime();
  }

  showTime(): void {
    if (!this.chart) return;
    const x = this.chart.valToPos(this.app.time, 'x');
    const inside = x >= 0 && x <= this.chart.over.clientWidth;
    this.cursor.style.transform = `translateX(${x}px)`;
    this.cursor.hidden = !inside;
  }

  /** The plot with its legend, as a picture. */
  canvas(): HTMLCanvasElement | null {
    if (!this.chart) return null;
    const plot = this.chart.ctx.canvas;
    const ratio = devicePixelRatio || 1;
    const line = 18 * ratio;
    const canvas = make('canvas', { width: plot.width, height: plot.height + line * this.columns.length + 8 * ratio });
    const context = canvas.getContext('2d')!;
    context.fillStyle = isDark() ? '#1a1f25' : '#ffffff';
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.font = `${12 * ratio}px system-ui, sans-serif`;
    this.columns.forEach((column, k) => {
      context.fillStyle = curveColor(k);
      context.fillText(`— ${label(column)}`, 8 * ratio, line * (k + 0.9));
    });
    context.drawImage(plot, 0, canvas.height - plot.height);
    return canvas;
  }

  private zoomed(): { min: number; max: number } | null {
    const { min, max } = this.chart!.scales.x;
    const times = this.chart!.data[0];
    if (min === undefined || max === undefined || min === null || max === null) return null;
    return min > times[0] || max < times[times.length - 1] ? { min, max } : null;
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.area;
    if (this.chart && width > 0 && height > 0) {
      this.chart.setSize({ width, height });
      this.showTime();
    }
  }

  private listCurves(): void {
    const entries = this.columns.map((column, k) => {
      const swatch = make('span', { className: 'swatch' });
      swatch.style.background = curveColor(k);
      const name = button(label(column), `Select ${column.element ?? column.name}`, () => this.app.select(column.element), 'name');
      name.prepend(swatch);
      const remove = button('×', `Remove ${column.name}`, () => this.remove(column), 'quiet');
      const chosen = column.element !== null && column.element === this.app.selection;
      return make('li', { className: chosen ? 'chosen' : '' }, name, make('output', {}), remove);
    });
    this.legend.replaceChildren(...entries);
    this.showValues();
  }

  showValues(): void {
    const t = this.hover ?? this.app.time;
    this.legend.querySelectorAll('output').forEach((output, k) => {
      output.textContent = shortNumber(valueAt(this.columns[k], t));
    });
  }

  private options(): uPlot.Options {
    const units = [...new Set(this.columns.map((column) => column.unit))];
    return {
      width: Math.max(this.area.clientWidth, 50),
      height: Math.max(this.area.clientHeight, 50),
      legend: { show: false },
      padding: [8, 12, 0, 0],
      scales: { x: { time: false } },
      cursor: { drag: { x: true, y: false, setScale: true } },
      series: [{}, ...this.columns.map((column, k) => this.series(column, k))],
      axes: [this.axis({ scale: 'x', label: `time [${this.timeUnit}]`, size: 30, labelSize: 16 }), ...units.map((unit, k) => this.unitAxis(unit, k))],
      hooks: {
        ready: [(chart) => this.listen(chart)],
        setCursor: [(chart) => this.follow(chart)],
        draw: [(chart) => chart === this.chart && this.showTime()],
      },
    };
  }

  private series(column: Column, k: number): uPlot.Series {
    const { selection } = this.app;
    const chosen = selection !== null && column.element === selection;
    return {
      label: column.name,
      scale: `y ${column.unit}`,
      stroke: curveColor(k),
      width: chosen ? 3 : 1.5,
      dash: dashes[Math.floor(k / 2) % dashes.length],
      spanGaps: true,
      pxAlign: 0,
      points: { show: false },
    };
  }

  private axis(axis: uPlot.Axis): uPlot.Axis {
    const text = isDark() ? '#aab4bf' : '#4a5560';
    const line = isDark() ? '#2c343d' : '#e3e7eb';
    const font = '11px system-ui, sans-serif';
    const grid = { stroke: line, width: 1 };
    return { stroke: text, grid, ticks: { ...grid, size: 4 }, font, labelFont: font, ...axis };
  }

  private unitAxis(unit: string, k: number): uPlot.Axis {
    const values = (_: uPlot, ticks: number[]) => ticks.map((tick) => shortNumber(Number(tick.toPrecision(12))));
    return this.axis({
      scale: `y ${unit}`, side: k % 2 === 0 ? 3 : 1, label: unit || ' ', size: 52, labelSize: 16, values,
      grid: { show: k === 0, stroke: isDark() ? '#2c343d' : '#e3e7eb', width: 1 },
    });
  }

  // A click without a drag goes to that moment, and selects the curve under it.
  private listen(chart: uPlot): void {
    let down = 0;
    chart.over.addEventListener('mousedown', (event) => (down = event.clientX));
    chart.over.addEventListener('click', (event) => {
      if (Math.abs(event.clientX - down) > 3) return;
      const t = chart.posToVal(event.offsetX, 'x');
      this.app.pause();
      this.app.setTime(t);
      const column = this.columnNear(chart, t, event.offsetY);
      if (column) this.app.select(column.element);
    });
  }

  private columnNear(chart: uPlot, t: number, y: number): Column | undefined {
    const distance = (column: Column) => Math.abs(chart.valToPos(valueAt(column, t), `y ${column.unit}`) - y);
    return this.columns.filter((column) => distance(column) < clickReach).sort((a, b) => distance(a) - distance(b))[0];
  }

  private follow(chart: uPlot): void {
    const { left } = chart.cursor;
    this.hover = left !== undefined && left !== null && left >= 0 ? chart.posToVal(left, 'x') : null;
    this.showValues();
  }
}

export function label(column: Column): string {
  return column.unit ? `${column.name} [${column.unit}]` : column.name;
}
