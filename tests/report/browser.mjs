// SPDX-License-Identifier: Apache-2.0
// Opens the report of a run in Chromium and compares where parts are drawn with parts.csv.
//   node browser.mjs REPORT.html RESULTS_DIR NODE_MODULES SCREENSHOT.png [STRICT_TITLE]
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [report, results, modules, screenshot] = process.argv.slice(2);
const chromium = process.env.CHROMIUM ?? ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find((path) => existsSync(path));
const skip = (why) => {
  console.log(`skipped: ${why}`);
  process.exit(0);
};
if (!chromium) skip('there is no Chromium (Debian: chromium)');
if (!existsSync(join(modules, 'puppeteer-core'))) skip('puppeteer-core is missing: npm has not been run');

const failures = [];
const expect = (good, what) => good || failures.push(what);

function readParts() {
  const [header, ...rows] = readFileSync(join(results, 'parts.csv'), 'utf8').trim().split('\n');
  return { columns: header.split(','), rows: rows.map((row) => row.split(',').map(Number)) };
}

function readReport() {
  const [, json] = /<script type="application\/json" id="jprim-report">(.*?)<\/script>/s.exec(readFileSync(report, 'utf8'));
  return JSON.parse(json);
}

// Column-major, as three.js has them.
function matrixOf([x, y, z], [w, a, b, c]) {
  return [
    1 - 2 * (b * b + c * c), 2 * (a * b + w * c), 2 * (a * c - w * b), 0,
    2 * (a * b - w * c), 1 - 2 * (a * a + c * c), 2 * (b * c + w * a), 0,
    2 * (a * c + w * b), 2 * (b * c - w * a), 1 - 2 * (a * a + b * b), 0,
    x, y, z, 1];
}

function multiply(A, B) {
  return B.map((_, k) => [0, 1, 2, 3].reduce((sum, j) => sum + A[(k % 4) + 4 * j] * B[(k - (k % 4)) + j], 0));
}

// The CM marker of each part is the one whose origin is the mass centre and that the dataset names.
function findCmMarkers(data) {
  const markers = new Map();
  for (const [, part, id] of data.text.dataset.matchAll(/^PART\/(\d+)[^!\n]*\bCM\s*=\s*(\d+)/gm))
    markers.set(`PART/${Number(part)}`, data.markers.find((m) => m.id === Number(id)));
  return markers;
}

async function compare(page, data, parts, row) {
  const at = parts.rows[row];
  for (const [part, marker] of findCmMarkers(data)) {
    const first = parts.columns.indexOf(`${part}.X`);
    if (first < 0) continue;
    const drawn = await page.evaluate((time, id) => {
      window.jprim.setTime(time);
      return Array.from(window.jprim.getPartMatrix(id));
    }, at[0], part);
    const cm = multiply(drawn, matrixOf(marker.pose.slice(0, 3), marker.pose.slice(3)));
    const wanted = matrixOf(at.slice(first, first + 3), at.slice(first + 3, first + 7));
    const size = Math.max(1, ...wanted.slice(12, 15).map(Math.abs));
    const error = Math.max(...wanted.map((value, k) => Math.abs(value - cm[k]) / (k < 12 ? 1 : size)));
    expect(error < 1e-5, `${part} at ${at[0]} is drawn ${error} away`);
  }
}

const puppeteer = createRequire(pathToFileURL(join(resolve(modules), 'x.js')).href)('puppeteer-core');
const browser = await puppeteer.launch({
  executablePath: chromium, headless: true, protocolTimeout: 240_000,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});
try {
  const page = await browser.newPage();
  page.setDefaultNavigationTimeout(240_000);
  page.on('console', (m) => m.type() !== 'error' || failures.push(`console: ${m.text()}`));
  page.on('pageerror', (error) => failures.push(`error: ${error}`));
  page.on('dialog', (dialog) => (failures.push(`dialog: ${dialog.message()}`), dialog.dismiss()));
  const address = pathToFileURL(resolve(report)).href;
  page.on('request', (r) => r.url() === address || /^(data|blob):/.test(r.url()) || failures.push(`request: ${r.url()}`));
  await page.setViewport({ width: 1280, height: 720, deviceScaleFactor: 1 });
  await page.goto(address);
  await page.evaluate(() => window.jprim.ready);
  const data = readReport(), parts = readParts();
  expect((await page.title()).includes(data.title.trim()), `the title is ${await page.title()}`);
  const last = parts.rows.length - 1;
  for (const row of new Set([0, Math.floor(last / 3), Math.floor(last / 2), last])) await compare(page, data, parts, row);
  expect(!(await page.evaluate(() => 'hostile' in window)), 'a text of the dataset was run');
  await page.screenshot({ path: screenshot });
} finally {
  await browser.close();
}
for (const failure of failures) console.log(`failure: ${failure}`);
console.log(failures.length === 0 ? 'good' : 'bad');
process.exit(failures.length === 0 ? 0 : 1);
