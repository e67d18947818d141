// The lab as a package of a learning platform: the exercises are its score.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { expect, it } from 'vitest';
import type { Question } from '../../model/quiz';
import { LearningPlatform, packagesOf } from '../platform';
import { inChromium, lab, thePage, type LabWindow } from './page';

// Frames of files may then speak with each other, as those of a web server do.
inChromium(false, '--allow-file-access-from-files');

it('tells a learning platform how many answers are right at the first try', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'gw-scorm-'));
  packagesOf(folder, resolve(lab), resolve(lab), '--seed', '5');
  const platform = new LearningPlatform(folder, thePage());
  const frame = await platform.run(join(folder, 'gw-lab.zip'));
  await frame.waitForSelector('.story-next');
  await frame.evaluate(() => {
    location.hash = 'exhibit=quiz&lang=en';
  });
  for (let number = 1; number <= 7; ++number) {
    await frame.waitForFunction(
      (number) => document.querySelector('.question')?.ariaLabel?.startsWith(`Question ${number} `),
      {},
      number,
    );
    const question = await frame.evaluate(async (number) => {
      const { machine } = window as unknown as LabWindow;
      const { text } = await machine.ask('quiz', { seed: 5, number, kind: '' });
      return (JSON.parse(text) as Question[])[0]!;
    }, number);
    // The first answer is wrong, all others are right.
    const wrong = number === 1;
    if (question.choices.length > 0) {
      const right = question.answer.charCodeAt(0) - 97;
      const chosen = wrong ? (right + 1) % question.choices.length : right;
      await (await frame.$$('.question input[type=radio]'))[chosen]!.click();
    } else if (question.among > 0) {
      const boxes = await frame.$$('.question input[type=checkbox]');
      for (const place of question.answer.split(' ')) await boxes[Number(place) - 1]!.click();
      if (wrong) await boxes[Number(question.answer.split(' ')[0]) - 1]!.click();
      await (await frame.$('.question form button'))!.click();
    } else {
      await (await frame.$('.question input[type=text]'))!.type(
        wrong ? `${question.answer}0` : question.answer,
      );
      await (await frame.$('.question form button'))!.click();
    }
    const score = await platform.value('cmi.core.score.raw');
    expect(score).toBe(String(Math.round((100 * (number - 1)) / 7)));
    expect(await platform.value('cmi.core.lesson_status')).toBe(
      number < 7 ? 'incomplete' : 'completed',
    );
    if (number < 7) await (await frame.$('button.next'))!.click();
  }
  await platform.leave();
  expect((await platform.calls()).filter(([, , error]) => error !== '0')).toEqual([]);
  rmSync(folder, { recursive: true });
});
