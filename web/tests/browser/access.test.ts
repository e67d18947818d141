// No page has barriers that axe-core finds: the pages as they open, and with all that they show.
import { execFileSync, spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { barriersOf } from '../barriers';
import { text } from '../samples/log';
import { comparison } from '../samples/comparison';
import { question } from '../samples/question';
import { describePages } from './browser';

const gw = process.env['GW'] ?? '';
const scenes = process.env['GW_SCENES'] ?? '';
const corners = [['1a', 1, 2, 0.5]] as const;

describePages('axe-core finds nothing', (pages) => {
  const nothing = async () => expect(await barriersOf(pages.page)).toEqual([]);

  it('in the player, of one run and of two', async () => {
    await pages.open('player', [text()], '#lang=en&step=3&view=list&pixel=4,2');
    await nothing();
    await pages.open('player', [text(), text()], '#lang=ja&theme=dark&step=2,5&view=top,depth');
    await nothing();
  }, 300_000);

  it('in the licences, which every page shows', async () => {
    await pages.open('player', [text()], '#lang=ja');
    await pages.page.click('footer .text-licence');
    expect(await pages.textOf('dialog[open] pre')).toContain('Svelte Contributors');
    await nothing();
    await pages.page.keyboard.press('Escape');
    await pages.page.waitForSelector('dialog[open]', { hidden: true });
  });

  it('in a comparison', async () => {
    await pages.open('compare', [JSON.stringify(comparison)], '#lang=en&plane=all');
    await nothing();
  });

  it('in a quiz', async () => {
    await pages.open('quiz', [JSON.stringify([{ ...question, corners }]), text()], '#lang=ja');
    await pages.page.click('input[type=radio]');
    await pages.page.click('button.why');
    await pages.page.waitForSelector('.pane');
    await nothing();
  }, 300_000);

  it.skipIf(gw === '')(
    'in the pages to print',
    async () => {
      const out = join(pages.folder, 'printed');
      execFileSync(gw, ['quiz', out, '--quiet', '--seed', '3'], { stdio: 'ignore' });
      for (const page of ['handout/quiz.html', 'answers.html']) {
        await pages.page.goto(`file://${join(out, page)}`);
        await nothing();
      }
    },
    300_000,
  );

  it.skipIf(gw === '')(
    'in indexes of folders and in grades',
    async () => {
      const index = join(pages.folder, 'index'),
        grades = join(pages.folder, 'grades');
      const scene = join(scenes, 'hidden/cycle.toml');
      execFileSync(gw, ['hidden', scene, '--algorithm', 'newell', '--steps', index, '--quiet'], {
        stdio: 'ignore',
      });
      const graded = join(scenes, '../examples/autograder/class');
      spawnSync(gw, ['autograde', graded, '--scene', scene, '-o', grades, '--time', '1'], {
        stdio: 'ignore',
      });
      for (const folder of [index, grades]) {
        await pages.page.goto(`file://${join(folder, 'index.html')}`);
        await nothing();
      }
    },
    300_000,
  );
});
