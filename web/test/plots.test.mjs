// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { openBrowser, openPage } from './support/browser.mjs';
import { digits, everything, hostile } from './support/everything.mjs';
import { fillPage, writePage } from './support/page.mjs';
import { sliderCrank } from './support/sliderCrank.mjs';

let browser;
let close;
let page;
let trouble;
const folder = mkdtempSync(join(tmpdir(), 'jprim-downloads-'));

before(async () => {
  ({ browser, close } = await openBrowser());
  ({ page, trouble } = await open(sliderCrank()));
});
after(async () => {
  assert.deepEqual(trouble, []);
  await close();
});

const open = ({ report, blocks }) => openPage(browser, writePage(fillPage(report, blocks)));
const plots = (on = page) => on.evaluate(() => window.jprim.getPlots());

test('the first page has the request, the largest forces and the energy', async () => {
  assert.deepEqual(await plots(), [
    { columns: ['slider.X'] }, { columns: ['JOINT/1.I.FM', 'JOINT/2.I.FM', 'JOINT/4.I.FM'] }, { columns: ['energy.kinetic', 'energy.potential', 'energy.total'] },
  ]);
});

test('without requests it has the parts that move most', async () => {
  const data = sliderCrank();
  data.report.tables = data.report.tables.slice(1);
  const other = await open(data);
  assert.match((await plots(other.page))[0].columns[0], /^PART\/3\.[XY]/);
  await other.page.close();
});

test('the worst constraint error is plotted if it is there', async () => {
  const other = await open(everything());
  assert.deepEqual((await plots(other.page)).at(-1), { columns: ['constraint error'] });
  await other.page.close();
});

test('a curve is found by typing, with the keyboard alone', async () => {
  await page.focus('canvas');
  await page.keyboard.press('/');
  await page.keyboard.type('joint/3 fy');
  assert.match(await page.$eval('.suggestions [aria-selected=true]', (e) => e.textContent), /JOINT\/3\.I\.FY/);
  await page.keyboard.press('Enter');
  assert.deepEqual((await plots())[0].columns, ['slider.X', 'JOINT/3.I.FY']);
  assert.equal(await page.$$eval('.plot:first-child .u-axis', (axes) => axes.length), 3);
});

test('Shift and Enter opens a new plot', async () => {
  await page.focus('.search input');
  await page.keyboard.type('slider.vx');
  await page.keyboard.down('Shift');
  await page.keyboard.press('Enter');
  await page.keyboard.up('Shift');
  assert.deepEqual((await plots()).at(-1), { columns: ['slider.VX'] });
  await page.keyboard.press('Escape');
});

test('a curve and a plot can be removed', async () => {
  await page.click('.plot:last-child [aria-label="Remove slider.VX"]');
  assert.deepEqual((await plots()).at(-1), { columns: [] });
  await page.click('.plot:last-child [aria-label="Close this plot"]');
  assert.equal((await plots()).length, 3);
});

test('a click in a plot goes to that moment, and its cursor stays there', async () => {
  const box = await (await page.$('.plot .u-over')).boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + 10);
  const t = await page.evaluate(() => window.jprim.getTime());
  assert.ok(Math.abs(t - 1) < 0.03, String(t));
  const cursor = await (await page.$('.plot .time-cursor')).boundingBox();
  assert.ok(Math.abs(cursor.x - (box.x + box.width / 2)) < 2);
});

test('a click on a curve, or on its name, selects its element', async () => {
  await page.click('.plot:nth-child(2) .legend li:nth-child(2) .name');
  assert.equal(await page.evaluate(() => window.jprim.getSelection()), 'JOINT/2');
  const box = await (await page.$('.plot:nth-child(2) .u-over')).boundingBox();
  const y = await page.evaluate(() => {
    const canvas = document.querySelector('.plot:nth-child(2) canvas');
    const over = document.querySelector('.plot:nth-child(2) .u-over');
    const x = over.offsetLeft + Math.round(over.offsetWidth * 0.4);
    const pixels = canvas.getContext('2d').getImageData(x, 0, 1, canvas.height).data;
    const blue = Array.from({ length: canvas.height }, (_, k) => pixels[4 * k + 3] > 200 && pixels[4 * k + 2] > 150 && pixels[4 * k] < 60);
    return blue.indexOf(true) + 1 - over.offsetTop;
  });
  await page.mouse.click(box.x + Math.round(box.width * 0.4), box.y + y);
  assert.equal(await page.evaluate(() => window.jprim.getSelection()), 'JOINT/1');
});

