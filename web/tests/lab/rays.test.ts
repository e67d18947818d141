// The exhibit of the item buffer and rays as a hand uses it, and its bits: those of gw compare and
// gw cast. Needs GW, the command.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { decode } from 'fast-png';
import { afterAll, expect, it } from 'vitest';
import { inChromium, open, thePage, type LabWindow } from './page';

const gw = process.env['GW'] ?? '../build/release/bin/gw';
const scenes = process.env['GW_SCENES'] ?? '../scenes';
const folder = mkdtempSync(join(tmpdir(), 'gw-lab-rays-'));
afterAll(() => rmSync(folder, { recursive: true }));
inChromium();

const text = (selector: string) => thePage().$eval(selector, (e) => e.textContent?.trim() ?? '');
const begin = async (rest = '') => {
  await open(`#lang=en&exhibit=rays&size=64x48${rest}`);
  await thePage().waitForSelector('figure.rays canvas');
  await thePage().waitForSelector('section.path');
  await shows('passes', [], false); // a canvas is there before its picture
};
const rgb = (values: ArrayLike<number>) => Array.from(values).filter((_, i) => i % 4 !== 3);
const pixels = async (figure: string) =>
  rgb(
    await thePage().$eval(`figure.${figure} canvas`, (e) => {
      const canvas = e as HTMLCanvasElement;
      const { width, height } = canvas;
      return [...canvas.getContext('2d')!.getImageData(0, 0, width, height).data];
    }),
  );
const picture = (name: string) => {
  const { data, channels } = decode(readFileSync(join(folder, name)));
  return channels === 4 ? rgb(data) : Array.from(data);
};
/** Waits until a figure shows these bytes, or others. */
const shows = (figure: string, bytes: number[], same: boolean) =>
  thePage().waitForFunction(
    (figure, bytes, same) => {
      const canvas = document.querySelector<HTMLCanvasElement>(`figure.${figure} canvas`)!;
      const { width, height } = canvas;
      const all = canvas.getContext('2d')!.getImageData(0, 0, width, height).data;
      const now = all.filter((_, i) => i % 4 !== 3);
      return now.some((v) => v > 0) && now.every((v, i) => v === bytes[i]) === same;
    },
    {},
    figure,
    bytes,
    same,
  );
const hash = () => thePage().evaluate(() => location.hash);

it.each(['fig9', 'crystal', 'fog', 'soft'])(
  'has both pictures of gw compare: %s',
  async (scene) => {
    execFileSync(gw, [
      ...['compare', `${scenes}/${scene}.toml`, '-o', join(folder, scene)],
      ...['--size', '64x48', '--quiet'],
    ]);
    await begin(`&scene=${scene}.toml`);
    const passes = await pixels('passes');
    expect(new Set(passes).size).toBeGreaterThan(20);
    expect(passes).toEqual(picture(`${scene}/item_buffer.png`));
    expect(await pixels('rays')).toEqual(picture(`${scene}/ray_tracing.png`));
    await thePage().click('.show-reasons');
    await thePage().waitForSelector('table.why');
    const counted = await thePage().$$eval('table.why tbody tr', (rows) =>
      rows.map((row) => Number(row.children[1]!.textContent!.replaceAll(',', ''))),
    );
    const table = readFileSync(join(folder, scene, 'differences.csv'), 'utf8')
      .trim()
      .split('\n');
    expect(counted).toEqual(table.slice(1).map((line) => Number(line.split(',')[1])));
  },
);

