// The exhibit of programs: they run, are recorded, and a frame is looked into, step by step.
import { copyFileSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Frame } from 'puppeteer-core';
import { expect, it } from 'vitest';
import { barriersOf } from '../barriers';
import { inChromium, lab, open, thePage } from './page';

inChromium();

const text = (selector: string) =>
  thePage().$eval(selector, (e) => (e as HTMLElement).innerText.trim());

/** Opens the exhibit and waits until the program runs. */
async function begin(rest = '', width = 1280, height = 720): Promise<Frame> {
  await open(`#lang=en&exhibit=programs${rest}`, width, height);
  return running();
}
async function running(): Promise<Frame> {
  await thePage().waitForSelector('.record:enabled');
  const frame = await (await thePage().$('.window iframe'))!.contentFrame();
  await frame.waitForSelector('canvas');
  return frame;
}

/** Records, until the counts of the frame say this, or do not say that. */
async function record(says = '', not = '?'): Promise<string> {
  await thePage().click('.record');
  await thePage().waitForFunction(
    (says, not) => {
      const whole = document.querySelector('.recording .whole')?.textContent;
      return !!whole && whole.includes(says) && !whole.includes(not);
    },
    {},
    says,
    not,
  );
  await thePage().waitForSelector('.recording figure.colors canvas');
  return text('.recording .whole');
}
const countIn = (words: string, name: string): number =>
  Number(new RegExp(`${name}: ([\\d,]+)`).exec(words)?.[1]?.replaceAll(',', '') ?? 0);

/** RGBA of a canvas. */
const pixelsOf = (of: Frame | ReturnType<typeof thePage>, selector: string) =>
  of.$eval(selector, (e) => {
    const canvas = e as HTMLCanvasElement;
    const { width, height } = canvas;
    return [...canvas.getContext('2d')!.getImageData(0, 0, width, height).data];
  });
/** The program's window, when it does not change any more. */
async function restingPixels(frame: Frame): Promise<number[]> {
  for (;;) {
    const before = await pixelsOf(frame, 'canvas');
    await new Promise((done) => setTimeout(done, 500));
    const after = await pixelsOf(frame, 'canvas');
    if (before.every((value, i) => value === after[i])) return after;
  }
}
const lastStep = () =>
  thePage().waitForFunction(() => {
    const range = document.querySelector<HTMLInputElement>('input.step');
    return range && range.value === range.max && Number(range.max) > 0;
  });

it('shows the steps of a frame, whose last picture is that of the window', async () => {
  const frame = await begin();
  await thePage().click('.try-spin');
  const window = await restingPixels(frame);
  const whole = await record();
  await lastStep();
  expect(await pixelsOf(thePage(), 'figure.colors canvas')).toEqual(window);
  // Ten blocks of six faces, and letters; the machine compares depths.
  expect(countIn(whole, 'polygons')).toBeGreaterThan(60);
  expect(countIn(whole, 'depth test')).toBeGreaterThan(0);
  // The first steps: the back plane becomes what is shown, colours and Z are cleared.
  for (const [key, does] of [
    ['Home', 'Step 1 of [0-9]+: pixels are copied'],
    ['ArrowRight', 'Step 2 of [0-9]+: a plane is cleared'],
    ['ArrowRight', 'Step 3 of [0-9]+: a plane is cleared'],
    ['ArrowRight', 'Step 4 of [0-9]+: polygons: 1'],
  ] as const) {
    await thePage().keyboard.press(key);
    await thePage().waitForFunction(
      (does) => RegExp(does).test(document.querySelector<HTMLElement>('.sentence')!.innerText),
      {},
      does,
    );
  }
});

it('changes the method by a key in the window, and by a button', async () => {
  const frame = await begin();
  await thePage().click('.try-spin');
  await restingPixels(frame);
  const tested = await record('depth test');
  expect(await thePage().$('figure.depths canvas')).not.toBeNull();
  await frame.focus('canvas');
  await thePage().keyboard.press('2');
  const painted = await record('', 'depth test');
  await thePage().waitForFunction(() =>
    document.querySelector('figure.depths')?.textContent?.includes('does not use the Z-buffer'),
  );
  // Without a test all fragments are written. The letters of the two names differ.
  const all = countIn(tested, 'written') + countIn(tested, 'depth test');
  expect(Math.abs(countIn(painted, 'written') - all)).toBeLessThan(500);
  expect(countIn(tested, 'depth test')).toBeGreaterThan(5000);
  await thePage().click('.try-backface');
  // One to three faces of a block look at an eye outside of it; a face has two triangles.
  const dropped = countIn(await record('look away'), 'dropped');
  expect(dropped).toBeGreaterThanOrEqual(2 * 10 * 3);
  expect(dropped).toBeLessThanOrEqual(2 * 10 * 5);
});

