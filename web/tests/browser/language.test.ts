// A language is one file: the page is built with two more, and nothing else is changed.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { beforeAll, expect, it } from 'vitest';
import { pageOf } from '../page';
import { text } from '../samples/log';
import { describePages } from './browser';

/** The English start of a new language, each word in marks. */
const marked = (file: string): string =>
  file
    .replace('"name": "English"', '"name": "«Xx»"')
    .replace(/^( {4,}".*": ")(.*)(",)$/gm, '$1«$2»$3')
    .replace(/^(.* \| )(.*?)(`,)?$/gm, '$1«$2»$3');
const settings = readdirSync('.').filter((name) => /\.(json|js|ts)$/.test(name));
const words = process.env['GW_STEP_WORDS'] ?? '../hiddensurface/run/step_words.json';
const env = {
  ...process.env,
  GW_STEP_WORDS: resolve(words),
  GW_SCENES: resolve(process.env['GW_SCENES'] ?? '../scenes'),
};
/** A file of which nearly all is still missing. */
const begun = `
import type { Begun } from "../language";
export default { name: 'Yy', words: { next: 'Onward' } } satisfies Begun;`;

describePages('a language that is one more file', (pages) => {
  let player = '';
  beforeAll(() => {
    const copy = join(pages.folder, 'web');
    mkdirSync(copy);
    symlinkSync(resolve('node_modules'), join(copy, 'node_modules'));
    for (const part of ['articles', 'components', 'model', 'player', 'words', ...settings])
      cpSync(part, join(copy, part), { recursive: true });
    const run = (...command: string[]) => execFileSync('npx', command, { cwd: copy, env });
    run('vite-node', 'new_language.ts', 'xx');
    const file = join(copy, 'words/languages/xx.ts');
    writeFileSync(file, marked(readFileSync(file, 'utf8')));
    writeFileSync(join(copy, 'words/languages/yy.ts'), begun);
    run('node', 'build.js', 'player');
    player = join(pages.folder, 'player.html');
    writeFileSync(player, pageOf('player', [text()], join(copy, 'dist')));
  });

  it('is in the list of languages, speaks in all parts of the page, and stays in its address', async () => {
    await pages.openFile(player, '#step=1&lang=en');
    expect(await pages.textsOf('.page-language option')).toEqual([
      'English',
      '日本語',
      '«Xx»',
      'Yy',
    ]);
    await pages.page.select('.page-language', 'xx');
    expect(await pages.textOf('.bar .next')).toBe('«Next»');
    expect(await pages.page.evaluate(() => document.documentElement.lang)).toBe('xx');
    await pages.page.keyboard.press('ArrowRight');
    expect(await pages.textOf('.sentence')).toMatch(/^«In depth 2 .*»$/);
    const code = await pages.textsOf('.code li');
    expect(code.length).toBeGreaterThan(9);
    for (const line of code) expect(line).toMatch(/^«.*»/);
    expect(await pages.hash()).toContain('lang=xx');
    await pages.page.reload();
    await pages.page.waitForSelector('.bar .next');
    expect(await pages.textOf('.bar .next')).toBe('«Next»');
  });

  it('is English where it has no words yet', async () => {
    await pages.openFile(player, '#step=1&lang=yy');
    expect(await pages.textOf('.bar .next')).toBe('Onward');
    expect(await pages.textOf('button.play')).toBe('Play');
    expect(await pages.textOf('.sentence')).toBe('1, 2.');
  });
});