it('traces only the pixels that reflect, and counts both', async () => {
  await begin('&scene=fig9.toml');
  const row = (i: number) =>
    thePage().$$eval(
      '.costs table:first-of-type tbody tr',
      (rows, i) =>
        [...rows[i]!.children].slice(1).map((e) => Number(e.textContent!.replaceAll(',', ''))),
      i,
    );
  const [item, ordinary] = await row(0);
  expect(ordinary).toBe(64 * 48);
  expect(item).toBeGreaterThan(0);
  const said = (await text('figure.passes .below')).replaceAll(',', '');
  expect(Number(/^\d+/.exec(said)![0])).toBe(item);
  // Each traced pixel sends one reflected ray; shadow rays are left for their hits only.
  expect((await row(1))[0]).toBe(item);
  expect((await row(3))[0]!).toBeLessThan((await row(3))[1]!);
  await thePage().click('.show-traced');
  const grey = (values: number[]) => {
    let count = 0;
    for (let i = 0; i < values.length; i += 3)
      if (values[i] === values[i + 1] && values[i] === values[i + 2] && values[i]! <= 64) ++count;
    return count;
  };
  await thePage().waitForSelector('.show-traced[aria-pressed=true]');
  const dark = grey(await pixels('passes'));
  expect(dark).toBeGreaterThanOrEqual(64 * 48 - item!);
});

it('counts as traced the pixels that the passes trace, behind whose planes shadows lie', async () => {
  await open('#lang=en&exhibit=rays&size=320x240&scene=fig9.toml');
  await thePage().waitForFunction(() => {
    const number = (selector: string): string | undefined =>
      /^[\d,]+/.exec(document.querySelector(selector)?.textContent?.trim() ?? '')?.[0];
    const traced = number('figure.passes .below');
    return traced !== undefined && traced === number('.costs tbody tr td');
  });
});

it('follows the ray of the pixel under the mouse, and of both renderers', async () => {
  await begin('&scene=fig9.toml');
  expect(await text('.path h3')).toMatch(/^Pixel \d+, \d+: polygon \d+/);
  const rows = () => thePage().$$eval('.path tbody tr', (all) => all.map((r) => r.textContent));
  const rest = await rows();
  expect(rest[0]).toContain('from the eye');
  expect(rest[1]).toContain('reflected');
  const lines = () => thePage().$$eval('figure.outside svg path', (all) => all.length);
  expect(await lines()).toBe(2 * rest.length);
  // The same pixel as an ordinary ray tracer sees it: shadow rays from the first hit as well.
  await thePage().keyboard.press('r');
  await thePage().waitForFunction(
    (least) => document.querySelectorAll('.path tbody tr').length > least,
    {},
    rest.length,
  );
  await thePage().waitForFunction(() => location.hash.includes('ray=ordinary'));
  // A corner of the picture: a wall, which is not traced.
  await thePage().keyboard.press('r');
  const box = (await (await thePage().$('figure.passes .stack'))!.boundingBox())!;
  await thePage().mouse.move(box.x + 3, box.y + 3);
  await thePage().waitForSelector('.untraced');
  expect(await rows()).toHaveLength(1);
  await thePage().mouse.click(box.x + 3, box.y + 3);
  await thePage().waitForFunction(() => location.hash.includes('pixel='));
  expect(await hash()).toMatch(/pixel=\d+,\d+/);
});

it('moves the pixel by the keys, shows identifiers, and keeps all in the link', async () => {
  await begin('&scene=crystal.toml&depth=6&pixel=30,20');
  await thePage().keyboard.press('ArrowRight');
  await thePage().waitForFunction(() => location.hash.includes('pixel=31,20'));
  const picture = await pixels('passes');
  await thePage().keyboard.press('2');
  await thePage().waitForSelector('.show-identifiers[aria-pressed=true]');
  await shows('passes', picture, false);
  const ids = await pixels('passes');
  await thePage().reload();
  await thePage().waitForSelector('.show-identifiers[aria-pressed=true]');
  await thePage().waitForSelector('section.path');
  await shows('passes', ids, true);
  expect(await text('.path h3')).toContain('31, 20');
});