test('a drag in a plot zooms, a double click shows all', async () => {
  const ends = () => page.$eval('.plot .time-cursor', (e) => new DOMMatrix(getComputedStyle(e).transform).e);
  await page.evaluate(() => window.jprim.setTime(0.9));
  const before = await ends();
  const box = await (await page.$('.plot .u-over')).boundingBox();
  await page.mouse.move(box.x + box.width * 0.4, box.y + 30);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.6, box.y + 40, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction((x) => Math.abs(new DOMMatrix(getComputedStyle(document.querySelector('.plot .time-cursor')).transform).e - x) > 5, {}, before);
  await page.mouse.click(box.x + 20, box.y + 20, { count: 2 });
  await page.evaluate(() => window.jprim.setTime(0.9));
  await page.waitForFunction((x) => Math.abs(new DOMMatrix(getComputedStyle(document.querySelector('.plot .time-cursor')).transform).e - x) < 1, {}, before);
});

test('the table leads to the largest force: moment, element and curve', async () => {
  const [name, value, when] = await page.$$eval('.largest tbody tr:first-child td', (cells) => cells.slice(0, 3).map((cell) => cell.textContent));
  assert.match(name, /^JOINT\/1 on I/);
  await page.click('.largest tbody tr:first-child');
  const t = await page.evaluate(() => window.jprim.getTime());
  assert.ok(Math.abs(t - Number(when)) < 1e-3);
  assert.equal(await page.evaluate(() => window.jprim.getSelection()), 'JOINT/1');
  assert.match(await page.$eval('.legend li.chosen', (e) => e.textContent), new RegExp(`JOINT/1.I.FM .*${value}`));
  assert.match(await page.$eval('.card', (e) => e.textContent), new RegExp(`I.FM${value} N`));
});

test('CSV has all digits, and quotes names', async () => {
  const other = await open(everything());
  const csv = await other.page.evaluate((name) => {
    window.jprim.addCurve('requests', name);
    window.jprim.addCurve('requests', 'R1.F2');
    return window.jprim.exportCsv();
  }, hostile.request);
  const lines = csv.trim().split('\n');
  assert.equal(lines[0], `time,"${hostile.request.replaceAll('"', '""')}",R1.F2`);
  lines.slice(1).forEach((line, k) => assert.equal(Number(line.split(',')[1]), digits(k)));
  assert.deepEqual([lines[4], lines[5]].map((line) => line.split(',')[2]), ['inf', 'nan']);
  assert.equal(lines.length, 22);
  await other.page.close();
});

async function downloadBy(selector) {
  const session = await browser.target().createCDPSession();
  await session.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: folder, eventsEnabled: true });
  let name;
  session.on('Browser.downloadWillBegin', (event) => (name = event.suggestedFilename));
  const done = new Promise((resolve) => session.on('Browser.downloadProgress', (event) => event.state === 'completed' && resolve()));
  await page.click(selector);
  await done;
  await session.detach();
  return { name, bytes: readFileSync(join(folder, name)) };
}

const isPng = (bytes) => bytes.subarray(1, 4).toString() === 'PNG' && bytes.length > 3000;

test('saves curves as CSV, and plot and picture as PNG', async () => {
  const csv = await downloadBy('.plot:nth-child(2) [aria-label^="Save these curves"]');
  assert.equal(csv.name, 'Slider-crank.csv');
  assert.match(csv.bytes.toString(), /^time,JOINT\/1\.I\.FM,JOINT\/2\.I\.FM,JOINT\/4\.I\.FM\n0,/);
  const plot = await downloadBy('.plot:nth-child(2) [aria-label^="Save this plot"]');
  assert.ok(plot.name.endsWith('.png') && isPng(plot.bytes));
  const picture = await downloadBy('.view-tools [aria-label^="Save the picture"]');
  assert.ok(picture.name.endsWith('.png') && isPng(picture.bytes));
});
