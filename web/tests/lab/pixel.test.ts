// The exhibit of one pixel: its numbers are the machine's, and a hand can drag, type and click.
import { expect, it } from 'vitest';
import type { PixelFacts, PixelOptions } from '../../lab/pixel/protocol';
import { inChromium, open, thePage, type LabWindow } from './page';

inChromium();
const begin = async (rest = '') => {
  await open(`#lang=en&exhibit=pixel&scene=hidden/cycle.toml&size=64x48${rest}`);
  await thePage().waitForSelector('svg.grid');
};
const text = (selector: string) =>
  thePage().$eval(selector, (e) => e.textContent?.trim().replace(/\s+/g, ' ') ?? '');
const explain = (all: PixelOptions[]): Promise<PixelFacts[]> =>
  thePage().evaluate(async (all) => {
    const { machine } = window as unknown as LabWindow;
    return Promise.all(all.map((options) => machine.ask('pixel', options)));
  }, all);

const corner = (x: number, y: number, z: number, w: number, color: number[], s = 0, t = 0) => ({
  ...{ x, y, z, w, color, s, t },
});
const plain = { filter: 'none', env: 'modulate', blend: 'none', background: [0, 0, 0, 1] };

it("has the numbers of the manual's worked triangle", async () => {
  await begin();
  const white = [1, 1, 1, 1];
  const z = (units: number) => units / (2 ** 24 - 1);
  const [facts] = await explain([
    {
      ...{ ...plain, profile: 'vgx', width: 80, height: 64, x: 20, y: 20 },
      corners: [
        corner(82, 28, z(1000000), 1, [0, 1, 1, 1]),
        corner(561, 160, z(5000000), 1, white),
        corner(120, 486, z(9000000), 1, [128 / 255, 1, 1, 1]),
      ],
    },
  ]);
  expect(facts!.area2).toBe(214366);
  expect(facts!.sides.map(({ dx, dy }) => [dx, dy])).toEqual([
    [479, 132],
    [-441, 326],
    [-38, -458],
  ]);
  expect(facts!.sides.map((side) => side.e)).toEqual([54319, 127657, 32388]);
  expect(facts!.sides.map((side) => side.top_left)).toEqual([false, false, true]);
  expect([facts!.depth!.gx, facts!.depth!.gy]).toEqual(['1897910527', '9000400437']);
  expect(facts!.depth!.value).toBe(3631537);
  expect(facts!.color_planes!.map((plane) => plane.value)).toEqual([71, 255, 255, 255]);
});

it("explains every pixel by the machine's own bits", async () => {
  await begin();
  const corners = (unit: number) => [
    corner(13.5 * unit, 1.25 * unit, 0.2, 1, [1, 0.1, 0, 1], 1.6, -0.2),
    corner(6.25 * unit, 10.5 * unit, 0.8, 2, [0.2, 0.9, 0.3, 0.5], 0, 1),
    corner(1.5 * unit, 2.375 * unit, 0.5, 0.7, [0.1, 0.3, 1, 0.75]),
  ];
  const styles = [
    plain,
    { filter: 'nearest', env: 'replace', blend: 'add', background: [0.3, 0.2, 0.9, 1] },
    { filter: 'linear', env: 'modulate', blend: 'over', background: [0.3, 0.2, 0.9, 1] },
    { filter: 'linear', env: 'blend', blend: 'modulate', background: [0.3, 0.2, 0.9, 0.5] },
  ];
  let inside = 0;
  for (const [profile, unit] of [
    ['vgx', 8],
    ['reality', 8],
    ['ideal', 256],
  ] as const)
    for (const style of styles) {
      const all = Array.from({ length: 16 * 12 }, (_, i) => ({
        ...{ ...style, profile, width: 16, height: 12, x: i % 16, y: Math.floor(i / 16) },
        corners: corners(unit),
      }));
      for (const [i, facts] of (await explain(all)).entries()) {
        const { x, y } = all[i]!;
        expect(facts.inside).toBe(facts.covered.some(([a, b]) => a === x && b === y));
        expect(facts.inside).toBe(facts.sides.every((side) => side.e >= 0));
        expect(facts.steps.map((step) => step.stepped)).toEqual(
          facts.steps.map((step) => step.closed),
        );
        if (!facts.inside) continue;
        inside += 1;
        expect(facts.machine!.depth).toBe(facts.depth!.value);
        expect(facts.machine!.color).toEqual(facts.shaded);
        expect(facts.machine!.after).toEqual(facts.blend?.result ?? facts.shaded);
      }
    }
  expect(inside).toBeGreaterThan(500);
});

it('moves a corner by the mouse and by keys, and keeps it in the link', async () => {
  await begin();
  const corners = async () => {
    const address = await thePage().evaluate(() => location.hash);
    return new URLSearchParams(address.slice(1)).get('corners')!.split(';');
  };
  const before = await corners();
  const handle = (await thePage().$$('g.corner'))[1]!;
  const box = (await handle.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await thePage().mouse.move(x, y);
  await thePage().mouse.down();
  await thePage().mouse.move(x + 60, y + 30, { steps: 4 });
  await thePage().mouse.up();
  const label = await handle.evaluate((e) => e.getAttribute('aria-label')!);
  const left = Number(/: (-?\d+),/.exec(label)![1]);
  expect(left).not.toBe(Number(before[1]!.split(',')[0]));
  await thePage().keyboard.press('ArrowRight');
  await thePage().waitForFunction((corner) => location.hash.includes(`;${corner},`), {}, left + 1);
  const moved = await corners();
  expect([moved[0], moved[2]]).toEqual([before[0], before[2]]);
  await thePage().reload();
  await thePage().waitForSelector('svg.grid');
  expect(await corners()).toEqual(moved);
});

it('explains the pixel that is clicked', async () => {
  await begin();
  expect(await text('.which')).toBe('Pixel 6, 4: covered');
  const box = (await (await thePage().$('svg.grid'))!.boundingBox())!;
  await thePage().mouse.click(box.x + box.width * 0.95, box.y + box.height * 0.07);
  await thePage().waitForFunction(() =>
    document.querySelector('.which')?.textContent?.includes('not covered'),
  );
  expect(await text('.which')).toMatch(/^Pixel 15, 11/);
});

it('shows the history of a pixel of the scene', async () => {
  await begin('&profile=ideal');
  await thePage().waitForSelector('.any .stack');
  await thePage().click('.any .stack');
  await thePage().waitForSelector('.any .history table');
  expect(await text('.any .history thead')).toContain('outcome');
});

it('fits a phone, in Japanese', async () => {
  await open('#lang=ja&exhibit=pixel&scene=hidden/cycle.toml&size=64x48', 390, 800);
  await thePage().waitForSelector('svg.grid');
  const [content, screen] = await thePage().evaluate(() => [
    document.documentElement.scrollWidth,
    window.innerWidth,
  ]);
  expect(content).toBeLessThanOrEqual(screen!);
});
