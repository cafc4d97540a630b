// SPDX-License-Identifier: Apache-2.0
// A slider-crank that turns uniformly, with the loads that its motion takes in a plane without gravity on the rod.
import { Blocks } from './page.mjs';

const [crank, rod, speed, end, rows] = [100, 250, 2 * Math.PI, 2, 201];
const masses = [2, 1.2, 0.8];

const position = (t) => {
  const angle = speed * t + 0.6;
  const pin = [crank * Math.cos(angle), crank * Math.sin(angle)];
  const tilt = Math.asin(-pin[1] / rod);
  return { angle, pin, tilt, slider: pin[0] + rod * Math.cos(tilt) };
};

const pose = (x, y, angle) => [x, y, 0, Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)];

export function posesAt(t) {
  const { angle, pin, tilt, slider } = position(t);
  return [pose(0, 0, 0), pose(0, 0, angle), pose(...pin, tilt), pose(slider, 0, 0)];
}

const second = (f, t, h = 1e-3) => (f(t + h) - 2 * f(t) + f(t - h)) / (h * h);

function loadsAt(t) {
  const slider = (masses[2] * second((s) => position(s).slider, t)) / 1000;
  const middle = (k) => (s) => position(s).pin[k] + (k === 0 ? rod / 2 : 0) * Math.cos(position(s).tilt) + (k === 1 ? (rod / 2) * Math.sin(position(s).tilt) : 0);
  const [ax, ay] = [0, 1].map((k) => (masses[1] * second(middle(k), t)) / 1000);
  const across = -slider * Math.tan(position(t).tilt) + ay / 2;
  const pin = [ax + slider, ay + across];
  const torque = (position(t).pin[0] * pin[1] - position(t).pin[1] * pin[0]);
  const six = (x, y, z = 0) => [x, y, 0, 0, 0, z];
  return [six(pin[0], pin[1] + masses[0] * 9.81), six(...pin), six(slider, -across), six(0, across + masses[2] * 9.81, 0.1 * across), six(0, 0, torque)];
}

const element = (id, type, i, j, loadOnI, kind = 'JOINT') => ({ id: `${kind}/${id}`, kind, type, i, j, isForce: false, loadOnI });
const suffixes = ['FX', 'FY', 'FZ', 'TX', 'TY', 'TZ'];

function tables(blocks, times) {
  const table = (name, columns, values) => ({
    name, columns, time: blocks.array('f64', [times.length], times),
    data: blocks.array('f64', [columns.length, times.length], columns.flatMap((_, k) => times.map((t) => values(t)[k]))),
  });
  const names = ['JOINT/1', 'JOINT/2', 'JOINT/3', 'JOINT/4', 'MOTION/1'];
  const reactions = names.flatMap((id) => suffixes.map((s, k) => ({ name: `${id}.I.${s}`, unit: k < 3 ? 'N' : 'N mm', element: id })));
  const requests = ['X', 'VX'].map((name, k) => ({ name: `slider.${name}`, unit: k ? 'mm/s' : 'mm', element: 'REQUEST/1' }));
  const rate = (t) => (position(t + 1e-4).slider - position(t - 1e-4).slider) / 2e-4;
  const energy = (t) => [0.5 * masses[2] * (rate(t) / 1000) ** 2 + 3, -1 + Math.sin(position(t).angle), 0];
  return [
    table('requests', requests, (t) => [position(t).slider, rate(t)]),
    table('reactions', reactions, (t) => loadsAt(t).flat()),
    table('energy', ['kinetic', 'potential', 'total'].map((n) => ({ name: `energy.${n}`, unit: 'J', element: null })),
      (t) => { const [k, p] = energy(t); return [k, p, k + p]; }),
  ];
}

function parts() {
  const part = (id, mass, cm, inertia, parent, joint) => ({ id, ground: false, mass, cm, inertia, parent, joint });
  return [
    { id: 'PART/1', ground: true, mass: 0, cm: [0, 0, 0], inertia: [0, 0, 0, 0, 0, 0], parent: null, joint: null },
    part('PART/2', 2, [50, 0, 0], [300, 2000, 2000, 0, 0, 0], 'PART/1', 'REVOLUTE'),
    part('PART/3', 1.2, [125, 0, 0], [100, 6670, 6670, 0, 0, 0], 'PART/2', 'REVOLUTE'),
    part('PART/4', 0.8, [0, 0, 0], [300, 300, 300, 0, 0, 0], 'PART/1', 'TRANSLATIONAL'),
  ];
}

const uniform = Array.from({ length: rows }, (_, k) => (k * end) / (rows - 1));

export function sliderCrank(times = uniform) {
  const blocks = new Blocks(true);
  const marker = (id, part, x = 0, y = 0, q = [1, 0, 0, 0]) => ({ id, part, pose: [x, y, 0, ...q] });
  const alongX = [Math.SQRT1_2, 0, Math.SQRT1_2, 0];
  const report = {
    format: 1, title: 'Slider-crank', units: { length: 'mm', force: 'N', mass: 'kg', time: 's' },
    text: {
      dataset: 'Slider-crank\nUNITS/FORCE = NEWTON\nEND\n', file: 'slider_crank.adm', options: [['--end', '2'], ['--steps', '200']],
      versions: [['jprim', '0.2.0'], ['Simbody', '3.7.0']], summary: ['0 degrees of freedom', 'largest constraint error 2.1e-12 in JOINT/2'],
      analysis: ['Gruebler count -3', 'redundant equations: JOINT/4 about x, y'], freedoms: 0,
      warnings: [{ severity: 'warning', where: 'slider_crank.adm:12:3', message: 'PART/4 has no inertia: it is given a little' }],
    },
    gravity: [0, -9810, 0], parts: parts(),
    markers: [marker(10, 0), marker(11, 0, 0, 0, alongX), marker(20, 1), marker(21, 1, crank), marker(30, 2), marker(31, 2, rod), marker(40, 3), marker(41, 3, 0, 0, alongX),
      marker(42, 3, -30, -20)],
    elements: [element(1, 'REVOLUTE', 20, 10, 0), element(2, 'REVOLUTE', 30, 21, 6), element(3, 'SPHERICAL', 31, 40, 12), element(4, 'TRANSLATIONAL', 41, 11, 18),
      element(1, 'ROTATIONAL', 20, 10, 24, 'MOTION')],
    graphics: [{ id: 'GRAPHICS/1', shape: 'BOX', marker: 42, values: { x: 60, y: 40, z: 30 } }],
    flexible: [],
    frames: { time: blocks.array('f64', [times.length], times), poses: blocks.array('f32', [times.length, 4, 7], times.flatMap((t) => posesAt(t).flat())) },
    tables: tables(blocks, times),
  };
  return { report, blocks };
}