it('changes the method by the menu: with the mouse, by keys, by a finger', async () => {
  const frame = await begin();
  const box = (await (await frame.$('canvas'))!.boundingBox())!;
  // The pointer is the menu's upper left corner; rows have 18 pixels, the first is the title.
  const row = (number: number) => 18 * number + 9;
  await thePage().mouse.move(box.x + 100, box.y + 100);
  await thePage().mouse.down({ button: 'right' });
  await thePage().mouse.move(box.x + 130, box.y + 100 + row(3), { steps: 3 });
  await thePage().mouse.up({ button: 'right' });
  await record('look away');
  await frame.focus('canvas');
  await thePage().keyboard.down('Shift');
  await thePage().keyboard.press('F10');
  await thePage().keyboard.up('Shift');
  await isMenuOpen(frame);
  await thePage().keyboard.press('ArrowDown');
  await thePage().keyboard.press('Enter');
  await record('depth test');
  // A finger has no right button: Open the menu, then a tap.
  await thePage().click('button.menu');
  await isMenuOpen(frame);
  const canvas = (await (await frame.$('canvas'))!.boundingBox())!;
  await thePage().mouse.click(canvas.x + 120 + 20, canvas.y + 120 + row(3));
  await record('look away');
});
/** Menus have a ground of the pop-up planes' grey. */
const isMenuOpen = (frame: Frame) =>
  frame.waitForFunction(() => {
    const canvas = document.querySelector('canvas')!;
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    let grey = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i] === 170 && data[i + 1] === 170 && data[i + 2] === 170) ++grey;
    return grey > 1000;
  });

/** The rows of the table of events: step, what, index, Z, stored Z, outcome. */
const events = () =>
  thePage().$$eval('.events tbody tr', (rows) =>
    rows.map((row) => [...row.querySelectorAll('td')].map((cell) => cell.innerText.trim())),
  );
const numberOf = (words: string | undefined) => Number((words ?? '').replaceAll(',', ''));

it.each([
  ['en', 'written', 'killed: depth test', 'polygon or line', 'clear', 'Index'],
  ['ja', '書き込み', '棄却: デプステスト', 'ポリゴンか線分', '消去', 'インデックス'],
])(
  'tells the history of a pixel in %s',
  async (language, written, killed, drawn, cleared, index) => {
    await open(`#lang=${language}&exhibit=programs`);
    const program = await running();
    await thePage().click('.try-spin');
    const window = await restingPixels(program);
    await thePage().click('.record');
    await thePage().waitForSelector('figure.colors .stack');
    await lastStep();
    await thePage().click('figure.colors .stack'); // the middle: both blocks
    await thePage().waitForSelector('.events tbody tr');
    const [x, y] = await thePage().evaluate(() =>
      new URLSearchParams(location.hash.slice(1)).get('pixel')!.split(',').map(Number),
    );
    const rows = await events();
    const fragments = rows.filter(([, what]) => what === drawn);
    expect(fragments.length).toBeGreaterThan(3);
    for (const [, , , z, stored, outcome] of fragments) {
      expect([written, killed]).toContain(outcome);
      // The Z-buffer's rule: a fragment behind what is stored is not written.
      expect(numberOf(z) > numberOf(stored)).toBe(outcome === killed);
    }
    expect(fragments.map(([, , , , , outcome]) => outcome)).toContain(killed);
    const rgb = window.slice(4 * (y! * 480 + x!), 4 * (y! * 480 + x!) + 3);
    const last = fragments.filter(([, , , , , outcome]) => outcome === written).at(-1)!;
    expect(await text('.events .now')).toContain(`${index} ${last[2]}`);
    expect(await text('.events .now')).toContain(rgb.join(', '));
    // The program clears with the index 32.
    const clear = rows.findIndex(([, what]) => what === cleared);
    await (await thePage().$$('.events tbody button'))[clear]!.click();
    await thePage().waitForFunction(
      (words) => document.querySelector<HTMLElement>('.events .now')!.innerText.includes(words),
      {},
      `${index} 32`,
    );
  },
);

