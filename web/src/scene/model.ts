// SPDX-License-Identifier: Apache-2.0
// Everything that is drawn of the mechanism, in layers that can be hidden.
import { Box3, Color, Group, Intersection, Matrix4, Raycaster, Vector3 } from 'three';
import type { Columns } from '../data/columns';
import type { Results } from '../data/load';
import { Motion } from '../data/motion';
import { Batch, type Item, type Placed } from './batch';
import { Bodies } from './bodies';
import { FlexibleBody } from './flexible';
import { Geometries } from './geometries';
import { Loads } from './loads';
import { partColor, roles } from './palette';
import { Shapes } from './shapes';
import { modelSize } from './size';
import { Springs } from './springs';
import { Symbols } from './symbols';
import { Traces } from './traces';

export const layerNames = ['parts', 'ground', 'springs', 'joints', 'markers', 'forces', 'torques'] as const;
export type LayerName = (typeof layerNames)[number];

const mostSymbolsUnasked = 500;

const inFront: LayerName[] = ['joints', 'markers', 'forces', 'torques'];

export class Model {
  readonly solids = new Group();
  /** Drawn over the solids: symbols must not be hidden inside a part. */
  readonly overlay = new Group();
  readonly motion: Motion;
  readonly size: number;
  readonly layers = new Map<LayerName, Batch>();
  readonly flexible: FlexibleBody[];
  readonly symbols: Symbols;
  readonly loads: Loads;
  readonly traces: Traces;
  private readonly geometries: Geometries;
  private readonly drawnParts = new Set<number>();

  constructor(readonly results: Results, columns: Columns) {
    this.motion = new Motion(results);
    this.size = modelSize(this.motion);
    this.geometries = new Geometries(results.report.parts.length);
    for (const name of layerNames) this.addLayer(name);
    this.symbols = new Symbols(this.motion, this.layer('joints'), this.geometries);
    this.symbols.size = 0.045 * this.size * Math.min(1, Math.sqrt(20 / Math.max(1, results.report.elements.length)));
    this.loads = new Loads(this.motion, columns, this.geometries, this.size);
    this.traces = new Traces(this.motion);
    this.flexible = results.flexible.map((body) => new FlexibleBody(this.motion, body, this.colorOf(body.part)));
    for (const body of this.flexible) this.layer('parts').group.add(body.group);
    this.solids.add(this.traces.group);
    this.addGraphics();
    this.addBodies();
    this.addElements();
    this.addMarkers();
    for (const layer of this.layers.values()) layer.build();
    this.layer('markers').group.visible = false;
    this.layer('joints').group.visible = results.report.elements.length <= mostSymbolsUnasked;
    this.setTime(this.motion.time);
  }

  layer(name: LayerName): Batch {
    return this.layers.get(name)!;
  }

  setTime(t: number): void {
    this.motion.setTime(t);
    this.loads.setTime(t);
    for (const layer of this.layers.values()) if (layer.group.visible) layer.update();
    for (const body of this.flexible) body.update();
  }

  refresh(): void {
    this.setTime(this.motion.time);
  }

  recolor(colorOf: (item: Pick<Item, 'id' | 'alsoOf' | 'color'>, out: Color) => Color): void {
    for (const layer of this.layers.values()) layer.recolor(colorOf);
    for (const body of this.flexible) body.recolor((id, color) => colorOf({ id, color }, new Color()));
  }

  hide(id: string, hide: boolean): void {
    for (const layer of this.layers.values()) layer.hide(id, hide);
    for (const body of this.flexible) if (body.id === id) body.group.visible = !hide;
    this.refresh();
  }

  /** The world matrix of a part, from the matrices of what is drawn of it. */
  partMatrix(id: string): Matrix4 | null {
    const body = this.flexible.find((candidate) => candidate.id === id);
    if (body) {
      body.group.updateWorldMatrix(true, false);
      return body.group.matrixWorld.clone();
    }
    const fixed = this.placed().find(({ item }) => item.id === id && item.local);
    if (!fixed) return null;
    return worldMatrix(fixed).multiply(fixed.item.local!.clone().invert());
  }

  drawn(): { id: string; kind: string; visible: boolean }[] {
    const flexible = this.flexible.map(({ id, group }) => ({ id, kind: 'FLEXIBLE', visible: group.visible }));
    const items = [...this.layers].flatMap(([name, layer]) =>
      layer.all().map((placed) => ({
        id: ['parts', 'ground'].includes(name) ? (placed.item.alsoOf ?? placed.item.id) : placed.item.id,
        kind: placed.item.kind,
        visible: layer.group.visible && worldMatrix(placed).determinant() !== 0,
      })),
    );
    return [...items, ...flexible];
  }

  /** Corners of the boxes around all that is drawn now. */
  corners(): number[] {
    const points: number[] = [];
    for (const placed of this.placed()) {
      placed.mesh.geometry.computeBoundingBox();
      addCorners(placed.mesh.geometry.boundingBox!, worldMatrix(placed), points);
    }
    for (const { group } of this.flexible) {
      if (group.visible) addCorners(new Box3().setFromObject(group, true), new Matrix4(), points);
    }
    return points;
  }

