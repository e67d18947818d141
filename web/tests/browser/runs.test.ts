// The player on runs of the command: each algorithm's page ends with the machine's picture.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { titleOf } from '../../words/names';
import { complaintsOf, launched } from './browser';

const gw = process.env['GW'] ?? '';
const scenes = process.env['GW_SCENES'] ?? '';
const folder = mkdtempSync(join(tmpdir(), 'gw-runs-'));
let browser: Browser;

beforeAll(async () => {
  browser = await launched();
});
afterAll(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const surfaces = [
  'a-buffer',
  'back-face',
  'bouknight',
  'bsp',
  'hierarchical-z',
  'newell',
  'painter-centroid',
  'painter-farthest',
  'painter-nearest',
  'quake',
  'ray-casting',
  'scan-line',
  'schumacker',
  'warnock',
  'watkins',
  'weiler-atherton',
  'z-buffer',
];

function run(algorithm: string, scene: string, level: string): string {
  const out = join(folder, algorithm);
  const size = ['--size', '64x48', '--quiet'];
  const file = join(scenes, 'hidden', `${scene}.toml`);
  execFileSync(gw, [
    'hidden',
    file,
    '--algorithm',
    algorithm,
    '--level',
    level,
    ...size,
    '--steps',
    out,
  ]);
  expect(existsSync(join(out, 'player.html'))).toBe(true);
  return out;
}

/** How many values of a canvas and of a picture file differ. */
async function wrongValues(page: Page, file: string, canvas: number): Promise<number> {
  return page.evaluate(
    async (file, place) => {
      const image = new Image();
      image.src = file;
      await image.decode();
      const canvas = document.querySelectorAll('canvas')[place]!;
      const wanted = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d')!;
      wanted.drawImage(image, 0, 0);
      const size = [0, 0, canvas.width, canvas.height] as const;
      const a = wanted.getImageData(...size).data;
      const b = canvas.getContext('2d')!.getImageData(...size).data;
      return a.reduce((count, value, i) => count + Number(value !== b[i]), 0);
    },
    `file://${file}`,
    canvas,
  );
}

/** Opens a run's last step. Tells what is on the page and what the browser complains about. */
async function lastStep(out: string) {
  const page = await browser.newPage();
  const complaints = complaintsOf(page);
  await page.goto(`file://${out}/player.html#step=100000000&lang=en`);
  await page.waitForSelector('section');
  const sentence = await page.$eval('.sentence', (e) => e.textContent ?? '');
  const wrong = await wrongValues(page, `${out}/picture.png`, 0);
  await page.close();
  return { sentence, wrong, complaints };
}

describe.skipIf(gw === '')('a run of gw hidden', () => {
  it.each(surfaces)('by %s ends with the picture of the machine', async (algorithm) => {
    const { sentence, wrong, complaints } = await lastStep(run(algorithm, 'cycle', 'span'));
    expect(complaints).toEqual([]);
    expect(wrong).toBe(0);
    expect(sentence).not.toContain('{');
    expect(sentence.length).toBeGreaterThan(10);
  });

  it.each(['appel', 'roberts'])('by %s draws lines', async (algorithm) => {
    const { sentence, complaints } = await lastStep(run(algorithm, 'solids', 'polygon'));
    expect(complaints).toEqual([]);
    expect(sentence).not.toContain('{');
  });

  it('compares: pictures and writes are those of the files, and all are in the table', async () => {
    const out = join(folder, 'compared');
    const file = join(scenes, 'hidden', 'cycle.toml');
    execFileSync(gw, ['hidden', file, '--size', '64x48', '--quiet', '--compare', out]);
    const page = await browser.newPage();
    const complaints = complaintsOf(page);
    await page.goto(`file://${out}/index.html#lang=en&plane=all&show=${surfaces.join(',')}`);
    await page.waitForSelector('figure');
    const names = await page.$$eval('figcaption b', (all) => all.map((b) => b.textContent!));
    expect([...names].sort()).toEqual(surfaces);
    const titles = await page.$$eval('figcaption .title', (all) => all.map((t) => t.textContent!));
    for (const [i, name] of names.entries())
      expect(titleOf(name, titles[i]!, 'ja'), name).not.toBe(titles[i]);
    for (const [i, name] of names.entries()) {
      expect(await wrongValues(page, `${out}/${name}.png`, 3 * i), name).toBe(0);
      expect(await wrongValues(page, `${out}/${name}_writes.png`, 3 * i + 2), name).toBe(0);
    }
    expect(complaints).toEqual([]);
    await page.close();
  });
});
