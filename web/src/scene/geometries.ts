// SPDX-License-Identifier: Apache-2.0
// Unit geometries along z, to be scaled by the instances.
import {
  BoxGeometry, BufferAttribute, BufferGeometry, CatmullRomCurve3, Color, ConeGeometry, CylinderGeometry, OctahedronGeometry,
  SphereGeometry, TorusGeometry, TubeGeometry, Vector3,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { runsOnProcessor } from './processor';

const halfTurn = Math.PI / 2;

export class Geometries {
  /** Round things have fewer faces where there are many of them. */
  private readonly detail: number;

  constructor(parts: number) {
    const many = runsOnProcessor() ? parts * 15 : parts;
    this.detail = many <= 300 ? 1 : many <= 1000 ? 0.6 : 0.34;
  }

  /** From z = 0 to 1, of these radii at both ends. */
  frustum(bottom: number, top: number, sides = 32): BufferGeometry {
    return new CylinderGeometry(top, bottom, 1, this.faces(sides)).translate(0, 0.5, 0).rotateX(halfTurn);
  }

  cylinder = () => this.frustum(1, 1);
  rod = () => this.frustum(1, 1, 10);
  box = () => new BoxGeometry(1, 1, 1);
  diamond = () => new OctahedronGeometry(1);
  ball = () => this.sphere(32);
  smallBall = () => this.sphere(14);

  /** A ring of radius 1 about z, or the arc of it from the x axis on. */
  ring(tube: number, angle = 2 * Math.PI): BufferGeometry {
    return new TorusGeometry(1, tube, this.faces(10), this.faces(Math.ceil((56 * Math.abs(angle)) / (2 * Math.PI))), angle);
  }

  /** From the origin along z, 1 long: shaft and head. */
  arrow(shaft = 0.035, head = 0.11, headLength = 0.28): BufferGeometry {
    const neck = 1 - headLength;
    const tip = this.cone(head, headLength).translate(0, 0, neck + headLength / 2);
    return mergeGeometries([this.frustum(shaft, shaft, 8).scale(1, 1, neck), tip]);
  }

  /** The usual sign of a torque vector: two heads, one behind the other. */
  doubleHeadedArrow = () => mergeGeometries([this.arrow(0.035, 0.11, 0.2), this.cone(0.11, 0.2).translate(0, 0, 0.7)]);

  /** A free translation along z. */
  straightDoubleArrow = () => {
    const half = this.arrow(0.04, 0.12, 0.3);
    return mergeGeometries([half, half.clone().rotateX(Math.PI)]);
  };

  /** A free rotation about z: three quarters of a ring with a head at each end. */
  roundDoubleArrow = () => {
    const [radius, angle] = [0.62, 1.5 * Math.PI];
    const head = (at: number, turn: number) =>
      new ConeGeometry(0.12, 0.3, this.faces(12)).rotateZ(turn > 0 ? 0 : Math.PI).translate(radius, 0.1 * turn, 0).rotateZ(at);
    const arc = new TorusGeometry(radius, 0.04, this.faces(6), this.faces(30), angle).rotateZ(-angle / 2);
    return mergeGeometries([arc, head(angle / 2, 1), head(-angle / 2, -1)]);
  };

  /** The border of a square of half width 1 in the xy plane. */
  squareFrame = () => {
    const side = () => new BoxGeometry(2, 0.06, 0.06).translate(0, 1, 0);
    return mergeGeometries([0, 1, 2, 3].map((k) => side().rotateZ(k * halfTurn)));
  };

  /** A coil spring of radius 1 from z = 0 to 1. */
  coil(turns: number): BufferGeometry {
    // About as long as coils are, so that the wire is round when the coil is scaled to its length.
    const length = turns;
    const points: Vector3[] = [new Vector3(0, 0, 0), new Vector3(0, 0, 0.08 * length)];
    const steps = this.faces(turns * 14);
    for (let k = 0; k <= steps; ++k) {
      const angle = (2 * Math.PI * turns * k) / steps;
      points.push(new Vector3(Math.cos(angle), Math.sin(angle), (0.12 + (0.76 * k) / steps) * length));
    }
    points.push(new Vector3(0, 0, 0.92 * length), new Vector3(0, 0, length));
    const wire = new TubeGeometry(new CatmullRomCurve3(points, false, 'centripetal'), points.length * 2, 0.13, 5);
    return wire.scale(1, 1, 1 / length);
  }

  /** A flat spiral about z of radius 1. */
  spiral = () => {
    const points = Array.from({ length: 60 }, (_, k) => {
      const angle = (k / 59) * 6 * Math.PI;
      return new Vector3((Math.cos(angle) * k) / 59, (Math.sin(angle) * k) / 59, 0);
    });
    return new TubeGeometry(new CatmullRomCurve3(points), 120, 0.06, 5);
  };

  /** The axes x, y, z in red, green and blue. */
  triad = () => {
    const axis = () => this.arrow(0.03, 0.09, 0.25);
    return mergeGeometries([
      painted(axis().rotateY(halfTurn), '#d03a3a'), painted(axis().rotateX(-halfTurn), '#2a9d4a'), painted(axis(), '#3b6fe0'),
    ]);
  };

  private sphere(around: number): BufferGeometry {
    const faces = this.faces(around);
    return new SphereGeometry(1, faces, Math.max(4, faces / 2)).rotateX(halfTurn);
  }

  private cone(radius: number, length: number): BufferGeometry {
    return new ConeGeometry(radius, length, this.faces(14)).rotateX(halfTurn);
  }

  private faces(most: number): number {
    return Math.max(4, Math.round(most * this.detail));
  }
}

function painted(geometry: BufferGeometry, color: string): BufferGeometry {
  const { r, g, b } = new Color(color);
  const count = geometry.getAttribute('position').count;
  const colors = new Float32Array(count * 3);
  for (let k = 0; k < count; ++k) colors.set([r, g, b], 3 * k);
  return geometry.setAttribute('color', new BufferAttribute(colors, 3));
}
