// SPDX-License-Identifier: Apache-2.0
// Prints sizes and speeds; judges nothing.
import { statSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { openBrowser, openPage } from './support/browser.mjs';
import { chain } from './support/chain.mjs';
import { fillPage, pageFile, writePage } from './support/page.mjs';

const megabytes = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;

/** Processor time of all of Chromium's processes so far [s]; on a busy machine it says more than the clock. */
async function processorTime(browser) {
  const session = await browser.target().createCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  return Object.fromEntries(['renderer', 'GPU'].map((type) =>
    [type, processInfo.filter((process) => process.type === type).reduce((sum, process) => sum + process.cpuTime, 0)]));
}

async function measured(browser, action) {
  const before = await processorTime(browser);
  const start = performance.now();
  const result = await action();
  const wall = (performance.now() - start) / 1000;
  const after = await processorTime(browser);
  return { result, wall, page: after.renderer - before.renderer, graphics: after.GPU - before.GPU };
}

async function measureOpening(browser, name, { report, blocks }) {
  const address = writePage(fillPage(report, blocks));
  const { result, wall, page, graphics } = await measured(browser, () => openPage(browser, address));
  console.log(`${name}: file ${megabytes(statSync(fileURLToPath(address)).size)}, open and drawn after ${wall.toFixed(2)} s; ` +
    `processor time of the page ${page.toFixed(2)} s, of drawing ${graphics.toFixed(2)} s`);
  await result.page.close();
}

async function measureFrames(browser, parts) {
  const { report, blocks } = chain(parts, 500);
  const { page } = await openPage(browser, writePage(fillPage(report, blocks)), { width: 1280, height: 720 });
  const { result, wall, page: inPage, graphics } = await measured(browser, () => page.evaluate(async () => {
    const before = window.jprim.renderInfo().frames;
    window.jprim.play();
    await new Promise((done) => setTimeout(done, 4000));
    window.jprim.pause();
    return window.jprim.renderInfo().frames - before;
  }));
  const perFrame = (seconds) => ((1000 * seconds) / result).toFixed(1);
  console.log(`${parts} parts: ${(result / wall).toFixed(1)} frames/s at 1280 x 720; processor time of a frame: ` +
    `page ${perFrame(inPage)} ms, drawing ${perFrame(graphics)} ms`);
  await page.close();
}

const { browser, close } = await openBrowser();
try {
  console.log(`page without data: ${statSync(pageFile).size} bytes`);
  await measureOpening(browser, '100 parts, 1000 frames', chain(100, 1000));
  await measureOpening(browser, '1000 parts, 1000 frames, poses only', { ...withoutTables(chain(1000, 1000)) });
  await measureOpening(browser, '1000 parts, 1000 frames, with 6000 columns of reactions', chain(1000, 1000));
  for (const parts of [10, 100, 1000]) await measureFrames(browser, parts);
} finally {
  await close();
}

function withoutTables(data) {
  data.report.tables = [];
  data.report.elements.forEach((element) => (element.loadOnI = null));
  data.blocks.dropLast();
  return data;
}
