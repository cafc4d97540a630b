// SPDX-License-Identifier: Apache-2.0
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, Points, PointsMaterial,
} from 'three';
import type { Flexible } from '../data/load';
import type { Motion } from '../data/motion';

/** The mesh of a flexible body, moved by its modes. */
export class FlexibleBody {
  readonly group = new Group();
  readonly id: string;
  private readonly positions: BufferAttribute;
  private readonly materials: (MeshLambertMaterial | LineBasicMaterial | PointsMaterial)[] = [];
  private readonly ownColors: Color[] = [];

  constructor(
    private readonly motion: Motion,
    private readonly body: Flexible,
    color: Color,
  ) {
    this.id = motion.results.report.parts[body.part].id;
    this.positions = new BufferAttribute(body.points.slice(), 3).setUsage(DynamicDrawUsage);
    this.group.matrixAutoUpdate = false;
    if (body.faces.length > 0) this.addFaces(color);
    if (body.edges.length > 0) this.addEdges(body.faces.length > 0 ? color.clone().multiplyScalar(0.45) : color);
    if (body.faces.length === 0 && body.edges.length === 0) this.addPoints(color);
  }

  update(): void {
    this.group.matrix.copy(this.motion.partFrames[this.body.part]);
    this.group.matrixWorldNeedsUpdate = true;
    const { points, modes, modeCount } = this.body;
    const amplitudes = this.motion.amplitudesOf(this.body);
    const moved = this.positions.array as Float32Array;
    moved.set(points);
    for (let mode = 0; mode < modeCount; ++mode) {
      const amplitude = amplitudes[mode] * this.motion.deformationScale;
      const offset = mode * points.length;
      if (amplitude !== 0) for (let k = 0; k < moved.length; ++k) moved[k] += amplitude * modes[offset + k];
    }
    this.positions.needsUpdate = true;
  }

  recolor(colorOf: (id: string, own: Color) => Color): void {
    this.materials.forEach((material, k) => material.color.copy(colorOf(this.id, this.ownColors[k])));
  }

  private addFaces(color: Color): void {
    const geometry = new BufferGeometry().setAttribute('position', this.positions).setIndex(this.body.faces);
    const material = new MeshLambertMaterial({
      side: DoubleSide, flatShading: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    });
    this.addObject(new Mesh(geometry, material), material, color);
  }

  private addEdges(color: Color): void {
    const geometry = new BufferGeometry().setAttribute('position', this.positions).setIndex(Array.from(this.body.edges));
    const material = new LineBasicMaterial();
    this.addObject(new LineSegments(geometry, material), material, color);
  }

  private addPoints(color: Color): void {
    const geometry = new BufferGeometry().setAttribute('position', this.positions);
    const material = new PointsMaterial({ size: 4, sizeAttenuation: false });
    this.addObject(new Points(geometry, material), material, color);
  }

  private addObject(
    object: Mesh | LineSegments | Points, material: MeshLambertMaterial | LineBasicMaterial | PointsMaterial, color: Color,
  ): void {
    object.frustumCulled = false;
    object.userData.id = this.id;
    material.color.copy(color);
    this.materials.push(material);
    this.ownColors.push(color);
    this.group.add(object);
  }
}
