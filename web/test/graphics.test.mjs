// SPDX-License-Identifier: Apache-2.0
// Each kind of graphics is to be seen: a page with it alone, and a screenshot of its picture.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { nextFrame, openBrowser, openPage } from './support/browser.mjs';
import { everything, graphics } from './support/everything.mjs';
import { fillPage, writePage } from './support/page.mjs';

let browser;
let close;
before(async () => ({ browser, close } = await openBrowser()));
after(() => close());

const shots = join(dirname(fileURLToPath(import.meta.url)), 'shots');
mkdirSync(shots, { recursive: true });

const overlays = '.view-tools, .axes, .picture-key, .card, .name-label { visibility: hidden }';

/** Pixels of the picture that differ from its most frequent colour. */
async function pixels(page, name) {
  await page.addStyleTag({ content: overlays });
  await nextFrame(page);
  const image = await (await page.$('.picture')).screenshot({ encoding: 'base64' });
  writeFileSync(join(shots, `${name}.png`), Buffer.from(image, 'base64'));
  return page.evaluate(async (data) => {
    const picture = new Image();
    picture.src = `data:image/png;base64,${data}`;
    await picture.decode();
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const words = new Uint32Array(context.getImageData(0, 0, picture.width, picture.height).data.buffer);
    const counts = new Map();
    for (const word of words) counts.set(word, (counts.get(word) ?? 0) + 1);
    return words.length - Math.max(...counts.values());
  }, image);
}

async function openWith(shapes, options, layers) {
  const { report, blocks } = everything(shapes, options);
  if (shapes.length > 0) for (const part of report.parts) part.mass = 0;
  const opened = await openPage(browser, writePage(fillPage(report, blocks)), { width: 900, height: 700 });
  await opened.page.click('#tab-2');
  await opened.page.$$eval('.show .check', (labels, kept) => {
    for (const label of labels) {
      const wanted = kept.some((name) => label.textContent.startsWith(name));
      if (label.querySelector('input').checked !== wanted) label.querySelector('input').click();
    }
  }, layers);
  return opened;
}

const hideOthers = (page, ids) => page.evaluate(async (hidden) => {
  for (const id of hidden) {
    window.jprim.select(id);
    [...document.querySelectorAll('.card button')].find((button) => button.textContent === 'Hide').click();
  }
  window.jprim.select(null);
}, ids);

for (const shape of Object.keys(graphics)) {
  test(`draws ${shape}`, async () => {
    const { page, trouble } = await openWith([shape], { withFlexible: false, withElements: false }, ['Parts', 'Springs']);
    await hideOthers(page, shape === 'SPDP' ? ['PART/3', 'FLEX_BODY/3'] : ['PART/3', 'FLEX_BODY/3']);
    const drawn = await page.evaluate((kind) => window.jprim.getDrawnShapes().filter((s) => s.kind === kind), shape);
    assert.ok(drawn.length > 0 && drawn.every((s) => s.id === 'GRAPHICS/1' || shape === 'SPDP'), JSON.stringify(drawn));
    assert.ok(drawn.some((s) => s.visible));
    const count = await pixels(page, shape);
    assert.ok(count > 400, `${count} pixels`);
    assert.deepEqual(trouble, []);
    await page.close();
  });
}

test('draws a part without graphics by its links and inertia', async () => {
  const { page } = await openWith([], { withFlexible: false }, ['Parts']);
  await hideOthers(page, ['PART/3', 'FLEX_BODY/3']);
  const kinds = await page.evaluate(() => window.jprim.getDrawnShapes().filter((s) => s.id === 'PART/2' && s.visible).map((s) => s.kind));
  assert.deepEqual([...new Set(kinds)].sort(), ['INERTIA', 'LINK']);
  assert.ok((await pixels(page, 'INERTIA')) > 1000);
  await page.close();
});

test('draws a flexible body that deforms, more with a larger scale', async () => {
  const { page } = await openWith([], { withElements: false }, ['Parts']);
  await hideOthers(page, ['PART/2', 'PART/3']);
  await page.evaluate(() => window.jprim.setTime(0.25));
  const atMarker = () => page.evaluate(() => window.jprim.getScreenPosition('MARKER/40'));
  const before = await atMarker();
  const plain = await pixels(page, 'FLEXIBLE');
  assert.ok(plain > 1000, `${plain} pixels`);
  await page.$eval('.slider input[aria-label=Deformation]', (input) => {
    input.value = '0.5';
    input.dispatchEvent(new Event('input'));
  });
  await nextFrame(page);
  assert.ok(Math.abs((await atMarker()).y - before.y) > 3);
  await pixels(page, 'FLEXIBLE-scaled');
  await page.close();
});

test('draws a flexible body of points alone', async () => {
  const { report, blocks } = everything([], { withElements: false });
  delete report.flexible[0].faces;
  delete report.flexible[0].edges;
  const { page, trouble } = await openPage(browser, writePage(fillPage(report, blocks)), { width: 900, height: 700 });
  await page.click('#tab-2');
  await (await page.$('.show label ::-p-text(Grid)')).click();
  await hideOthers(page, ['PART/2', 'PART/3']);
  assert.ok((await pixels(page, 'FLEXIBLE-points')) > 100);
  assert.deepEqual(trouble, []);
  await page.close();
});

test('draws symbols, springs, markers and arrows of loads', async () => {
  const { page, trouble } = await openWith([], {}, ['Joints', 'Springs', 'Markers', 'Forces', 'Torques']);
  await page.evaluate(() => window.jprim.setTime(0.5));
  const kinds = await page.evaluate(() => [...new Set(window.jprim.getDrawnShapes().filter((s) => s.visible).map((s) => s.kind))]);
  for (const kind of ['JOINT core', 'JOINT rotation', 'JOINT translation', 'JPRIM rotation', 'JPRIM translation', 'MOTION symbol', 'GCON symbol', 'GFORCE symbol',
    'SPRINGDAMPER', 'SFORCE', 'BUSHING', 'MARKER', 'FORCE', 'TORQUE']) assert.ok(kinds.includes(kind), kind);
  assert.ok((await pixels(page, 'SYMBOLS')) > 1000);
  assert.deepEqual(trouble, []);
  await page.close();
});

test('draws the path of a point', async () => {
  const { page } = await openWith([], { withElements: false }, []);
  const before = await pixels(page, 'TRACE-before');
  await page.evaluate(() => window.jprim.select('MARKER/22'));
  await page.evaluate(() => [...document.querySelectorAll('.card button')].find((button) => button.textContent === 'Trace').click());
  await page.evaluate(() => window.jprim.select(null));
  assert.ok((await pixels(page, 'TRACE')) > before + 50);
  await page.close();
});
