// A Japanese page has no English word but those that are names everywhere, listed here.
import { expect, it } from 'vitest';
import { inChromium, open, thePage } from './page';

inChromium();

/** Names of people, of keys, of formats and languages, units, and signs of formulas. */
const names = `GW English MIT JavaScript Python IRIS GL VGX MultiBuffer OBJ TOML glTF RGB PNG SVG
PDF GIF Alt Shift Tab Home End Escape Enter PageUp PageDown BSP ID Newell Sancha Schumacker Warnock
Bouknight Watkins Weiler Atherton Quake Roberts Appel Williamson Wright
ms vgx reality ideal dx dy Gx Gy Ka Kd Ks Ke mul top_left
P_E P_i D_f`;
/** Of what the first scenes' files name: parts and lamps. */
const parts = `key fill lamp floor ceiling back_wall right_wall left_wall short_block tall_block
ball of silver front wall left right`;
/** Of examples, and of the steps of a program, which are the program's. */
const program = 'painter z-buffer back-face farthest corner sorted played scene step';
const known = new Set(`${names} ${parts} ${program}`.split(/[\s-]+/));

const exhibits = [
  ...['newell', 'bsp', 'schumacker', 'warnock', 'weiler-atherton', 'a-buffer', 'z-buffer'],
  ...['back-face', 'painter-farthest', 'hierarchical-z', 'appel', 'roberts'],
  ...['scan-line&level=span', 'bouknight&level=span', 'watkins&level=span', 'quake&level=span'],
].map((algorithm) => `exhibit=hidden&scene=hidden/cycle.toml&step=6&algorithm=${algorithm}`);
exhibits.push('exhibit=hidden&scene=hidden/hills.toml&step=900&algorithm=floating-horizon');
exhibits.push('exhibit=pixel&pixel=40,30', 'exhibit=passes&pixel=40,30', 'exhibit=rays');
for (const id of ['own', 'quiz', 'programs', 'radiosity']) exhibits.push(`exhibit=${id}`);

it.each(exhibits)(
  '%s',
  async (address) => {
    await open(`#lang=ja&size=64x48&${address}`);
    await thePage().waitForSelector('main canvas, main .question, main .record');
    await thePage().$$eval('details', (all) => {
      for (const each of all) each.open = true;
    });
    // Until nothing more comes: pictures and their numbers are drawn one after another.
    let last = '';
    for (let now = 'none'; now !== last;) {
      last = now;
      await new Promise((done) => setTimeout(done, 700));
      now = await thePage().$eval('body', (body) => String(body.textContent?.length));
    }
    const found = await thePage().evaluate(() => {
      const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      const texts: string[] = [];
      while (walker.nextNode()) {
        const at = walker.currentNode.parentElement!;
        // TOML, formulas and programs are languages of their own.
        if (!at.closest('script, style, .cm-editor, code, .formula, td[data-key], .set'))
          texts.push(walker.currentNode.nodeValue ?? '');
      }
      return texts;
    });
    const words = found.flatMap(
      (text) =>
        text
          .replace(/[\w/]+\.(toml|obj|html)|scripts\/\w+|`[^`]*`|\b\d+[ab]+\b/g, '')
          .replaceAll('\u200b', '')
          .match(/[A-Za-z_]{2,}/g) ?? [],
    );
    expect([...new Set(words)].filter((word) => !known.has(word))).toEqual([]);
  },
  60_000,
);
