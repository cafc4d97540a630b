// SPDX-License-Identifier: Apache-2.0
// The canvas that is drawn on. Where WebGL runs on the processor, frames have one sample a pixel while things move, and
// four when they come to rest.
import { type PerspectiveCamera, type Scene, WebGLRenderer } from 'three';
import { runsOnProcessor } from './processor';

const restAfter = 150;

export class Surface {
  onDrawn: () => void = () => undefined;
  private readonly renderer: WebGLRenderer;
  private readonly onProcessor = runsOnProcessor();
  private readonly ratio = Math.min(devicePixelRatio, 2);
  private size = { width: 0, height: 0 };
  private frames = 0;
  private drawnAt: number[] = [];
  private rest: ReturnType<typeof setTimeout> | undefined;
  private fine = true;

  constructor(readonly canvas: HTMLCanvasElement, private readonly passes: Scene[], private readonly camera: PerspectiveCamera) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.onProcessor });
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.autoClear = false;
  }

  /** Whether the size is another one. */
  resize(width: number, height: number): boolean {
    if (width < 1 || height < 1 || (width === this.size.width && height === this.size.height)) return false;
    this.size = { width, height };
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    return true;
  }

  draw(moving: boolean): void {
    if (this.size.width === 0) return;
    if (this.onProcessor) this.refineAtRest(moving);
    this.render();
  }

  toDataUrl(): string {
    if (this.onProcessor) this.setFine(true);
    this.render();
    return this.canvas.toDataURL('image/png');
  }

  /** Frames drawn in the second before the last one. */
  fps(): number {
    const last = this.drawnAt.at(-1) ?? 0;
    return this.drawnAt.filter((at) => at > last - 1000).length;
  }

  info(): { triangles: number; frames: number; atRest: boolean } {
    return { triangles: this.renderer.info.render.triangles, frames: this.frames, atRest: this.rest === undefined };
  }

  private render(): void {
    this.renderer.clear();
    this.passes.forEach((scene, k) => {
      if (k > 0) this.renderer.clearDepth();
      this.renderer.render(scene, this.camera);
    });
    this.frames += 1;
    this.drawnAt.push(performance.now());
    if (this.drawnAt.length > 240) this.drawnAt.shift();
    this.onDrawn();
  }

  private refineAtRest(moving: boolean): void {
    clearTimeout(this.rest);
    this.setFine(false);
    this.rest = moving ? undefined : setTimeout(() => {
      this.rest = undefined;
      this.setFine(true);
      this.render();
    }, restAfter);
  }

  private setFine(fine: boolean): void {
    if (fine === this.fine) return;
    this.fine = fine;
    this.renderer.setPixelRatio(fine ? Math.max(2, this.ratio) : 1);
  }
}