it('walks around the rays', async () => {
  await begin('&scene=fig9.toml');
  const line = () => thePage().$eval('figure.outside path.eye', (e) => e.getAttribute('d'));
  const before = await line();
  const box = (await (await thePage().$('figure.outside .stack'))!.boundingBox())!;
  await thePage().mouse.move(box.x + 40, box.y + 40);
  await thePage().mouse.down();
  await thePage().mouse.move(box.x + 90, box.y + 50, { steps: 4 });
  await thePage().mouse.up();
  await thePage().waitForFunction(() => location.hash.includes('from='));
  await thePage().waitForFunction(
    (before) => document.querySelector('figure.outside path.eye')?.getAttribute('d') !== before,
    {},
    before,
  );
});

/** "rays  3072  1.00": the numbers of the command's table. */
const printed = (table: string, name: string) =>
  Number(new RegExp(`^${name}\\s+(\\d+)`, 'm').exec(table)![1]);

it.each([
  ['hidden/solids', 'grid', 'crossings'],
  ['hidden/solids', 'hierarchy', 'angles'],
  ['hidden/solids', 'volumes', 'crossings'],
  ['radiosity/corridor', 'brute-force', 'products'],
  ['radiosity/corridor', 'grid', 'angles'],
])('casts rays as gw cast does: %s %s %s', async (scene, method, inside) => {
  const table = execFileSync(gw, [
    ...['cast', `${scenes}/${scene}.toml`, '--method', method, '--inside', inside],
    ...['-o', join(folder, 'cast.png'), '--tests', join(folder, 'tests.png')],
    ...['--size', '64x48', '--quiet'],
  ]).toString();
  await open('#lang=en&size=64x48&algorithm=z-buffer');
  await thePage().waitForSelector('.stack');
  const ours = await thePage().evaluate(
    async (path, options) => {
      const { machine } = window as unknown as LabWindow;
      await machine.ask('open', path);
      const run = await machine.ask('cast', options);
      return { ...run, picture: [...run.picture], tests: [...run.tests] };
    },
    `/scenes/${scene}.toml`,
    { width: 64, height: 48, profile: 'vgx', method, inside },
  );
  expect(rgb(ours.picture)).toEqual(picture('cast.png'));
  const grey = decode(readFileSync(join(folder, 'tests.png')));
  expect(rgb(ours.tests)).toEqual(
    grey.channels === 1 ? Array.from(grey.data).flatMap((v) => [v, v, v]) : Array.from(grey.data),
  );
  const { counts, shapes } = ours;
  expect([counts.rays, counts.shapes, counts.boxes, counts.voxels, shapes]).toEqual(
    ['rays', 'tests of shapes', 'tests of boxes', 'voxels', 'shapes in the scene'].map((name) =>
      printed(table, name),
    ),
  );
});

it('shows the voxels of a ray, and the costs of every method', async () => {
  await begin('&scene=hidden/solids.toml&pixel=32,24');
  await thePage().click('details.cast summary');
  await thePage().waitForSelector('figure.cast-picture canvas');
  for (const [method, row] of [
    ['brute-force', 1],
    ['volumes', 2],
    ['grid', 4],
  ] as const) {
    await thePage().select('select.method', method);
    await thePage().waitForSelector(`.methods tbody tr:nth-child(${row}).now td:nth-child(6)`);
  }
  await thePage().waitForFunction(
    () => document.querySelectorAll('.methods tbody td:not(.refused)').length === 20,
  );
  const tests = await thePage().$$eval('.methods tbody tr', (rows) =>
    rows.map((row) => Number(row.children[1]!.textContent!.replaceAll(',', ''))),
  );
  expect(Math.max(...tests)).toBe(tests[0]); // brute force
  await thePage().waitForSelector('figure.cast-space path.box');
  const boxes = await thePage().$$eval('figure.cast-space path.box', (all) => all.length);
  expect(await text('figure.cast-space figcaption')).toContain(`${boxes} voxels`);
  await thePage().waitForFunction(() => location.hash.includes('open=cast'));
});

