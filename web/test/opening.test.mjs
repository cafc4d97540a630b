// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { nextFrame, openBrowser, openPage } from './support/browser.mjs';
import { everything, hostile } from './support/everything.mjs';
import { fillPage, pageFile, writePage } from './support/page.mjs';
import { sliderCrank } from './support/sliderCrank.mjs';

let browser;
let close;
before(async () => ({ browser, close } = await openBrowser()));
after(() => close());

const filled = ({ report, blocks }) => writePage(fillPage(report, blocks));

test('is one file of at most 900 kB with one place for the data and the licences', () => {
  const html = readFileSync(pageFile, 'utf8');
  assert.ok(statSync(pageFile).size <= 900_000);
  assert.equal(html.split('<!--JPRIM-DATA-->').length, 2);
  assert.match(html, /three \d+\.\d+\.\d+[\s\S]*The MIT License[\s\S]*uplot \d+\.\d+\.\d+[\s\S]*The MIT License/);
  assert.doesNotMatch(html, /<script[^>]+src=|<link[^>]+href="(?!data:)/);
});

test('opens from disk without errors and without requests', async () => {
  const address = filled(sliderCrank());
  const { page, trouble, requests } = await openPage(browser, address);
  assert.match(address, /^file:/);
  assert.deepEqual(trouble, []);
  assert.deepEqual(requests, [address]);
  assert.equal(await page.$eval('h1', (e) => e.textContent), 'Slider-crank');
  await page.close();
});

test('without data says so', async () => {
  const { page, trouble } = await openPage(browser, writePage(readFileSync(pageFile, 'utf8')));
  assert.match(await page.$eval('#app', (e) => e.textContent), /no data/);
  assert.deepEqual(trouble, []);
  await page.close();
});

test('with data that cannot be read says what is wrong', async () => {
  const { report, blocks } = sliderCrank();
  report.frames.poses.block = 99;
  const opened = openPage(browser, writePage(fillPage(report, blocks)));
  await assert.rejects(opened, /block 99 is missing/);
  const [page] = (await browser.pages()).slice(-1);
  assert.match(await page.$eval('#app', (e) => e.textContent), /block 99 is missing/);
  await page.close();
});

test('shows names that look like HTML as text and runs nothing', async () => {
  const { page, trouble } = await openPage(browser, filled(everything()));
  for (const tab of await page.$$('[role=tab]')) await tab.click();
  await page.evaluate(() => window.jprim.select('REQUEST/1'));
  await nextFrame(page);
  const text = await page.evaluate(() => document.getElementById('app').textContent);
  for (const name of Object.values(hostile)) assert.ok(text.includes(name), name);
  assert.equal(await page.title(), `${hostile.title} – jprim`);
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.equal(await page.$('#app img, #app b, #app script'), null);
  assert.deepEqual(trouble, []);
  await page.close();
});

for (const [name, options] of Object.entries({ phone: { width: 360, height: 740, mobile: true }, dark: { dark: true } })) {
  test(`has no horizontal overflow: ${name}`, async () => {
    const { page, trouble } = await openPage(browser, filled(everything()), options);
    const tabs = await page.$$('[role=tab]');
    for (const tab of tabs) {
      await tab.click();
      const [scroll, client] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
      assert.equal(scroll, client);
    }
    assert.deepEqual(trouble, []);
    await page.close();
  });
}

test('every control has a name', async () => {
  const { page } = await openPage(browser, filled(everything()));
  const nameless = await page.$$eval('button, input, select, canvas[tabindex]', (controls) =>
    controls.filter((c) => !(c.ariaLabel || c.textContent.trim() || c.title || c.closest('label')?.textContent.trim())).map((c) => c.outerHTML));
  assert.deepEqual(nameless, []);
  await page.close();
});
