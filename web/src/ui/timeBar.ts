// SPDX-License-Identifier: Apache-2.0
import type { App } from '../app';
import { shortNumber } from '../data/numbers';
import { button, make } from './dom';
import { icon } from './icons';

const steps = 100_000;

export class TimeBar {
  readonly element: HTMLElement;
  private readonly slider = make('input', { type: 'range', min: '0', max: String(steps), step: '1', className: 'scrub', ariaLabel: 'Time' });
  private readonly playButton: HTMLButtonElement;
  private readonly field = make('input', { type: 'text', inputMode: 'decimal', className: 'time', ariaLabel: 'Go to time' });

  constructor(private readonly app: App, private readonly unit: string) {
    this.playButton = button(icon('play'), 'Play or pause (space)', () => app.toggle(), 'play');
    const loop = button(icon('loop'), 'Repeat from the start', () => this.toggleLoop(loop), 'toggle');
    loop.setAttribute('aria-pressed', String(app.loop));
    this.element = make('div', { className: 'time-bar', attributes: { role: 'group' }, ariaLabel: 'Time' },
      this.playButton,
      button(icon('back'), 'One output step back (left arrow)', () => app.step(-1), 'quiet'),
      button(icon('on'), 'One output step on (right arrow)', () => app.step(1), 'quiet'),
      this.slider,
      make('label', { className: 'time-field' }, 't = ', this.field, ` ${unit}`),
      this.speeds(), loop);
    this.slider.oninput = () => this.scrub();
    this.field.onchange = () => this.goTo();
    app.on('time', () => this.showPlace());
    app.on('values', () => this.show());
    app.on('playing', () => this.showPlaying());
    this.show();
  }

  private scrub(): void {
    this.app.pause();
    this.app.setTime(this.app.start + (Number(this.slider.value) / steps) * (this.app.end - this.app.start));
  }

  private goTo(): void {
    const t = Number(this.field.value.replace('−', '-').replace(',', '.'));
    if (Number.isFinite(t)) this.app.setTime(t);
    this.show();
  }

  private toggleLoop(loop: HTMLButtonElement): void {
    this.app.loop = !this.app.loop;
    loop.setAttribute('aria-pressed', String(this.app.loop));
  }

  private speeds(): HTMLSelectElement {
    const select = make('select', { title: 'Speed against real time', ariaLabel: 'Speed against real time' });
    for (const speed of this.app.speeds()) select.append(make('option', { value: String(speed) }, `×${speed}`));
    select.value = String(this.app.speed);
    select.onchange = () => (this.app.speed = Number(select.value));
    return select;
  }

  private showPlace(): void {
    const { start, end, time } = this.app;
    this.slider.value = String(end > start ? Math.round((steps * (time - start)) / (end - start)) : 0);
  }

  private show(): void {
    this.showPlace();
    const { time } = this.app;
    const text = shortNumber(Number(time.toPrecision(5)));
    if (document.activeElement !== this.field) this.field.value = text;
    this.slider.setAttribute('aria-valuetext', `${text} ${this.unit}`);
  }

  private showPlaying(): void {
    this.playButton.replaceChildren(icon(this.app.playing ? 'pause' : 'play'));
    this.playButton.setAttribute('aria-pressed', String(this.app.playing));
  }
}
