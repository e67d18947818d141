// The page of a quiz in a real browser.
import { expect, it } from 'vitest';
import { text as logText } from '../samples/log';
import { question } from '../samples/question';
import { describePages } from './browser';

const several = {
  ...question,
  kind: 'facing',
  choices: [],
  among: 3,
  answer: '1 3',
  pixel: [4, 2] as [number, number],
};
const number = { ...question, kind: 'spans', choices: [], answer: '12' };

describePages('the quiz', (pages) => {
  const open = (hash = '#lang=en') =>
    pages.open(
      'quiz',
      [JSON.stringify([question, several, number]), logText(), logText(), logText()],
      hash,
    );
  const score = () => pages.textOf('.score');
  const said = () => pages.textOf('.feedback strong');

  it('grades a choice at once, and counts the first try', async () => {
    await open();
    const [first, second] = await pages.page.$$('input[type=radio]');
    await first!.click();
    expect(await said()).toContain('Not right');
    expect(await pages.textOf('.feedback')).not.toContain('1 lies before 2.');
    await second!.click();
    expect(await pages.textOf('.feedback')).toBe('Right. 1 lies before 2.');
    expect(await score()).toBe('0 of 3 right at the first try');
    await pages.page.click('button.next');
    for (const place of [1, 3])
      await pages.page.click(`.numbers-among label:nth-child(${place}) input`);
    await pages.page.click('form button');
    expect(await said()).toBe('Right.');
    await pages.page.click('button.next');
    await pages.page.type('form input', '12');
    await pages.page.keyboard.press('Enter');
    expect(await said()).toBe('Right.');
    expect(await score()).toBe('All questions are answered: 2 of 3 right at the first try.');
    expect(await pages.hash()).toContain('question=3');
  });

  it('shows why: the player at the step that decides, and its pixel', async () => {
    await open('#question=2&lang=ja');
    await pages.page.click('button.why');
    await pages.page.waitForSelector('.pane .sentence');
    expect(await pages.textOf('.answer b')).toBe('答えは 1 3 です。');
    expect(await pages.page.$eval('.bar input[type=range]', (e) => e.value)).toBe('3');
    expect(await pages.textOf('.at-pixel')).toContain('4, 2');
    // All of the step is seen, below the answer.
    await pages.page.waitForFunction(() => {
      const boxes = ['.answer', '.stack', '.second', '.sentence', '.bar'].map((part) =>
        document.querySelector(part)!.getBoundingClientRect(),
      );
      return boxes.every(({ top, bottom }) => top >= 0 && bottom <= innerHeight);
    });
    const stack = (await (await pages.page.$('.stack'))!.boundingBox())!;
    expect(stack.width).toBeGreaterThan(400);
    await pages.page.keyboard.press('ArrowLeft');
    expect(await pages.page.$eval('.bar input[type=range]', (e) => e.value)).toBe('2');
    for (const [width, height] of [
      [390, 844],
      [1280, 720],
    ] as const) {
      await pages.page.setViewport({ width, height });
      expect(await pages.excess()).toBeLessThanOrEqual(0);
    }
    await pages.page.click('nav button');
    expect(await pages.page.$('.pane')).toBeNull();
  });
});
