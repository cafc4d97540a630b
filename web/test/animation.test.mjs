// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { nextFrame, openBrowser, openPage } from './support/browser.mjs';
import { fillPage, writePage } from './support/page.mjs';
import { posesAt, sliderCrank } from './support/sliderCrank.mjs';

let browser;
let close;
let page;
let trouble;

before(async () => {
  ({ browser, close } = await openBrowser());
  const { report, blocks } = sliderCrank();
  ({ page, trouble } = await openPage(browser, writePage(fillPage(report, blocks))));
});
after(async () => {
  assert.deepEqual(trouble, []);
  await close();
});

const time = () => page.evaluate(() => window.jprim.getTime());
const setTime = (t) => page.evaluate((value) => window.jprim.setTime(value), t);
const selection = () => page.evaluate(() => window.jprim.getSelection());

function matrixOf([x, y, z, w, i, j, k]) {
  return [
    1 - 2 * (j * j + k * k), 2 * (i * j + w * k), 2 * (i * k - w * j), 0, 2 * (i * j - w * k), 1 - 2 * (i * i + k * k), 2 * (j * k + w * i), 0,
    2 * (i * k + w * j), 2 * (j * k - w * i), 1 - 2 * (i * i + j * j), 0, x, y, z, 1,
  ];
}

async function assertDrawnAt(t, tolerance) {
  await setTime(t);
  for (const [part, pose] of posesAt(t).entries()) {
    if (part === 0) continue;
    const drawn = await page.evaluate((id) => window.jprim.getPartMatrix(id), `PART/${part + 1}`);
    matrixOf(pose).forEach((value, k) => assert.ok(Math.abs(value - drawn[k]) <= tolerance * (k >= 12 ? 300 : 1), `PART/${part + 1} at ${t}: ${k}: ${drawn[k]}, not ${value}`));
  }
}

test('draws the parts where the data has them', async () => {
  for (const t of [0, 0.01, 0.37, 1, 1.99, 2]) await assertDrawnAt(t, 1e-6);
});

test('interpolates between output times', async () => {
  for (const t of [0.005, 0.3333, 1.2345]) await assertDrawnAt(t, 3e-4);
});

test('the picture shows them there', async () => {
  const { x, y } = await (await page.$('.picture canvas')).boundingBox();
  for (const t of [0.8, 1.4]) {
    await setTime(t);
    await page.waitForFunction(() => window.jprim.renderInfo().atRest);
    for (const [id, [red, green, blue]] of Object.entries({ 'PART/3': [238, 221, 136], 'PART/2': [68, 187, 153] })) {
      const at = await page.evaluate((name) => window.jprim.getScreenPosition(name), id);
      const clip = { x: Math.round(x + at.x), y: Math.round(y + at.y), width: 1, height: 1 };
      const seen = await pixelOf(await page.screenshot({ clip, encoding: 'base64' }));
      const ratio = (a, b) => Math.abs(a[0] / a[2] - b[0] / b[2]) / (b[0] / b[2]);
      assert.ok(ratio(seen, [red, green, blue]) < 0.35, `${id} at ${t}: ${seen}`);
    }
  }
});

const pixelOf = (data) => page.evaluate(async (base64) => {
  const image = new Image();
  image.src = `data:image/png;base64,${base64}`;
  await image.decode();
  const context = new OffscreenCanvas(1, 1).getContext('2d');
  context.drawImage(image, 0, 0);
  return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3);
}, data);

test('plays with the space bar, and pauses', async () => {
  await setTime(0);
  await page.focus('canvas');
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.jprim.getTime() > 0.05);
  await page.keyboard.press('Space');
  const stopped = await time();
  await nextFrame(page);
  assert.equal(await time(), stopped);
});

test('plays and pauses by the button, which space presses once', async () => {
  await setTime(0.5);
  await page.focus('.play');
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.jprim.getTime() > 0.55);
  await page.click('.play');
  assert.equal(await page.$eval('.play', (e) => e.ariaPressed), 'false');
});

test('steps with the arrows, and goes to both ends', async () => {
  await setTime(0.505);
  await page.focus('canvas');
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await time()) - 0.51) < 1e-12);
  await page.keyboard.press('ArrowLeft');
  assert.ok(Math.abs((await time()) - 0.5) < 1e-12);
  await page.keyboard.press('End');
  assert.equal(await time(), 2);
  await page.keyboard.press('Home');
  assert.equal(await time(), 0);
});

test('scrubs with the mouse on the bar of time', async () => {
  const box = await (await page.$('.scrub')).boundingBox();
  await page.mouse.move(box.x + 10, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs((await time()) - 1) < 0.02, String(await time()));
});

test('goes to a time that is typed', async () => {
  await page.click('.time', { count: 3 });
  await page.keyboard.type('1.25');
  await page.keyboard.press('Enter');
  assert.equal(await time(), 1.25);
});

