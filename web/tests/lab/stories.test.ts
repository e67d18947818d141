// The stories, from their addresses to their ends.
import { describe, expect, it } from 'vitest';
import { stagesOf, stories } from '../../model/steps/stories';
import { storyIn } from '../../words/language';
import { inChromium, open, thePage } from './page';

inChromium();
const told = () => thePage().$eval('.story p', (e) => e.textContent);
const output = () => thePage().$eval('.bar output', (e) => e.textContent?.trim());

describe.each(['en', 'ja'] as const)('in %s', (language) => {
  it.each(stories)('story=$id opens its own picture, and tells all stages', async (story) => {
    const said = storyIn(story.id, language);
    const stages = stagesOf(story);
    await open(`#story=${story.id}&lang=${language}`);
    await thePage().waitForSelector('.stack canvas');
    const address = await thePage().evaluate(() => location.hash);
    const parts = new URLSearchParams(address.slice(1));
    for (const key of ['scene', 'algorithm', 'level', 'size'] as const)
      expect(parts.get(key), key).toBe(story[key]);
    expect(await thePage().$eval('.story h2', (e) => e.textContent)).toMatch(
      new RegExp(`1\\D+${stages.length}$`),
    );
    expect(await told()).toBe(said[stages[0]!]);
    expect(await output()).toMatch(/^0 /);
    for (const stage of stages.slice(1)) {
      expect(await thePage().$('.blame')).toBeNull();
      await thePage().click('.story-next');
      await thePage().waitForFunction(
        (text) => document.querySelector('.story p')?.textContent === text,
        {},
        said[stage],
      );
    }
    expect(await output()).toMatch(/^(\d+) \S+ \1$/);
    expect((await thePage().$('.blame')) !== null).toBe(story.id === 'painter');
  });
});

it('has one button to press, which the right arrow key presses too', async () => {
  await open('#story=first&lang=en');
  await thePage().waitForSelector('.stack canvas');
  const primary = await thePage().$$eval('button.primary', (all) => all.map((e) => e.className));
  expect(primary).toHaveLength(1);
  expect(primary[0]).toContain('story-next');
  expect(await thePage().$('select.algorithm')).toBeNull();
  const said = storyIn('first', 'en');
  const stages = stagesOf(stories[0]!);
  for (const [key, place] of [
    ['ArrowRight', 1],
    ['ArrowRight', 2],
    ['ArrowRight', 3],
    ['ArrowLeft', 2],
  ] as const) {
    await thePage().keyboard.press(key);
    expect(await told()).toBe(said[stages[place]!]);
  }
  // One step further is not yet a stage: its words are fainter, and back is to the stage.
  const at = await output();
  await thePage().click('.bar .next');
  expect(await output()).not.toBe(at);
  await thePage().waitForSelector('.story p.faint');
  await thePage().keyboard.press('ArrowLeft');
  expect(await output()).toBe(at);
  await thePage().$$eval('.story button', (all) => all.at(-1)!.click());
  await thePage().waitForSelector('select.algorithm');
  await thePage().waitForSelector('.bar .next.primary');
});
