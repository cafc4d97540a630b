// SPDX-License-Identifier: Apache-2.0
// Where parts and markers are at a moment.
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Flexible, Results } from './load';
import { locate } from './columns';

const one = new Vector3(1, 1, 1);

export function poseMatrix(pose: ArrayLike<number>, offset = 0, out = new Matrix4()): Matrix4 {
  const position = new Vector3(pose[offset], pose[offset + 1], pose[offset + 2]);
  const rotation = new Quaternion(pose[offset + 4], pose[offset + 5], pose[offset + 6], pose[offset + 3]);
  return out.compose(position, rotation, one);
}

export class Marker {
  readonly frame = new Matrix4();
  private nearestPoint = -1;

  constructor(
    readonly id: number,
    readonly part: number,
    readonly local: Matrix4,
    readonly flexible: Flexible | null,
  ) {
    if (flexible) this.nearestPoint = nearestPoint(flexible.points, new Vector3().setFromMatrixPosition(local));
  }

  /** How far the mesh's point at the marker is displaced, in the body's coordinate system. */
  displacement(amplitudes: ArrayLike<number>, scale: number, out: Vector3): Vector3 {
    out.set(0, 0, 0);
    const { modes, modeCount, points } = this.flexible!;
    for (let mode = 0; mode < modeCount; ++mode) {
      const at = mode * points.length + 3 * this.nearestPoint;
      const amplitude = scale * amplitudes[mode];
      out.x += amplitude * modes[at];
      out.y += amplitude * modes[at + 1];
      out.z += amplitude * modes[at + 2];
    }
    return out;
  }
}

function nearestPoint(points: Float32Array, p: Vector3): number {
  let nearest = 0;
  let least = Infinity;
  for (let k = 0; k < points.length; k += 3) {
    const distance = (points[k] - p.x) ** 2 + (points[k + 1] - p.y) ** 2 + (points[k + 2] - p.z) ** 2;
    if (distance < least) {
      least = distance;
      nearest = k / 3;
    }
  }
  return nearest;
}

export class Motion {
  readonly partFrames: Matrix4[];
  readonly markers = new Map<number, Marker>();
  readonly ground: number;
  deformationScale = 1;
  time = NaN;
  private readonly amplitudes = new Map<Flexible, Float32Array>();

  constructor(readonly results: Results) {
    const { parts, markers } = results.report;
    this.partFrames = parts.map(() => new Matrix4());
    this.ground = parts.findIndex((part) => part.ground);
    const flexible = new Map(results.flexible.map((body) => [body.part, body]));
    for (const { id, part, pose } of markers) {
      this.markers.set(id, new Marker(id, part, poseMatrix(pose), flexible.get(part) ?? null));
    }
    for (const body of results.flexible) this.amplitudes.set(body, new Float32Array(body.modeCount));
    this.setTime(results.time[0] ?? 0);
  }

  setTime(t: number): void {
    this.time = t;
    const { row, fraction } = locate(this.results.time, t);
    this.partFrames.forEach((frame, part) => this.partPose(part, row, fraction, frame));
    for (const [body, amplitudes] of this.amplitudes) this.interpolateAmplitudes(body, row, fraction, amplitudes);
    for (const marker of this.markers.values()) this.placeMarker(marker);
  }

  /** The frame of a marker; of number 0 or none, ground. */
  markerFrame(id: number | undefined): Matrix4 {
    return (id ? this.markers.get(id)?.frame : undefined) ?? this.groundFrame();
  }

  amplitudesOf(body: Flexible): Float32Array {
    return this.amplitudes.get(body)!;
  }

  /** Positions of a point of a part at every frame. */
  path(part: number, local: Vector3, marker?: Marker): Float32Array {
    const { time } = this.results;
    const positions = new Float32Array(time.length * 3);
    const frame = new Matrix4();
    const point = new Vector3();
    for (let row = 0; row < time.length; ++row) {
      point.copy(local);
      if (marker?.flexible) point.add(this.displacementAt(marker, row));
      point.applyMatrix4(this.partPose(part, row, 0, frame)).toArray(positions, 3 * row);
    }
    return positions;
  }

  partPose(part: number, row: number, fraction: number, out: Matrix4): Matrix4 {
    const { poses, report } = this.results;
    const at = (row * report.parts.length + part) * 7;
    if (at + 7 > poses.length) return out.identity();
    if (fraction === 0) return poseMatrix(poses, at, out);
    const next = at + report.parts.length * 7;
    const mix = (k: number) => poses[at + k] + fraction * (poses[next + k] - poses[at + k]);
    const a = new Quaternion(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
    const b = new Quaternion(poses[next + 4], poses[next + 5], poses[next + 6], poses[next + 3]);
    return out.compose(new Vector3(mix(0), mix(1), mix(2)), a.slerp(b, fraction), one);
  }

  private groundFrame(): Matrix4 {
    return this.ground < 0 ? new Matrix4() : this.partFrames[this.ground];
  }

  private displacementAt(marker: Marker, row: number): Vector3 {
    const { amplitudes, modeCount } = marker.flexible!;
    const values = amplitudes.subarray(row * modeCount, (row + 1) * modeCount);
    return marker.displacement(values, this.deformationScale, new Vector3());
  }

  private interpolateAmplitudes(body: Flexible, row: number, fraction: number, out: Float32Array): void {
    const { amplitudes, modeCount } = body;
    for (let mode = 0; mode < modeCount; ++mode) {
      const at = row * modeCount + mode;
      const value = amplitudes[at] ?? 0;
      out[mode] = fraction === 0 ? value : value + fraction * (amplitudes[at + modeCount] - value);
    }
  }

  private placeMarker(marker: Marker): void {
    marker.frame.copy(marker.local);
    if (marker.flexible) {
      const shift = marker.displacement(this.amplitudesOf(marker.flexible), this.deformationScale, new Vector3());
      marker.frame.elements[12] += shift.x;
      marker.frame.elements[13] += shift.y;
      marker.frame.elements[14] += shift.z;
    }
    marker.frame.premultiply(this.partFrames[marker.part]);
  }
}