async function clickOn(id, dx = 0, dy = 0) {
  await nextFrame(page);
  const at = await page.evaluate((name) => window.jprim.getScreenPosition(name), id);
  const box = await (await page.$('.picture canvas')).boundingBox();
  await page.mouse.click(box.x + at.x + dx, box.y + at.y + dy);
}

test('a click in the picture selects in the picture, the tree and the table', async () => {
  await setTime(0.8);
  await clickOn('PART/3');
  assert.equal(await selection(), 'PART/3');
  assert.equal(await page.$eval('.name-label', (e) => e.textContent), 'PART/3');
  assert.equal(await page.$eval('.tree [aria-current=true]', (e) => e.firstChild.textContent), 'PART/3');
  await clickOn('JOINT/2');
  assert.equal(await selection(), 'JOINT/2');
  assert.match(await page.$eval('.largest tr.chosen', (e) => e.textContent), /JOINT\/2/);
  assert.match(await page.$eval('.legend li.chosen', (e) => e.textContent), /JOINT\/2/);
});

test('a click beside everything, and Escape, select nothing', async () => {
  const box = await (await page.$('.picture canvas')).boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height - 40);
  assert.equal(await selection(), null);
  await page.evaluate(() => window.jprim.select('PART/2'));
  await page.focus('canvas');
  await page.keyboard.press('Escape');
  assert.equal(await selection(), null);
});

test('a click in the tree selects', async () => {
  await page.click('#tab-1');
  await (await page.$('.tree ::-p-text(JOINT/4)')).click();
  assert.equal(await selection(), 'JOINT/4');
  await page.evaluate(() => window.jprim.select(null));
});

test('a drag orbits and selects nothing; F, 1 to 4 change the view', async () => {
  const before = await page.evaluate(() => window.jprim.getScreenPosition('PART/4'));
  const box = await (await page.$('.picture canvas')).boundingBox();
  await page.mouse.move(box.x + 300, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 420, box.y + 240, { steps: 5 });
  await page.mouse.up();
  await nextFrame(page);
  const turned = await page.evaluate(() => window.jprim.getScreenPosition('PART/4'));
  assert.notDeepEqual(turned, before);
  assert.equal(await selection(), null);
  const seen = new Set([JSON.stringify(turned)]);
  for (const key of ['1', '2', '3', '4']) {
    await page.keyboard.press(key);
    await nextFrame(page);
    seen.add(JSON.stringify(await page.evaluate(() => window.jprim.getScreenPosition('PART/4'))));
  }
  assert.equal(seen.size, 5);
});

test('shows and hides layers, and single parts', async () => {
  const visible = (kind) => page.evaluate((k) => window.jprim.getDrawnShapes().some((shape) => shape.kind === k && shape.visible), kind);
  await page.click('#tab-2');
  assert.equal(await visible('BOX'), true);
  assert.equal(await visible('MARKER'), false);
  await (await page.$('.show label ::-p-text(Markers)')).click();
  await (await page.$('.show label ::-p-text(Forces on I)')).click();
  assert.equal(await visible('MARKER'), true);
  assert.equal(await visible('FORCE'), false);
  await page.evaluate(() => window.jprim.select('PART/4'));
  await (await page.$('.card ::-p-text(Hide)')).click();
  assert.equal(await visible('BOX'), false);
  await (await page.$('.card ::-p-text(Hide)')).click();
  assert.equal(await visible('BOX'), true);
});

test('draws the picture only when something changed', async () => {
  await page.evaluate(() => window.jprim.select(null));
  await page.waitForFunction(() => window.jprim.renderInfo().atRest);
  await nextFrame(page);
  const frames = () => page.evaluate(() => window.jprim.renderInfo().frames);
  const before = await frames();
  for (let k = 0; k < 5; ++k) await nextFrame(page);
  assert.equal(await frames(), before);
});

test('steps over a moment that is there twice, to both sides', async () => {
  const { report, blocks } = sliderCrank([0, 0.5, 1, 1, 1.5, 2]);
  const opened = await openPage(browser, writePage(fillPage(report, blocks)));
  await opened.page.focus('canvas');
  const visited = [];
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft']) {
    await opened.page.keyboard.press(key);
    visited.push(await opened.page.evaluate(() => window.jprim.getTime()));
  }
  assert.deepEqual(visited, [0.5, 1, 1.5, 2, 2, 1.5, 1, 0.5, 0, 0]);
  await opened.page.close();
});

test('plays once on opening, unless less motion is asked for', async () => {
  const { report, blocks } = sliderCrank();
  const opened = await openPage(browser, writePage(fillPage(report, blocks)), { reducedMotion: false });
  await opened.page.waitForFunction(() => window.jprim.getTime() === 2 && document.querySelector('.play').ariaPressed === 'false');
  await opened.page.close();
});
