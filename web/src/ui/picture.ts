// SPDX-License-Identifier: Apache-2.0
// The canvas with what lies over it: views, the axes, and the name of the selection.
import { Quaternion } from 'three';
import type { App } from '../app';
import { withUnit } from '../data/numbers';
import type { Model } from '../scene/model';
import { background, onSchemeChange, roles } from '../scene/palette';
import { viewNames } from '../scene/camera';
import { Viewer } from '../scene/viewer';
import { button, download, fileName, make } from './dom';
import { svg, svgName } from './icons';

const viewLabels = { iso: 'Iso', front: 'Front', right: 'Right', top: 'Top' };

export class Picture {
  readonly element = make('section', { className: 'picture', ariaLabel: 'Animation' });
  readonly viewer: Viewer;
  private readonly label = make('div', { className: 'name-label', hidden: true });
  private readonly axes: SVGSVGElement;
  private readonly axesDrawnFor = new Quaternion(0, 0, 0, 0);
  private drawnTime = NaN;

  constructor(private readonly app: App, readonly model: Model, private readonly title: string) {
    const canvas = make('canvas', { tabIndex: 0, ariaLabel: 'Picture of the mechanism. Drag to orbit, wheel to zoom.', attributes: { role: 'img' } });
    this.viewer = new Viewer(canvas, model);
    this.axes = document.createElementNS(svgName, 'svg');
    this.axes.setAttribute('class', 'axes');
    this.axes.setAttribute('viewBox', '-34 -34 68 68');
    this.element.append(canvas, this.axes, this.key(), this.label, this.tools());
    new ResizeObserver(() => this.viewer.resize(this.element.clientWidth, this.element.clientHeight)).observe(this.element);
    this.viewer.onPick = (id) => app.select(id);
    this.viewer.onFrame = (now) => this.frame(now);
    this.viewer.isMoving = () => app.playing;
    this.viewer.surface.onDrawn = () => this.overlay();
    for (const event of ['time', 'playing'] as const) app.on(event, () => this.viewer.invalidate());
    app.on('selection', () => this.highlight());
    onSchemeChange(() => {
      this.viewer.restyle();
      this.highlight();
    });
  }

  /** Brings the scene to the time of the page at once. */
  update(): void {
    if (this.app.time === this.drawnTime) return;
    this.drawnTime = this.app.time;
    this.model.setTime(this.app.time);
  }

  private frame(now: number): void {
    this.app.tick(now);
    this.update();
    if (this.app.playing) this.viewer.invalidate();
  }

  private tools(): HTMLElement {
    const { viewer } = this;
    return make('div', { className: 'view-tools', attributes: { role: 'group' }, ariaLabel: 'Views' },
      button('Fit', 'See all (F)', () => viewer.fit()),
      ...viewNames.map((name, k) => button(viewLabels[name], `View: ${name} (${k + 1}); again: from the other side`, () => viewer.view(name))),
      button('PNG', 'Save the picture as PNG', () => this.save()));
  }

  // What the arrows and the grid mean, with their measure.
  private key(): HTMLElement {
    const { loads, results } = this.model;
    const { units } = results.report;
    const entry = (className: string, text: string) => make('li', {}, make('span', { className: `key ${className}` }), text);
    return make('ul', { className: 'picture-key', ariaLabel: 'Key' },
      loads.largestForce > 0 && entry('force', `force, largest ${withUnit(loads.largestForce, units.force)}`),
      loads.largestTorque > 0 && entry('torque', `torque, largest ${withUnit(loads.largestTorque, `${units.force} ${units.length}`)}`),
      make('li', {}, `grid ${withUnit(this.viewer.cell, units.length)}`));
  }

  private save(): void {
    this.update();
    const bytes = Uint8Array.from(atob(this.viewer.surface.toDataUrl().split(',')[1]), (letter) => letter.charCodeAt(0));
    download(fileName(this.title, '.png'), new Blob([bytes], { type: 'image/png' }));
  }

  // What is selected stays bright, with the parts that an element acts between; the rest fades.
  private highlight(): void {
    const { selection } = this.app;
    const fade = background();
    const kept = this.related(selection);
    const drawn = selection !== null && this.model.anchor(selection) !== null;
    this.model.recolor(({ id, alsoOf, color }, out) => {
      out.copy(color);
      if (!drawn) return out;
      if (id === selection || alsoOf === selection) return out.copy(roles.selected);
      return kept.has(id) ? out : out.lerp(fade, 0.65);
    });
    this.viewer.invalidate();
  }

  private related(id: string | null): Set<string> {
    const { report } = this.model.results;
    const element = report.elements.find((candidate) => candidate.id === id);
    const ids = element ? [element.i, element.j] : id?.startsWith('MARKER/') ? [Number(id.slice(7))] : [];
    const markers = ids.map((marker) => this.model.motion.markers.get(marker));
    return new Set(markers.flatMap((marker) => (marker ? [report.parts[marker.part].id] : [])));
  }

  private overlay(): void {
    const { selection } = this.app;
    const anchor = selection === null ? null : this.model.anchor(selection);
    const at = anchor && this.viewer.project(anchor);
    this.label.hidden = !at;
    if (at) {
      this.label.textContent = selection;
      this.label.style.transform = `translate(${Math.round(at.x + 10)}px, ${Math.round(at.y - 26)}px)`;
    }
    this.drawAxes();
  }

  private drawAxes(): void {
    const { quaternion } = this.viewer.camera;
    if (quaternion.equals(this.axesDrawnFor)) return;
    this.axesDrawnFor.copy(quaternion);
    const marks = this.viewer.axes().map((direction, k) => ({ direction, name: 'XYZ'[k], depth: direction.z }));
    marks.sort((a, b) => a.depth - b.depth);
    this.axes.replaceChildren(...marks.flatMap(({ direction, name }) => {
      const [x, y] = [22 * direction.x, -22 * direction.y];
      const line = svg('line', { x1: 0, y1: 0, x2: x, y2: y, class: `axis-${name}` });
      const text = svg('text', { x: x * 1.32, y: y * 1.32 + 4, class: `axis-${name}` });
      text.textContent = name;
      return [line, text];
    }));
  }
}
