// The exhibit of radiosity as a hand uses it.
import { expect, it } from 'vitest';
import { inChromium, open, thePage } from './page';

inChromium();
const text = (selector: string) => thePage().$eval(selector, (e) => e.textContent?.trim() ?? '');
const begin = async (rest = '') => {
  await open(
    `#lang=en&exhibit=radiosity&scene=radiosity/cornell.toml&size=64x48&hemicube=32${rest}`,
  );
  await thePage().waitForSelector('figure.cross canvas');
};
const says = (words: string) =>
  thePage().waitForFunction(
    (words) => document.querySelector('p.state')?.textContent?.includes(words),
    {},
    words,
  );
const pixels = (figure: string) =>
  thePage().$eval(`figure.${figure} canvas`, (e) => {
    const canvas = e as HTMLCanvasElement;
    const { width, height } = canvas;
    return [...canvas.getContext('2d')!.getImageData(0, 0, width, height).data];
  });
const unshot = async () => Number(/([\d.]+) % unshot/.exec(await text('p.state'))![1]);

it('shoots, goes back, and shows the hemicube of each shot', async () => {
  await begin('&shots=1');
  await says('shot 1:');
  const after1 = [await pixels('lit'), await pixels('cross'), await unshot()] as const;
  await thePage().keyboard.press('ArrowRight');
  await says('shot 2:');
  await thePage().waitForFunction(() => location.hash.includes('shots=2'));
  expect(await unshot()).toBeLessThan(after1[2]);
  await thePage().keyboard.press('ArrowLeft');
  await says('shot 1:');
  expect(await unshot()).toBe(after1[2]);
  await thePage().waitForFunction(
    (before) => {
      const canvas = document.querySelector<HTMLCanvasElement>('figure.lit canvas')!;
      const now = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height).data;
      return before.every((v, i) => v === now[i]);
    },
    {},
    after1[0],
  );
  await thePage().$eval('input.point', (e) => ((e as HTMLInputElement).value = ''));
  await thePage().type('input.point', '2');
  await thePage().keyboard.press('Tab');
  await thePage().waitForFunction(
    (before) => {
      const canvas = document.querySelector<HTMLCanvasElement>('figure.cross canvas')!;
      const now = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height).data;
      return before.some((v, i) => v !== now[i]);
    },
    {},
    after1[1],
  );
  await thePage().waitForFunction(() => document.querySelectorAll('.sheets figure').length > 5);
});

it('plays, and stops where it is', async () => {
  await begin('&shots=0');
  await (await thePage().waitForSelector('button.play'))!.click();
  await thePage().waitForFunction(() => Number(/shots=(\d+)/.exec(location.hash)?.[1] ?? 0) >= 3);
  await thePage().click('button.stop');
  await thePage().waitForSelector('button.play');
  const shots = /shot (\d+):/.exec(await text('.state'))![1]!;
  await thePage().waitForFunction((n) => location.hash.includes(`shots=${n}`), {}, shots);
});

it('changes a reflectance, goes on, and solves anew beside it', async () => {
  await begin('&shots=2');
  const before = await pixels('lit');
  await thePage().select('select.object', 'left_wall');
  for (const [i, word] of ['0.1', '0.2', '0.9'].entries()) {
    const field = (await thePage().$$('input.value'))[i]!;
    await field.click({ count: 3 });
    await field.type(word);
  }
  await thePage().click('button.go-on');
  await thePage().waitForSelector('.change li');
  expect(await text('.change li')).toContain('left_wall');
  await thePage().waitForSelector('circle.change');
  await thePage().waitForFunction(
    (before) => {
      const canvas = document.querySelector<HTMLCanvasElement>('figure.lit canvas')!;
      const now = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height).data;
      return before.some((v, i) => v !== now[i]);
    },
    {},
    before,
  );
  const goneOn = await text('p.state');
  await thePage().click('input.resolved');
  await thePage().waitForFunction(
    (most) => {
      const said = document.querySelector('figure.resolved figcaption')?.textContent ?? '';
      return Number(/([\d.]+) % unshot/.exec(said)?.[1] ?? 100) <= most;
    },
    {},
    Number(/([\d.]+) % unshot/.exec(goneOn)![1]),
  );
  await thePage().waitForFunction(() =>
    location.hash.includes('change=2%3Aleft_wall%3AKd%3A0.1,0.2,0.9'),
  );
  const picture = await pixels('lit');
  await thePage().reload();
  await thePage().waitForSelector('circle.change');
  await thePage().waitForSelector('.sheets figure');
  expect(await pixels('lit')).toEqual(picture);
});

it('moves an object, and goes on', async () => {
  await begin('&shots=1');
  const before = await pixels('lit');
  await thePage().select('select.what', 'move');
  await thePage().select('select.object', 'short_block');
  const field = (await thePage().$$('input.value'))[0]!;
  await field.click({ count: 3 });
  await field.type('-0.2');
  await thePage().click('button.go-on');
  await thePage().waitForSelector('circle.change');
  expect(await text('.change li')).toContain('place, moved by');
  await thePage().waitForFunction(
    (before) => {
      const canvas = document.querySelector<HTMLCanvasElement>('figure.lit canvas')!;
      const now = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height).data;
      return before.some((v, i) => v !== now[i]);
    },
    {},
    before,
  );
  await thePage().waitForFunction(() => location.hash.includes('move%3A-0.2,0,0'));
});

it('is brighter with more exposure', async () => {
  await begin('&shots=1');
  const before = await pixels('lit');
  await thePage().focus('input.exposure');
  await thePage().keyboard.press('ArrowRight');
  await thePage().waitForFunction(() => location.hash.includes('exposure=0.5'));
  await thePage().waitForFunction(
    (before) => {
      const canvas = document.querySelector<HTMLCanvasElement>('figure.lit canvas')!;
      const now = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height).data;
      return before.some((v, i) => v !== now[i]);
    },
    {},
    before,
  );
  const after = await pixels('lit');
  expect(after.every((v, i) => v >= before[i]!)).toBe(true);
});

it('walks around the light', async () => {
  await begin('&shots=1');
  const box = (await (await thePage().$('figure.lit .stack'))!.boundingBox())!;
  await thePage().mouse.move(box.x + 40, box.y + 40);
  await thePage().mouse.down();
  await thePage().mouse.move(box.x + 90, box.y + 50, { steps: 4 });
  await thePage().mouse.up();
  await thePage().waitForFunction(() => location.hash.includes('eye='));
});

it('refuses a scene without a light, and goes on', async () => {
  await open('#lang=en&exhibit=radiosity&scene=teapot.toml&size=64x48');
  await thePage().waitForSelector('[role=alert]');
  expect(await text('[role=alert]')).toContain('emits');
  await thePage().select('select.scene', 'radiosity/cornell.toml');
  await thePage().waitForSelector('figure.lit canvas');
});

it('fits a phone, in Japanese', async () => {
  await open('#lang=ja&exhibit=radiosity&size=64x48&hemicube=32', 390, 800);
  await thePage().waitForSelector('.sheets figure');
  const [content, screen] = await thePage().evaluate(() => [
    document.documentElement.scrollWidth,
    window.innerWidth,
  ]);
  expect(content).toBeLessThanOrEqual(screen!);
});
