// SPDX-License-Identifier: Apache-2.0
// What all views share: the moment, the selection, and playing.
import { secondsPer } from './data/numbers';

/** `values` comes with `time`, but while playing only as often as numbers can be read. */
type Event = 'time' | 'values' | 'selection' | 'playing';

const readableAfter = 120;

export class App {
  readonly start: number;
  readonly end: number;
  time: number;
  selection: string | null = null;
  playing = false;
  loop = true;
  /** Seconds of the run in a second of the reader. */
  speed: number;
  private readonly secondsPerUnit: number;
  private readonly listeners = new Map<Event, (() => void)[]>();
  private lastTick = 0;
  private once = false;
  private valuesShown = 0;

  constructor(readonly frameTimes: Float64Array, timeUnit: string) {
    this.start = frameTimes[0] ?? 0;
    this.end = frameTimes.at(-1) ?? this.start;
    this.time = this.start;
    this.secondsPerUnit = secondsPer(timeUnit);
    this.speed = this.comfortableSpeed();
  }

  on(event: Event, listener: () => void): void {
    this.listeners.set(event, [...(this.listeners.get(event) ?? []), listener]);
  }

  setTime(t: number): void {
    const time = Math.min(this.end, Math.max(this.start, t));
    if (time === this.time || Number.isNaN(time)) return;
    this.time = time;
    this.emit('time');
    const now = performance.now();
    if (!this.playing || now - this.valuesShown > readableAfter) this.emitValues(now);
  }

  select(id: string | null): void {
    if (id === this.selection) return;
    this.selection = id;
    this.emit('selection');
  }

  play(once = false): void {
    this.once = once;
    if (this.playing || this.end <= this.start) return;
    if (this.time >= this.end) this.setTime(this.start);
    this.playing = true;
    this.lastTick = 0;
    this.emit('playing');
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    this.emitValues(performance.now());
    this.emit('playing');
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Moves on while playing; called in every frame with the browser's clock in ms. */
  tick(now: number): void {
    if (!this.playing) return;
    const passed = this.lastTick ? Math.min(now - this.lastTick, 250) / 1000 : 0;
    this.lastTick = now;
    const next = this.time + (passed * this.speed) / this.secondsPerUnit;
    if (next < this.end) this.setTime(next);
    else if (this.loop && !this.once) this.setTime(this.start + ((next - this.start) % (this.end - this.start)));
    else this.stopAtEnd();
  }

  /** Goes by output times. One that is there twice, before and after a switch, counts once. */
  step(by: number): void {
    this.pause();
    const times = this.frameTimes;
    const next = times.findIndex((t) => t > this.time);
    const first = times.findIndex((t) => t >= this.time);
    const row = by > 0 ? (next < 0 ? times.length : next) + by - 1 : (first < 0 ? times.length : first) + by;
    this.setTime(times[Math.min(times.length - 1, Math.max(0, row))]);
  }

  speeds(): number[] {
    const usual = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
    return [...new Set([...usual, this.speed])].sort((a, b) => a - b);
  }

  // Real time, unless the run would then be over at once or take minutes.
  private comfortableSpeed(): number {
    const seconds = (this.end - this.start) * this.secondsPerUnit;
    if (!(seconds > 0) || (seconds >= 2 && seconds <= 30)) return 1;
    const wanted = seconds / 8;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const digit = wanted / power;
    return Number(((digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power).toPrecision(1));
  }

  private stopAtEnd(): void {
    this.setTime(this.end);
    this.pause();
  }

  private emitValues(now: number): void {
    this.valuesShown = now;
    this.emit('values');
  }

  private emit(event: Event): void {
    for (const listener of this.listeners.get(event) ?? []) listener();
  }
}