  pick(raycaster: Raycaster): string | null {
    return this.firstHit(raycaster, [this.overlay]) ?? this.firstHit(raycaster, [this.solids]);
  }

  /** A point at which the name of a part, element or marker is shown. */
  anchor(id: string): Vector3 | null {
    const { parts, elements } = this.results.report;
    const part = parts.findIndex((candidate) => candidate.id === id);
    if (part >= 0) return new Vector3(...(parts[part].cm as [number, number, number])).applyMatrix4(this.motion.partFrames[part]);
    const element = elements.find((candidate) => candidate.id === id);
    const marker = this.motion.markers.get(element ? element.i || element.j : Number(id.replace('MARKER/', '')));
    return marker ? new Vector3().setFromMatrixPosition(marker.frame) : null;
  }

  private addLayer(name: LayerName): void {
    const layer = new Batch();
    this.layers.set(name, layer);
    (inFront.includes(name) ? this.overlay : this.solids).add(layer.group);
  }

  private colorOf(part: number): Color {
    return this.results.report.parts[part]?.ground ? roles.ground : partColor(part);
  }

  private layerOf(part: number): Batch {
    return this.layer(this.results.report.parts[part]?.ground ? 'ground' : 'parts');
  }

  private addGraphics(): void {
    const line = 0.004 * this.size;
    for (const graphic of this.results.report.graphics) {
      const id = graphic.marker ?? graphic.points?.[0] ?? graphic.i ?? 0;
      const part = this.motion.markers.get(id)?.part ?? this.motion.ground;
      const batch = graphic.shape === 'SPDP' ? this.layer('springs') : this.layerOf(part);
      new Shapes(this.motion, batch, this.geometries, line, (index) => this.colorOf(index)).add(graphic);
      if (graphic.shape !== 'SPDP') this.drawnParts.add(part);
    }
  }

  private addBodies(): void {
    const bodies = new Bodies(this.motion, this.layer('parts'), this.geometries, this.size);
    const flexible = new Set(this.results.flexible.map((body) => body.part));
    this.results.report.parts.forEach((part, index) => {
      if (!part.ground && !this.drawnParts.has(index) && !flexible.has(index)) bodies.add(index, this.colorOf(index));
    });
  }

  private addElements(): void {
    const { elements, graphics } = this.results.report;
    const springs = new Springs(this.motion, this.layer('springs'), this.geometries, this.size);
    const withGraphic = new Set(graphics.filter((g) => g.shape === 'SPDP').map((g) => `${g.i} ${g.j}`));
    for (const element of elements) {
      if (element.kind === 'REQUEST') continue;
      const drawn = element.kind === 'SPRINGDAMPER' && withGraphic.has(`${element.i} ${element.j}`);
      if (!drawn && !springs.add(element) && !(element.isForce && element.loadOnI != null)) this.symbols.addElement(element);
      this.loads.add(element, this.layer('forces'), this.layer('torques'));
    }
  }

  private addMarkers(): void {
    const markers = new Symbols(this.motion, this.layer('markers'), this.geometries);
    markers.size = 0.04 * this.size;
    for (const { id, part } of this.results.report.markers) markers.addMarker(id, this.results.report.parts[part].id);
  }

  private placed(): Placed[] {
    return (['parts', 'ground', 'springs'] as const).flatMap((name) => {
      const layer = this.layer(name);
      return layer.group.visible ? layer.all().filter((placed) => layer.isPlaced(placed)) : [];
    });
  }

  private firstHit(raycaster: Raycaster, groups: Group[]): string | null {
    for (const hit of raycaster.intersectObjects(groups, true)) {
      const id = isShown(hit) ? (hit.object.userData.id ?? this.itemOf(hit)?.id) : undefined;
      if (id) return id;
    }
    return null;
  }

  private itemOf(hit: Intersection): Item | undefined {
    for (const layer of this.layers.values()) {
      const item = layer.itemOf(hit);
      if (item) return item;
    }
    return undefined;
  }
}

function worldMatrix({ mesh, index }: Placed): Matrix4 {
  const matrix = new Matrix4();
  mesh.getMatrixAt(index, matrix);
  mesh.updateWorldMatrix(true, false);
  return matrix.premultiply(mesh.matrixWorld);
}

function addCorners({ min, max }: Box3, matrix: Matrix4, out: number[]): void {
  const corner = new Vector3();
  for (let k = 0; k < 8; ++k) {
    corner.set(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z).applyMatrix4(matrix);
    out.push(corner.x, corner.y, corner.z);
  }
}

function isShown(hit: Intersection): boolean {
  for (let object: Intersection['object'] | null = hit.object; object; object = object.parent) {
    if (!object.visible) return false;
  }
  return true;
}
