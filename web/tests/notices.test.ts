// Each package whose code stands in a page has its licence there.
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { noticesOf } from '../notices';

let folder: string;
beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'gw-notices-'))));
afterEach(() => rmSync(folder, { recursive: true }));

function written(path: string, text: string): string {
  const file = join(folder, path);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text);
  return file;
}
function made(path: string, files: Record<string, string>): string {
  const name = path.split('node_modules/').at(-1);
  written(`${path}/package.json`, JSON.stringify({ name, version: '1.2.3' }));
  for (const [file, text] of Object.entries(files)) written(`${path}/${file}`, text);
  return written(`${path}/dist/main.js`, '');
}

it('names each package once, with all that its licence says', () => {
  const a = made('node_modules/a', { LICENSE: 'MIT, by A\n', 'NOTICE.txt': 'after B' });
  const deep = made('node_modules/a/node_modules/@c/d', { 'licence.md': 'ISC, by D' });
  const files = [
    `\0${a}?commonjs-module`,
    deep,
    join(dirname(a), 'other.js'),
    join(folder, 'own.ts'),
    '\0virtual',
  ];
  expect(noticesOf(files)).toEqual(['@c/d 1.2.3\n\nISC, by D', 'a 1.2.3\n\nMIT, by A\n\nafter B']);
});

it('refuses a package without a licence, by its name', () => {
  const file = made('node_modules/@c/d', { 'README.md': 'MIT' });
  expect(() => noticesOf([file])).toThrow('@c/d has no licence; write it to web/notices/@c+d.txt');
});

it('has the licence of MicroPython, whose package has none', () => {
  const name = '@micropython/micropython-webassembly-pyscript';
  expect(noticesOf([`node_modules/${name}/micropython.mjs`])[0]).toContain('Damien P. George');
});

it.each(['player', 'compare', 'report', 'quiz'])('stands in the page %s', (name) => {
  const page = readFileSync(`dist/${name}.html`, 'utf8');
  const text = /<script id="licences" type="text\/plain">(.*?)<\/script>/s.exec(page)![1]!;
  expect(text).toMatch(/^MIT License\n\nCopyright \(c\) \d+ The GW authors\n/);
  expect(text).toMatch(/\n-{72}\n\nsvelte [\d.]+\n\nCopyright .*Svelte/);
});
