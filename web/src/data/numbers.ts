// SPDX-License-Identifier: Apache-2.0

/** A number to read: five significant digits. */
export function shortNumber(value: number): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? '–' : value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 1e6 || size < 1e-3 ? exponential(value) : trimZeros(value.toPrecision(5));
  return text.replace(/-/g, '−');
}

function trimZeros(text: string): string {
  return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

function exponential(value: number): string {
  const [mantissa, exponent] = value.toExponential(3).split('e');
  return `${trimZeros(mantissa)}e${Number(exponent)}`;
}

export function withUnit(value: number, unit: string): string {
  return unit ? `${shortNumber(value)} ${unit}` : shortNumber(value);
}

const secondsPerUnit: Record<string, number> = {
  s: 1, second: 1, sec: 1, ms: 1e-3, millisecond: 1e-3, us: 1e-6, ns: 1e-9, min: 60, minute: 60, h: 3600, hour: 3600, day: 86400,
};

export function secondsPer(unit: string): number {
  return secondsPerUnit[unit.toLowerCase()] ?? 1;
}

/** The largest of 1, 2, 5 times a power of ten that is not above the value. */
export function niceBelow(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = value / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

/** `id` with its kind in words: "JOINT/1 revolute". */
export function words(text: string | null | undefined): string {
  return (text ?? '').toLowerCase().replace(/_/g, ' ');
}
