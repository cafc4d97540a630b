// SPDX-License-Identifier: Apache-2.0
// Fills the page with data as the command does.
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';

const web = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
export const pageFile = join(web, 'dist', 'report.html');

/** Collects the blocks of numbers of one page. */
export class Blocks {
  #texts = [];

  constructor(deflate = false) {
    this.deflate = deflate;
  }

  array(type, shape, numbers) {
    const typed = type === 'f64' ? Float64Array.from(numbers) : Float32Array.from(numbers);
    const bytes = Buffer.from(typed.buffer, typed.byteOffset, typed.byteLength);
    this.#texts.push((this.deflate ? deflateSync(bytes) : bytes).toString('base64'));
    return { block: this.#texts.length - 1, type, shape, ...(this.deflate ? { deflate: true } : {}) };
  }

  /** Leaves out the array that was added last. */
  dropLast() {
    this.#texts.pop();
  }

  html() {
    const element = (text, k) => `<script type="application/octet-stream;base64" id="jprim-data-${k}">${text}</script>`;
    return this.#texts.map(element).join('\n');
  }
}

export function fillPage(report, blocks) {
  const json = JSON.stringify(report).replaceAll('<', '\\u003c');
  const data = `<script type="application/json" id="jprim-report">${json}</script>\n${blocks.html()}`;
  return readFileSync(pageFile, 'utf8').replace('<!--JPRIM-DATA-->', () => data);
}

/** Writes a page into a new folder and gives its file:// address. */
export function writePage(html, name = 'report.html') {
  const file = join(mkdtempSync(join(tmpdir(), 'jprim-report-')), name);
  writeFileSync(file, html);
  return pathToFileURL(file).href;
}
