// A picture that is too large is refused with a line, and the page goes on as before.
import { expect, it } from 'vitest';
import { inChromium, open, thePage, type LabWindow } from './page';

inChromium();

it('begins again with empty memory after a picture that is too large', async () => {
  await open('#lang=en&size=64x48');
  await thePage().waitForSelector('canvas');
  const answers = await thePage().evaluate(async () => {
    const { machine } = window as unknown as LabWindow;
    const draw = async (side: number, more: boolean) => {
      const view = { width: side, height: side, profile: 'ideal', renderer: 'hardware' };
      try {
        if (more) await machine.ask('draw', view); // it stays for the next eye
        const { picture } = await machine.ask('passes', view);
        if (more) await machine.ask('plane', { pass: 0, plane: 'color' });
        return picture.length;
      } catch (error) {
        return (error as Error).message;
      }
    };
    await machine.ask('open', '/scenes/rings_plain.toml');
    return [await draw(64, true), await draw(4096, true), await draw(4096, false)];
  });
  expect(answers[0]).toBe(64 * 64 * 4);
  expect(answers[1]).toContain('not enough memory');
  expect(answers[2]).toBe(4096 * 4096 * 4);
});
