// SPDX-License-Identifier: Apache-2.0
// What is drawn, and how large.
import { layerNames, type LayerName, type Model } from '../scene/model';
import type { Viewer } from '../scene/viewer';
import { checkbox, factorSlider, make } from './dom';

const labels: Record<LayerName, string> = {
  parts: 'Parts',
  ground: 'Ground',
  springs: 'Springs and lines of force',
  joints: 'Joints, primitives and motions',
  markers: 'Markers (x red, y green, z blue)',
  forces: 'Forces on I (orange arrows)',
  torques: 'Torques on I (violet arrows, two heads)',
};

export class Show {
  readonly element = make('div', { className: 'show' });

  constructor(private readonly model: Model, private readonly viewer: Viewer, unit: string) {
    const layers = layerNames.map((name) => checkbox(labels[name], model.layer(name).group.visible, (shown) => this.showLayer(name, shown)));
    const grid = checkbox(`Grid, ${viewer.cell} ${unit}`, true, (shown) => viewer.showGrid(shown));
    this.element.append(
      make('fieldset', {}, make('legend', {}, 'Drawn'), ...layers, grid),
      make('fieldset', {}, make('legend', {}, 'Size'), ...this.sliders()),
      this.key(),
    );
  }

  showLayer(name: LayerName, shown: boolean): void {
    this.model.layer(name).group.visible = shown;
    this.changed();
  }

  private sliders(): HTMLElement[] {
    const { model } = this;
    const symbolSize = model.symbols.size;
    const sliders = [
      factorSlider('Forces', (factor) => this.change(() => (model.loads.forceScale = factor))),
      factorSlider('Torques', (factor) => this.change(() => (model.loads.torqueScale = factor))),
      factorSlider('Symbols', (factor) => this.change(() => (model.symbols.size = symbolSize * factor)), 10),
    ];
    if (model.flexible.length > 0) {
      sliders.push(factorSlider('Deformation', (factor) => this.change(() => (model.motion.deformationScale = factor)), 1000));
    }
    return sliders;
  }

  private key(): HTMLElement {
    const line = (className: string, text: string) => make('li', {}, make('span', { className: `key ${className}` }), text);
    return make('fieldset', {}, make('legend', {}, 'Colours'), make('ul', { className: 'keys' },
      line('free', 'directions that a joint leaves free: straight arrows slide, round ones turn'),
      line('held', 'what it holds'),
      line('motion', 'a motion'),
      line('force', 'force on the I marker’s part'),
      line('torque', 'torque on the I marker’s part')));
  }

  private change(apply: () => void): void {
    apply();
    this.changed();
  }

  private changed(): void {
    this.model.refresh();
    this.viewer.invalidate();
  }
}
