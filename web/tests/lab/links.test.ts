// No link of the page is dead, wherever the page goes: alone, beside the articles by any name, and
// in the site.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { inChromium, lab, openFile, thePage } from './page';

const project = join(process.env['GW_SCENES'] ?? '../scenes', '..');
const programs = process.env['GW_PROGRAMS'] ?? '../build/lab/programs';
let folder: string;
beforeAll(() => (folder = mkdtempSync(join(tmpdir(), 'gw-links-'))));
afterAll(() => rmSync(folder, { recursive: true }));
inChromium();

const articles = '<html lang="en" data-beside=""><title>articles</title></html>';
/** The page as it is built, beside nothing. */
const copied = (name: string): string => {
  const file = join(folder, name);
  const page = readFileSync(lab, 'utf8').replace(/data-beside="[^"]*"/, 'data-beside=""');
  writeFileSync(file, page);
  return file;
};

/** Opens help, and answers with all links of the page. */
async function linksOf(file: string, hash: string): Promise<string[]> {
  await openFile(file, hash);
  await thePage().waitForSelector('.stack canvas');
  await thePage().click('.help summary');
  return thePage().$$eval('a', (all) => all.map((e) => e.getAttribute('href')!));
}
function expectFiles(file: string, links: readonly string[]): void {
  for (const link of links)
    expect(existsSync(join(dirname(file), link.split('#')[0]!)), link).toBe(true);
}

it.each(['en', 'ja'])('carries its documents, in %s', async (language) => {
  const file = copied('gw-lab.html');
  expect(await linksOf(file, `#lang=${language}`)).toEqual([]);
  for (const [name, words] of [
    ['manual', 'scripts/lab'],
    ['lecture', language === 'ja' ? '隠面消去' : 'Hidden surfaces'],
    ['licence', readFileSync(join(project, 'LICENSE'), 'utf8').split('\n')[0]!],
  ] as const) {
    await thePage().click(`button.text-${name}`);
    await thePage().waitForSelector('dialog[open]');
    expect(await thePage().$eval('dialog[open]', (e) => e.textContent)).toContain(words);
    const dead = await thePage().$$eval('dialog[open] a', (all) =>
      all
        .map((e) => decodeURIComponent(e.getAttribute('href')!))
        .filter((link) => !/^(https:|#exhibit=)/.test(link))
        .filter((link) => !(link.startsWith('#text-') && document.getElementById(link.slice(1)))),
    );
    expect(dead).toEqual([]);
    await thePage().keyboard.press('Escape');
    await thePage().waitForSelector('dialog[open]', { hidden: true });
  }
  // A link of the lecture opens its run behind the closed text.
  await thePage().click('button.text-lecture');
  await thePage().waitForSelector('dialog[open]');
  const link = 'a[href*="hidden/five.toml"]';
  await thePage().$eval(link, (e) => (e as HTMLElement).click());
  await thePage().waitForSelector('dialog[open]', { hidden: true });
  await thePage().waitForFunction(
    () => document.querySelector<HTMLSelectElement>('select.scene')?.value === 'hidden/five.toml',
  );
});

// All that is bundled, from npm and from Debian: the build refuses what has no licence.
const bundled = ['svelte', 'codemirror', '@codemirror/lang-python', '@gamestdio/scorm', 'gifenc'];
const inEngine = ['emscripten', 'libhwy-dev', 'libfmt-dev', 'libglm-dev', 'nlohmann-json3-dev'];
it('carries the licences of all whose code it has', async () => {
  await linksOf(copied('gw-lab.html'), '#lang=en');
  await thePage().click('button.text-licence');
  const text = await thePage().$eval('dialog[open] pre', (e) => e.textContent!);
  const notices = text.split(`\n${'-'.repeat(72)}\n`).map((notice) => notice.trim());
  for (const name of [...bundled, '@micropython/micropython-webassembly-pyscript', ...inEngine]) {
    const notice = notices.find((each) => each.split(/[ \n]/)[0] === name);
    expect(notice, name).toMatch(/copyright/i);
  }
});

it("tells the project's version", async () => {
  await linksOf(copied('gw-lab.html'), '#lang=en');
  const [, version] = /project\(gw VERSION ([\d.]+)/.exec(
    readFileSync(join(project, 'CMakeLists.txt'), 'utf8'),
  )!;
  expect(await thePage().$eval('.help', (e) => e.textContent)).toContain(`Version ${version}`);
});

it('leads to the articles that stand beside it by the names of a release', async () => {
  const file = copied('gw-0.1.0-lab.html');
  const other = join(folder, 'gw-0.1.0-articles.html');
  writeFileSync(other, articles);
  execFileSync(join(project, 'web/link_pages'), [file, other]);
  const links = await linksOf(file, '#lang=en');
  expect(links).toEqual(['gw-0.1.0-articles.html']);
  expect(readFileSync(other, 'utf8')).toContain('data-beside="gw-0.1.0-lab.html"');
});

function madeSite(): string {
  const site = join(folder, 'site');
  const other = join(folder, 'articles.html');
  writeFileSync(other, articles);
  execFileSync('/usr/bin/python3', [
    join(project, 'scripts/site'),
    ...[site, resolve(lab), other, programs],
  ]);
  return site;
}

it.each(['en', 'ja'])('leads to the pages of the site, in %s', async (language) => {
  const site = madeSite();
  const file = join(site, 'lab.html');
  const links = await linksOf(file, `#lang=${language}`);
  const lecture = language === 'ja' ? 'docs/lecture.ja.html' : 'docs/lecture.html';
  expect(links).toEqual(['docs/lab.html', lecture, 'articles.html']);
  expectFiles(file, links);
});

it("finds an article of the site before a contributor's page", async () => {
  await thePage().goto(`file://${madeSite()}/index.html`);
  const found = async (words: string): Promise<string[]> => {
    await thePage().$eval(
      '.site input',
      (e, text) => ((e as HTMLInputElement).value = text),
      words,
    );
    await thePage().$eval('.site input', (e) => e.dispatchEvent(new Event('input')));
    return thePage().$$eval('.found a', (all) => all.map((e) => e.getAttribute('href')!));
  };
  const stencil = await found('stencil');
  expect(stencil[0]).toBe('articles.html#article=stencil-shadows&lang=en');
  expect(stencil.slice(0, 10).filter((link) => link.startsWith('CONTRIBUTING'))).toEqual([]);
  expect((await found('ステンシル'))[0]).toContain('articles.html#article=');
});
