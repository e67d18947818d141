// No exhibit has barriers that axe-core finds, and a step is seen without scrolling.
import { expect, it } from 'vitest';
import { stories } from '../../model/steps/stories';
import { barriersOf } from '../barriers';
import { inChromium, open, thePage } from './page';

inChromium();

const exhibits = ['hidden', 'own', 'quiz', 'pixel', 'passes', 'programs', 'rays', 'radiosity'];
it.each(exhibits)('axe-core finds nothing in %s', async (id) => {
  await open(`#lang=${id === 'hidden' ? 'ja' : 'en'}&exhibit=${id}&size=64x48`);
  await thePage().waitForSelector('main canvas, main .question, main .record:enabled');
  expect(await barriersOf(thePage())).toEqual([]);
});

const ends = stories.map(({ id }) => `story=${id}&step=999999`);
it.each(['story=first', ...ends, 'exhibit=hidden&scene=hidden/cycle.toml'])(
  'shows step, sentence, list and both views of %s on 1280x720',
  async (address) => {
    for (const look of ['lang=en', 'lang=ja', 'lang=en&projector=1', 'lang=ja&projector=1']) {
      await thePage().goto('about:blank'); // what was shown before fits, too
      await open(`#${address}&${look}`);
      await thePage().waitForSelector('.stack canvas');
      await thePage().waitForFunction(
        () =>
          ['.stack', '.second', '.sentence', '.bar', '.steps .list'].every(
            (part) => document.querySelector(part)!.getBoundingClientRect().bottom <= innerHeight,
          ),
        { timeout: 20_000 },
      );
      const { width } = (await (await thePage().$('.stack'))!.boundingBox())!;
      expect(width, look).toBeGreaterThan(430);
    }
  },
);