it('records several frames, and switches depth cueing by its menu', async () => {
  const frame = await begin('&program=flight&frames=4');
  const whole = await record();
  expect(await thePage().$$eval('select.frame option', (all) => all.length)).toBe(4);
  expect(countIn(whole, 'lines')).toBe(4 * countIn(whole, 'polygons')); // a patch and its edges
  /** The ramp of the lines has many brightnesses; without cueing there is one. */
  const greens = async () => {
    const data = await pixelsOf(frame, 'canvas');
    const lines = new Set<number>();
    for (let i = 0; i < data.length; i += 4) if (data[i + 1]! > 50) lines.add(data[i + 1]!);
    return lines.size;
  };
  expect(await greens()).toBeGreaterThan(5);
  await thePage().click('.try-cueing');
  for (let tries = 0; tries < 200 && (await greens()) > 1; ++tries)
    await new Promise((done) => setTimeout(done, 200));
  expect(await greens()).toBe(1);
});

it('shows the overlay planes of a recording, and their map', async () => {
  await begin('&program=flight');
  await record();
  const planes = () =>
    thePage().$$eval('select.planes option', (all) => all.map((e) => (e as HTMLElement).innerText));
  expect(await planes()).toEqual(['window 1', 'window 1, overlay']);
  const whole = await text('.recording .whole');
  await thePage().select('select.planes', 'window 1 overlay');
  await thePage().waitForFunction(
    (old) => document.querySelector<HTMLElement>('.recording .whole')!.innerText.trim() !== old,
    {},
    whole,
  );
  await lastStep();
  const isDrawn = (data: number[]) =>
    data.some((r, i) => i % 4 === 0 && r === 255 && data[i + 1] === 40 && data[i + 2] === 40);
  await thePage().waitForFunction(() => !document.querySelector('.busy'));
  expect(isDrawn(await pixelsOf(thePage(), 'figure.colors canvas'))).toBe(true);
});

it('says when the program has ended, and begins again', async () => {
  const frame = await begin();
  await frame.focus('canvas');
  await thePage().keyboard.press('Escape');
  await frame.waitForSelector('body[data-status="0"]');
  await thePage().waitForSelector('.record:disabled');
  await thePage().click('.again');
  await running();
});

it.each(['en', 'ja'])(
  'says what is missing without the page of a program, in %s',
  async (language) => {
    const alone = join(mkdtempSync(join(tmpdir(), 'lab-')), 'lab.html');
    copyFileSync(lab, alone);
    await thePage().goto(`file://${alone}#lang=${language}&exhibit=programs`);
    await thePage().waitForSelector('[role=alert]');
    const says = await text('[role=alert]');
    expect(says).toContain('programs/hidden.html');
    expect(says).toContain(language === 'en' ? 'is not here' : 'ページがありません');
    expect(await thePage().$('.record:enabled')).toBeNull();
  },
);

it.each(['en', 'ja'])(
  'has no barriers, with a recording and in the program, in %s',
  async (language) => {
    await open(`#lang=${language}&theme=dark&exhibit=programs`);
    const frame = await running();
    await thePage().click('.record');
    await thePage().waitForSelector('figure.colors .stack');
    await thePage().click('figure.colors .stack');
    await thePage().waitForSelector('.events tbody tr');
    expect(await barriersOf(thePage())).toEqual([]);
    expect(await barriersOf(frame)).toEqual([]);
    expect(await frame.$eval('.close', (e) => e.getAttribute('aria-label'))).toBe(
      language === 'en' ? 'Close' : '閉じる',
    );
  },
);

it.each(['en', 'ja'])('fits a phone, in %s', async (language) => {
  await open(`#lang=${language}&exhibit=programs`, 390, 844);
  await running();
  await thePage().click('.record');
  await thePage().waitForSelector('figure.colors .stack');
  await thePage().click('figure.colors .stack');
  await thePage().waitForSelector('.events tbody tr');
  const [content, screen] = await thePage().evaluate(() => [
    document.documentElement.scrollWidth,
    window.innerWidth,
  ]);
  expect(content).toBeLessThanOrEqual(screen!);
});
