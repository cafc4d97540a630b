// SPDX-License-Identifier: Apache-2.0
// Colours that stay apart for readers with any kind of colour vision, for a light and a dark background.
import { Color } from 'three';

// P. Tol's scheme "light", without its greys.
const parts = ['#77aadd', '#44bb99', '#eedd88', '#ffaabb', '#99ddff', '#bbcc33', '#ee8866'];
// M. Okabe and K. Ito.
const curvesOnLight = ['#0072b2', '#d55e00', '#007a58', '#b0508a', '#b07800', '#3a8fc4', '#555555'];
const curvesOnDark = ['#5ab4f0', '#ff8a3d', '#2cc79a', '#e39ac4', '#f0b83a', '#8fd0f8', '#bbbbbb'];

const darkScheme = matchMedia('(prefers-color-scheme: dark)');

export const isDark = () => darkScheme.matches;
export const onSchemeChange = (callback: () => void) => darkScheme.addEventListener('change', callback);

export const partColor = (index: number) => new Color(parts[index % parts.length]);
export const curveColor = (index: number) => (isDark() ? curvesOnDark : curvesOnLight)[index % curvesOnLight.length];

export const roles = {
  ground: new Color('#9aa3ad'),
  free: new Color('#0b9a6d'),
  held: new Color('#7a35c9'),
  force: new Color('#e0480c'),
  torque: new Color('#9446d6'),
  spring: new Color('#8a929c'),
  motion: new Color('#c97a00'),
  white: new Color('#ffffff'),
  selected: new Color('#ff9d00'),
};

export const background = () => new Color(isDark() ? '#14181d' : '#f4f6f8');
export const gridColors = () => (isDark() ? ['#3a434d', '#262d35'] : ['#b9c2cb', '#dde3e8']);
