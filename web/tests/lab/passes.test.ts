// The exhibit of passes as a hand uses it.
import { expect, it } from 'vitest';
import { inChromium, open, thePage, type LabWindow } from './page';

inChromium();
const text = (selector: string) => thePage().$eval(selector, (e) => e.textContent?.trim() ?? '');
const begin = async (rest = '') => {
  await open(`#lang=en&exhibit=passes&size=64x48${rest}`);
  await thePage().waitForSelector('figure.many canvas');
};
/** Bytes of a figure's canvas. */
const pixels = (figure: string) =>
  thePage().$eval(`figure.${figure} canvas`, (e) => {
    const canvas = e as HTMLCanvasElement;
    const { width, height } = canvas;
    return [...canvas.getContext('2d')!.getImageData(0, 0, width, height).data];
  });

it('shows the sum after a pass, and the whole picture at the end', async () => {
  await begin('&scene=rings.toml');
  const whole = await pixels('many');
  const drawn = await thePage().evaluate(async () => {
    const { machine } = window as unknown as LabWindow;
    const options = { renderer: 'multipass', profile: 'vgx', width: 64, height: 48 };
    return [...(await machine.ask('draw', options)).picture];
  });
  expect(whole).toEqual(drawn);
  expect(await pixels('one')).not.toEqual(whole);
  await thePage().keyboard.press('Home');
  await thePage().waitForFunction(
    () => document.querySelector('.pass-name')?.textContent === '1 depth',
  );
  await thePage().waitForFunction(() =>
    document.querySelector('figure.many figcaption')?.textContent?.includes('pass 1 of'),
  );
  // The background, and shapes that are black.
  const rgb = (await pixels('many')).filter((_, i) => i % 4 !== 3);
  expect(Math.max(...rgb)).toBeLessThan(30);
  expect(rgb.filter((v) => v === 0).length).toBeGreaterThan(100);
});

it('draws again when a cell is typed into, and marks a wrong one', async () => {
  await begin('&scene=rings.toml');
  const before = await pixels('many');
  const row = await thePage().$$eval('table.passes .row', (all) => {
    const row = all.findIndex((button) => button.textContent === 'specular');
    (all[row] as HTMLElement).click();
    return row;
  });
  const type = async (key: string, word: string) => {
    const cell = `input[data-cell="${row} ${key}"]`;
    await thePage().click(cell, { count: 3 });
    await thePage().type(cell, word);
    await thePage().keyboard.press('Enter');
  };
  await type('Ks', '0');
  await thePage().waitForFunction(() => location.hash.includes('list='));
  await thePage().waitForSelector('.scene-list');
  await thePage().waitForFunction(
    (before) => {
      const canvas = document.querySelector<HTMLCanvasElement>('figure.many canvas')!;
      const { width, height } = canvas;
      const now = canvas.getContext('2d')!.getImageData(0, 0, width, height).data;
      return before.some((v, i) => v !== now[i]);
    },
    {},
    before,
  );
  await type('Ks', 'nonsense');
  await thePage().waitForSelector('input.wrong');
  expect(await thePage().$eval('input.wrong', (e) => (e as HTMLElement).dataset['cell'])).toBe(
    `${row} Ks`,
  );
  expect(await text('[role=alert]')).toContain("'nonsense'");
  await thePage().click('.scene-list');
  await thePage().waitForFunction(() => !document.querySelector('[role=alert]'));
});

it('takes samples from the slider and keeps all in the link', async () => {
  await begin('&scene=rings.toml');
  const count = () => thePage().$$eval('.runs li', (all) => all.length);
  const one = await count();
  await thePage().focus('input.samples');
  await thePage().keyboard.press('ArrowRight');
  await thePage().waitForFunction(
    (one) => document.querySelectorAll('.runs li').length > one,
    {},
    one,
  );
  await thePage().click('.plane-accum');
  await thePage().waitForFunction(() => location.hash.includes('view=accum'));
  expect(await thePage().evaluate(() => location.hash)).toContain('samples=2');
  await thePage().reload();
  await thePage().waitForSelector('.plane-accum[aria-pressed=true]');
  expect(await count()).toBeGreaterThan(one);
});

