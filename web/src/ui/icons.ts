// SPDX-License-Identifier: Apache-2.0

const paths = {
  play: 'M4 2.5v11l9.5-5.5z',
  pause: 'M3.5 2.5h3.2v11H3.5zM9.3 2.5h3.2v11H9.3z',
  back: 'M3 3h2v10H3zM13 3v10L6 8z',
  on: 'M11 3h2v10h-2zM3 3v10l7-5z',
  loop: 'M8 2.5a5.5 5.5 0 0 1 5.2 3.7l1.3-.6-.6 4.1-3.5-2.1 1.3-.6A4 4 0 1 0 11.6 10l1.4.8A5.5 5.5 0 1 1 8 2.5z',
};

export const svgName = 'http://www.w3.org/2000/svg';

export function svg(name: string, attributes: Record<string, string | number>, ...children: Node[]): SVGElement {
  const element = document.createElementNS(svgName, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  element.append(...children);
  return element;
}

export function icon(name: keyof typeof paths): SVGElement {
  return svg('svg', { viewBox: '0 0 16 16', width: 16, height: 16, class: 'icon', 'aria-hidden': 'true' }, svg('path', { d: paths[name] }));
}
