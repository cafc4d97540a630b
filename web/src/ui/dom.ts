// SPDX-License-Identifier: Apache-2.0

type Child = Node | string | null | undefined | false;
type Properties<T> = Partial<Omit<T, 'style' | 'dataset' | 'attributes'>> & { attributes?: Record<string, string> };

/** Makes an element; text becomes text nodes and is never read as HTML. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K, properties: Properties<HTMLElementTagNameMap[K]> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  const { attributes, ...rest } = properties;
  Object.assign(element, rest);
  for (const [name, value] of Object.entries(attributes ?? {})) element.setAttribute(name, value);
  element.append(...children.filter((child): child is Node | string => Boolean(child)));
  return element;
}

export function button(label: string | Node, title: string, onclick: () => void, className = ''): HTMLButtonElement {
  return make('button', { type: 'button', title, onclick, className, ariaLabel: title }, label);
}

export function checkbox(label: string, checked: boolean, onchange: (checked: boolean) => void): HTMLLabelElement {
  const input = make('input', { type: 'checkbox', checked });
  input.onchange = () => onchange(input.checked);
  return make('label', { className: 'check' }, input, label);
}

/** A slider for a factor from a hundredth to a hundred, in equal ratios. */
export function factorSlider(label: string, onchange: (factor: number) => void, most = 100): HTMLElement {
  const limit = Math.log10(most);
  const shown = make('output', {}, '×1');
  const input = make('input', { type: 'range', min: String(-limit), max: String(limit), step: '0.05', value: '0', ariaLabel: label });
  input.oninput = () => {
    const factor = Number((10 ** Number(input.value)).toPrecision(2));
    shown.textContent = `×${factor}`;
    onchange(factor);
  };
  return make('label', { className: 'slider' }, make('span', {}, label), input, shown);
}

export function download(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = make('a', { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** A file name of the title, with only characters that every system takes. */
export function fileName(title: string, ending: string): string {
  const plain = title.replace(/[^\p{L}\p{N}._-]+/gu, '_').replace(/^[_.]+|_+$/g, '').slice(0, 60);
  return `${plain || 'report'}${ending}`;
}
