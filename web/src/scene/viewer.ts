// SPDX-License-Identifier: Apache-2.0
// The picture: renderer, camera and mouse. It draws only when something changed.
import {
  Box3, Color, DirectionalLight, GridHelper, HemisphereLight, PerspectiveCamera, Quaternion, Raycaster, Scene, Vector2, Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { niceBelow } from '../data/numbers';
import { firstDirection, fitPoints, upFrom, viewDirection, type ViewName } from './camera';
import { undrawnLayer } from './merged';
import type { Model } from './model';
import { background, gridColors } from './palette';
import { Surface } from './surface';

export class Viewer {
  readonly camera = new PerspectiveCamera(24, 1, 0.1, 1000);
  readonly controls: OrbitControls;
  onPick: (id: string | null) => void = () => undefined;
  onFrame: (now: number) => void = () => undefined;
  isMoving: () => boolean = () => false;
  cell = 0;
  readonly surface: Surface;
  private readonly solids = new Scene();
  private readonly overlay = new Scene();
  private readonly up: Vector3;
  private readonly motionPoints: Float32Array;
  private readonly motionBox: Box3;
  private grid: GridHelper | null = null;
  private pending = false;

  constructor(readonly canvas: HTMLCanvasElement, private readonly model: Model) {
    this.surface = new Surface(canvas, [this.solids, this.overlay], this.camera);
    this.up = upFrom(model.results.report.gravity);
    this.camera.up.copy(this.up);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.invalidate());
    this.solids.add(model.solids);
    this.overlay.add(model.overlay);
    this.motionPoints = this.pointsOverTime();
    this.motionBox = new Box3().setFromArray(this.motionPoints);
    this.addLights(this.solids, 1.9);
    this.addLights(this.overlay, 2.8);
    this.restyle();
    this.listenForClicks();
  }

  resize(width: number, height: number): void {
    const first = this.surface.info().frames === 0;
    if (this.surface.resize(width, height) && !first) this.surface.draw(this.isMoving());
  }

  /** Draws in the next frame of the browser. */
  invalidate(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame((now) => {
      this.pending = false;
      this.onFrame(now);
      this.surface.draw(this.isMoving());
    });
  }

  first(): void {
    this.look(firstDirection(this.motionBox, this.up));
  }

  fit(): void {
    this.look(this.camera.position.clone().sub(this.controls.target));
  }

  view(name: ViewName): void {
    const direction = viewDirection(name, this.up);
    const now = this.camera.position.clone().sub(this.controls.target).normalize();
    this.look(now.distanceTo(direction) < 1e-3 ? direction.negate() : direction);
  }

  showGrid(show: boolean): void {
    if (this.grid) this.grid.visible = show;
    this.invalidate();
  }

  restyle(): void {
    this.solids.background = background();
    const shown = this.grid?.visible ?? true;
    this.grid?.removeFromParent();
    this.grid = this.makeGrid();
    this.grid.visible = shown;
    this.solids.add(this.grid);
    this.invalidate();
  }

  /** In pixels of the canvas; null behind the camera. */
  project(point: Vector3): { x: number; y: number } | null {
    const p = point.clone().project(this.camera);
    if (p.z > 1) return null;
    return { x: ((p.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - p.y) / 2) * this.canvas.clientHeight };
  }

  /** Direction of the x, y and z axes in the picture. */
  axes(): Vector3[] {
    const inverse = this.camera.quaternion.clone().invert();
    return [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map((axis) => axis.applyQuaternion(inverse));
  }

  private look(direction: Vector3): void {
    fitPoints(this.camera, this.controls.target, this.motionPoints, direction);
    this.controls.update();
    this.invalidate();
  }

  // A part that flies off must not make the rest too small to see.
  private pointsOverTime(): Float32Array {
    const { time, report } = this.model.results;
    const start = this.model.corners();
    if (start.length === 0) return new Float32Array([-1, -1, -1, 1, 1, 1]);
    const points = [...start];
    const samples = Math.min(time.length, report.parts.length > 200 ? 4 : 24);
    for (let k = 1; k < samples; ++k) {
      this.model.setTime(time[Math.round((k * (time.length - 1)) / (samples - 1))]);
      for (const value of this.model.corners()) points.push(value);
    }
    this.model.setTime(time[0] ?? 0);
    const diagonal = (array: number[]) => new Box3().setFromArray(array).getSize(new Vector3()).length();
    return Float32Array.from(diagonal(points) > 4 * diagonal(start) ? start : points);
  }

  private addLights(scene: Scene, brightness: number): void {
    const sky = new HemisphereLight(0xffffff, 0x8890a0, brightness);
    sky.position.copy(this.up);
    const sun = new DirectionalLight(0xffffff, 1.7);
    sun.position.copy(viewDirection('iso', this.up)).addScaledVector(this.up, 0.6);
    scene.add(sky, sun);
  }

  private makeGrid(): GridHelper {
    const size = this.motionBox.getSize(new Vector3()).length();
    this.cell = niceBelow(size / 8);
    const [axis, line] = gridColors();
    const count = 2 * Math.ceil((0.8 * size) / this.cell);
    const grid = new GridHelper(count * this.cell, count, new Color(axis), new Color(line));
    grid.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), this.up));
    const centre = this.motionBox.getCenter(new Vector3());
    const lowest = Math.min(this.motionBox.min.dot(this.up), this.motionBox.max.dot(this.up));
    const snapped = centre.toArray().map((value) => Math.round(value / this.cell) * this.cell);
    const middle = new Vector3(...(snapped as [number, number, number]));
    grid.position.copy(middle.addScaledVector(this.up, lowest - 0.002 * size - middle.dot(this.up)));
    return grid;
  }

  private listenForClicks(): void {
    let down: { x: number; y: number } | null = null;
    this.canvas.addEventListener('pointerdown', (event) => (down = { x: event.clientX, y: event.clientY }));
    this.canvas.addEventListener('pointerup', (event) => {
      const moved = down ? Math.hypot(event.clientX - down.x, event.clientY - down.y) : Infinity;
      if (moved < 5 && event.button === 0) this.onPick(this.pick(event));
      down = null;
    });
  }

  private pick(event: PointerEvent): string | null {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const at = new Vector2(((event.clientX - left) / width) * 2 - 1, 1 - ((event.clientY - top) / height) * 2);
    const raycaster = new Raycaster();
    raycaster.setFromCamera(at, this.camera);
    raycaster.layers.enable(undrawnLayer);
    raycaster.params.Line.threshold = this.model.size * 0.005;
    raycaster.params.Points.threshold = this.model.size * 0.008;
    return this.model.pick(raycaster);
  }
}
