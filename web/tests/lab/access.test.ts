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

it('shows step, sentence, list and both views on 1280x720, of the ends of stories too', async () => {
  const ends = stories.map(({ id }) => `story=${id}&step=999999`);
  for (const address of ['story=first', ...ends, 'exhibit=hidden&scene=hidden/cycle.toml'])
    for (const look of ['lang=en', 'lang=ja', 'lang=en&projector=1', 'lang=ja&projector=1']) {
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
      expect(width, `${address} ${look}`).toBeGreaterThan(430);
    }
});
