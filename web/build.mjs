// SPDX-License-Identifier: Apache-2.0
// Makes report.html: one file with script, style and third-party licences inlined.
//   node build.mjs [--out DIR]
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const require = createRequire(import.meta.url);
const largestSize = 900_000;

function outputDirectory() {
  const option = process.argv.indexOf('--out');
  return option < 0 ? join(here, 'dist') : resolve(process.argv[option + 1]);
}

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(here, entry)],
    absWorkingDir: here,
    bundle: true,
    minify: true,
    write: false,
    outdir: 'unused',
    target: ['chrome100', 'firefox100', 'safari15.4'],
    charset: 'ascii',
    legalComments: 'none',
    logLevel: 'warning',
  });
  return result.outputFiles[0].text;
}

function packageDirectory(name) {
  const nested = require.resolve.paths(name).map((folder) => join(folder, name));
  return nested.find((folder) => {
    try {
      readFileSync(join(folder, 'package.json'));
      return true;
    } catch {
      return false;
    }
  });
}

function licence(name) {
  const folder = packageDirectory(name);
  const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  return `${name} ${version}\n\n${readFileSync(join(folder, 'LICENSE'), 'utf8').trim()}\n`;
}

const escapeText = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
// Inside a script only these sequences could end it or change how it is read.
const escapeScript = (text) => text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

const parts = {
  STYLE: (await bundle('src/style.css')).replaceAll('</style', '<\\/style'),
  SCRIPT: escapeScript(await bundle('src/main.ts')),
  LICENCES: escapeText(['three', 'uplot'].map(licence).join('\n')),
};
const template = readFileSync(join(here, 'src/report.html'), 'utf8');
const page = template.replace(/<!--JPRIM-(STYLE|SCRIPT|LICENCES)-->/g, (_, name) => parts[name]);

if (page.split('<!--JPRIM-DATA-->').length !== 2) throw new Error('the place for the data must be there exactly once');
const size = Buffer.byteLength(page);
if (size > largestSize) throw new Error(`the page has ${size} bytes, more than ${largestSize}`);
const directory = outputDirectory();
mkdirSync(directory, { recursive: true });
writeFileSync(join(directory, 'report.html'), page);
console.log(`${join(directory, 'report.html')}: ${size} bytes`);
