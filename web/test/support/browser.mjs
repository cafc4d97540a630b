// SPDX-License-Identifier: Apache-2.0
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';

const flags = [
  '--no-sandbox', '--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic',
  '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--force-color-profile=srgb',
];

export async function openBrowser() {
  const profile = mkdtempSync(join(tmpdir(), 'jprim-chromium-'));
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true, args: flags, userDataDir: profile, protocolTimeout: 240_000,
  });
  return { browser, close: async () => {
    await browser.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  } };
}

/** Opens a page and records what must not happen: errors, dialogs, requests for anything but the page itself. */
export async function openPage(browser, address, { width = 1280, height = 720, dark = false, mobile = false, reducedMotion = true } = {}) {
  const page = await browser.newPage();
  page.setDefaultNavigationTimeout(120_000);
  const trouble = [];
  const requests = [];
  page.on('console', (message) => ['error', 'warn'].includes(message.type()) && !isDriverRemark(message.text()) && trouble.push(message.text()));
  page.on('pageerror', (error) => trouble.push(String(error)));
  page.on('dialog', (dialog) => {
    trouble.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on('request', (request) => /^(data|blob):/.test(request.url()) || requests.push(request.url()));
  await page.setViewport({ width, height, deviceScaleFactor: 1, isMobile: mobile, hasTouch: mobile });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
    { name: 'prefers-reduced-motion', value: reducedMotion ? 'reduce' : 'no-preference' }]);
  await page.goto(address);
  await page.evaluate(() => window.jprim.ready);
  await nextFrame(page);
  return { page, trouble, requests };
}

// Reading pixels back is slow on some drivers, which Chromium remarks on; that is no fault of the page.
const isDriverRemark = (text) => /GPU stall due to ReadPixels/.test(text);

export function nextFrame(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
}