it('refuses to cast rays for too long, and goes on', async () => {
  await begin('&scene=fig9.toml&open=cast&method=brute-force');
  await thePage().waitForSelector('p.refused');
  expect(await text('p.refused')).toMatch(/^about \de\+\d+ tests; expected at most/);
  await thePage().select('select.method', 'grid');
  await thePage().waitForSelector('figure.cast-picture canvas');
});

it('tells the inside tests apart', async () => {
  await begin('&scene=hidden/cycle.toml&open=inside');
  await thePage().waitForSelector('.tests svg');
  const cells = (test: string) => thePage().$$eval(`figure.${test} rect.cell`, (all) => all.length);
  const all = async () => [
    await cells('crossings'),
    await cells('products'),
    await cells('angles'),
  ];
  const star = await all();
  expect(star[0]).toBeLessThan(star[2]!); // wound twice: crossings have it outside
  expect(star[1]).toBeLessThan(star[2]!);
  await thePage().click('.polygon-concave');
  await thePage().waitForFunction(() => location.hash.includes('polygon='));
  await thePage().waitForFunction(
    (before) => document.querySelectorAll('figure.crossings rect.cell').length !== before,
    {},
    star[0],
  );
  const concave = await all();
  expect(concave[0]).toBe(concave[2]);
  expect(concave[1]).toBeLessThan(concave[0]!);
  await thePage().click('.polygon-convex');
  await thePage().waitForFunction(
    (before) => document.querySelectorAll('figure.products rect.cell').length !== before,
    {},
    concave[1],
  );
  const convex = await all();
  expect(new Set(convex).size).toBe(1);
  // A corner by the keys.
  await thePage().$eval('figure.angles .corner', (e) => (e as SVGElement).focus());
  await thePage().keyboard.press('ArrowRight');
  await thePage().waitForFunction(() => location.hash.includes('polygon=3.5,4,'));
});

it('opens a dropped scene, and has larger letters on a projector', async () => {
  await begin('&scene=crystal.toml');
  const letters = () =>
    thePage().evaluate(() => parseFloat(getComputedStyle(document.documentElement).fontSize));
  const small = await letters();
  await thePage().keyboard.press('p');
  await thePage().waitForFunction(() => location.hash.includes('projector=1'));
  expect(await letters()).toBeGreaterThan(small);
  await thePage().evaluate(() => {
    const material = '[material.mirror]\nKs = 0.9\nillum = 3\n';
    const object = '[[object]]\nshape = "sphere"\nmaterial = "mirror"\n';
    const data = new DataTransfer();
    data.items.add(new File([material + object], 'ball.toml'));
    window.dispatchEvent(new DragEvent('drop', { dataTransfer: data }));
  });
  await thePage().waitForFunction(
    () => document.querySelector<HTMLSelectElement>('select.scene')?.value === 'own/ball.toml',
  );
  await thePage().waitForFunction(
    () => document.querySelector('.path tbody')?.textContent?.includes('reflected') === true,
  );
});

it('goes on after a stop', async () => {
  await open('#lang=en&exhibit=rays&size=640x480&scene=fig9.toml&depth=10');
  const stop = await thePage().waitForSelector('.choices [role=status] + button');
  await stop!.click();
  await thePage().waitForSelector('[role=alert]');
  expect(await text('[role=alert]')).toBe('Stopped.');
  await thePage().select('select.size', '64x48');
  await thePage().waitForSelector('section.path');
  expect(await thePage().$('[role=alert]')).toBeNull();
});

it('fits a phone, in Japanese', async () => {
  await open('#lang=ja&exhibit=rays&size=64x48&scene=crystal.toml&open=cast,inside', 390, 844);
  await thePage().waitForSelector('section.path');
  await thePage().waitForSelector('figure.cast-picture canvas');
  await thePage().waitForSelector('.tests svg');
  const [content, screen] = await thePage().evaluate(() => [
    document.documentElement.scrollWidth,
    window.innerWidth,
  ]);
  expect(content).toBeLessThanOrEqual(screen!);
});
