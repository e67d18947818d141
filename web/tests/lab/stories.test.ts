// The stories, from their addresses to their ends.
import { describe, expect, it } from 'vitest';
import { stories } from '../../lab/hidden/stories';
import { inChromium, open, thePage } from './page';

inChromium();
const told = () => thePage().$eval('.story p', (e) => e.textContent);
const output = () => thePage().$eval('.bar output', (e) => e.textContent?.trim());

describe.each(['en', 'ja'] as const)('in %s', (language) => {
  it.each(stories)('story=$id opens its own picture, and tells all stages', async (story) => {
    await open(`#story=${story.id}&lang=${language}`);
    await thePage().waitForSelector('.stack canvas');
    const address = await thePage().evaluate(() => location.hash);
    const parts = new URLSearchParams(address.slice(1));
    for (const key of ['scene', 'algorithm', 'level', 'size'] as const)
      expect(parts.get(key), key).toBe(story[key]);
    expect(await thePage().$eval('.story h2', (e) => e.textContent)).toMatch(
      new RegExp(`1\\D+${story.stages.length}$`),
    );
    expect(await told()).toBe(story.stages[0]![language]);
    expect(await output()).toMatch(/^0 /);
    for (const stage of story.stages.slice(1)) {
      await thePage().click('.story-next');
      await thePage().waitForFunction(
        (text) => document.querySelector('.story p')?.textContent === text,
        {},
        stage[language],
      );
    }
    expect(await output()).toMatch(/^(\d+) \S+ \1$/);
  });
});