it('turns the eye with whole pictures, and shows all passes when it rests', async () => {
  await begin('&scene=rings.toml');
  const before = await pixels('many');
  await thePage().$eval('figure.many', (e) => e.scrollIntoView());
  const box = (await (await thePage().$('figure.many .stack'))!.boundingBox())!;
  // While the hand holds it and still moves, the picture changes, and the planes are of before.
  await thePage().evaluate(() => {
    const seen = window as unknown as { turned: string[] };
    seen.turned = [];
    const many = document.querySelector<HTMLCanvasElement>('figure.many canvas')!;
    const look = () => {
      if (document.querySelector('figure.plane.old')) seen.turned.push(many.toDataURL());
      requestAnimationFrame(look);
    };
    look();
  });
  await thePage().mouse.move(box.x + 20, box.y + 20);
  await thePage().mouse.down();
  await thePage().mouse.move(box.x + 60, box.y + 25, { steps: 3 });
  await thePage().waitForSelector('figure.plane.old');
  await thePage().mouse.up();
  await thePage().waitForSelector('figure.plane:not(.old)');
  const rested = await pixels('many');
  expect(rested).not.toEqual(before);
  const [turned, now, drawn] = await thePage().evaluate(async () => {
    const { machine, turned } = window as unknown as LabWindow & { turned: string[] };
    const many = document.querySelector<HTMLCanvasElement>('figure.many canvas')!;
    const eye = new URLSearchParams(location.hash.slice(1)).get('eye')!.split(',').map(Number);
    const { at, up } = await machine.ask('open', '/scenes/rings.toml');
    const size = { width: 64, height: 48, profile: 'vgx', renderer: 'multipass' };
    const { picture } = await machine.ask('draw', { ...size, eye, at, up });
    return [turned.at(-1), many.toDataURL(), [...picture]];
  });
  expect(turned).toBe(now); // the same bits
  expect(rested).toEqual(drawn);
});

it('turns the eye with less, if the whole takes too long, and says so', async () => {
  await begin('&scene=fig9.toml&size=640x480');
  const below = () =>
    thePage().$eval('figure.many .below', (e) => (e as HTMLElement).innerText.trim());
  expect(await below()).not.toContain('no rays');
  await thePage().$eval('figure.many', (e) => e.scrollIntoView());
  const box = (await (await thePage().$('figure.many .stack'))!.boundingBox())!;
  await thePage().mouse.move(box.x + 200, box.y + 200);
  await thePage().mouse.down();
  let less = false;
  for (let step = 0; step < 400 && !less; ++step) {
    await thePage().mouse.move(box.x + 200 + 20 * Math.sin(step / 10), box.y + 200);
    less = (await below()).includes('one sample, no rays');
  }
  expect(less).toBe(true);
  await thePage().mouse.up();
  await thePage().waitForSelector('figure.plane:not(.old)');
  expect(await below()).not.toContain('no rays');
});

it('shows the history of a pixel that is clicked', async () => {
  await begin('&scene=rings.toml');
  await thePage().click('figure.many .stack');
  await thePage().waitForSelector('.history table');
  expect(await text('.history thead')).toContain('outcome');
  expect((await text('.history tbody')).length).toBeGreaterThan(10);
  await thePage().waitForFunction(() => /pixel=\d+,\d+/.test(location.hash));
});

it('walks around shadow volumes', async () => {
  await begin('&scene=columns.toml&shadow=volume');
  await thePage().click('details.volumes summary');
  await thePage().waitForSelector('details.volumes canvas');
  expect(await text('details.volumes p')).toMatch(/^\d+ volumes/);
  await thePage().$eval('details.volumes', (e) => e.scrollIntoView());
  const box = (await (await thePage().$('details.volumes .stack'))!.boundingBox())!;
  await thePage().mouse.move(box.x + 40, box.y + 40);
  await thePage().mouse.down();
  await thePage().mouse.move(box.x + 90, box.y + 50, { steps: 4 });
  await thePage().mouse.up();
  await thePage().waitForFunction(() => location.hash.includes('from='));
});

it('can be stopped, and goes on', async () => {
  // Its generated maps are drawn in pieces as large as the window: most of a minute.
  await open('#lang=en&exhibit=passes&size=64x48&scene=mirrors.toml');
  const stop = await thePage().waitForSelector('.choices button');
  await stop!.click();
  await thePage().waitForSelector('[role=alert]');
  expect(await text('[role=alert]')).toBe('Stopped.');
  await thePage().select('select.scene', 'rings.toml');
  await thePage().waitForSelector('figure.many canvas');
  expect(await thePage().$('[role=alert]')).toBeNull();
});

it('fits a phone, in Japanese', async () => {
  await open('#lang=ja&exhibit=passes&size=160x120', 390, 800);
  await thePage().waitForSelector('figure.many canvas');
  const [content, screen] = await thePage().evaluate(() => [
    document.documentElement.scrollWidth,
    window.innerWidth,
  ]);
  expect(content).toBeLessThanOrEqual(screen!);
});
