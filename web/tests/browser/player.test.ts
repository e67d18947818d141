// The player in a real browser: Debian's Chromium clicks, drags, types and reads.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer, { type Browser, type Page } from 'puppeteer-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { pageOf } from '../page';
import { text } from '../sample';

const folder = mkdtempSync(join(tmpdir(), 'gw-player-'));
let browser: Browser;
let page: Page;
let complaints: string[];

async function open(logs: readonly string[], hash = '', width = 1280, height = 720): Promise<void> {
  const file = join(folder, 'player.html');
  writeFileSync(file, pageOf(logs));
  await page.setViewport({ width, height });
  await page.goto(`file://${file}${hash}`);
  await page.waitForSelector('section, .open, #app:not(:empty)');
}
const textOf = (selector: string) => page.$eval(selector, (e) => e.textContent?.trim() ?? '');
const hash = () => page.evaluate(() => location.hash);
/** The colour of a pixel of the picture. */
const colorAt = (x: number, y: number) =>
  page.$eval(
    'canvas',
    (canvas, x, y) => [
      ...(canvas as HTMLCanvasElement).getContext('2d')!.getImageData(x, y, 1, 1).data,
    ],
    x,
    y,
  );

beforeAll(async () => {
  browser = await puppeteer.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu'],
  });
});
afterAll(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});
beforeEach(async () => {
  complaints = [];
  page = await browser.newPage();
  page.on('console', (message) => {
    const isAboutTest = message.text().includes('willReadFrequently');
    if (['error', 'warn'].includes(message.type()) && !isAboutTest) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`request of ${request.url()}`);
  });
});
afterEach(async () => {
  expect(complaints).toEqual([]);
  await page.close();
});

describe('the player', () => {
  it('steps on, back, to decisive steps and to the ends by keys', async () => {
    await open([text()], '#lang=en');
    expect(await textOf('output')).toBe('0 of 5');
    await page.keyboard.press('ArrowRight');
    expect(await textOf('.sentence')).toBe('1, 2.');
    await page.keyboard.down('Shift');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.up('Shift');
    expect(await textOf('output')).toBe('3 of 5');
    expect(await textOf('.sentence')).toBe('2 cuts 1.');
    await page.keyboard.press('End');
    expect(await colorAt(2, 3)).toEqual([255, 0, 0, 255]);
    expect(await colorAt(8, 3)).toEqual([0, 0, 255, 255]);
    await page.keyboard.press('ArrowLeft');
    expect(await colorAt(8, 3)).toEqual([255, 0, 0, 255]);
    expect(await colorAt(12, 3)).toEqual([0, 0, 0, 255]);
    await page.keyboard.press('Home');
    expect(await colorAt(2, 3)).toEqual([0, 0, 0, 255]);
  });

  it('scrubs, plays and pauses', async () => {
    await open([text()], '#lang=en');
    await page.$eval('input[type=range]', (input) => {
      (input as HTMLInputElement).value = '4';
      input.dispatchEvent(new Event('input', { bubbles: true }));
    });
    expect(await textOf('output')).toBe('4 of 5');
    await page.keyboard.press('Home');
    await page.select('.bar select', '30');
    await page.click('button.play');
    await page.waitForFunction(() => document.querySelector('output')?.textContent === '5 of 5');
    await page.waitForFunction(() => document.querySelector('button.play')?.textContent === 'Play');
  });

  it('goes to a step by the list, and finds steps of a polygon', async () => {
    await open([text()], '#lang=en');
    await page.type('input[type=search]', 'split');
    const rows = await page.$$('.list button');
    expect(rows).toHaveLength(1);
    await rows[0]!.click();
    expect(await textOf('output')).toBe('3 of 5');
    expect(await page.$$eval('.stack text', (all) => all.map((t) => t.textContent))).toContain(
      '1a',
    );
  });

  it('opens the same page again by its link', async () => {
    await open(
      [text()],
      '#step=4&view=side&pixel=8,3&lang=ja&theme=dark&projector=1&colors=distinct',
    );
    const address = await hash();
    expect(address).toContain('step=4');
    expect(await textOf('.sentence')).toBe('1a：80 画素。');
    expect(await page.$eval('[role=tab][aria-selected=true]', (e) => e.textContent)).toBe(
      '横から見た図',
    );
    expect(await page.evaluate(() => document.documentElement.dataset['theme'])).toBe('dark');
    await page.reload();
    await page.waitForSelector('section');
    expect(await hash()).toBe(address);
  });

  it('follows a pixel that is clicked', async () => {
    await open([text()], '#lang=en');
    const box = (await (await page.$('.stack'))!.boundingBox())!;
    await page.mouse.click(box.x + box.width * (8.5 / 16), box.y + box.height * (3.5 / 8));
    expect(await hash()).toContain('pixel=8,3');
    const next = await page.$('::-p-text(Next step at this pixel)');
    await next!.click();
    expect(await textOf('output')).toBe('4 of 5');
    await next!.click();
    expect(await textOf('output')).toBe('5 of 5');
    expect((await textOf('.lower-tools span')).replace(/\s+/g, ' ')).toBe('Pixel 8, 3: 2');
  });

  it('shows every second view', async () => {
    await open([text()], '#step=5&lang=en');
    for (const tab of await page.$$('[role=tab]')) {
      await tab.click();
      const marks = await page.$$eval('figure:nth-of-type(2)', (all) =>
        all.map((f) => f.querySelectorAll('svg path, svg line, svg rect, li, tr').length),
      );
      expect(marks[0]).toBeGreaterThan(1);
    }
  });

  it('steps two logs by the same pixel', async () => {
    await open([text(), text().replace('"newell"', '"bsp"')], '#pixel=12,3&lang=en&step=0,4');
    expect(await page.$$('section')).toHaveLength(2);
    await (await page.$('.together ::-p-text(Next step at this pixel)'))!.click();
    expect(await page.$$eval('output', (all) => all.map((o) => o.textContent))).toEqual([
      '5 of 5',
      '5 of 5',
    ]);
  });

  it('fits a phone', async () => {
    await open([text()], '#step=5&lang=en', 390, 800);
    const [content, screen] = await page.evaluate(() => [
      document.documentElement.scrollWidth,
      window.innerWidth,
    ]);
    expect(content).toBeLessThanOrEqual(screen!);
  });

  it('saves a step as SVG and a range as GIF', async () => {
    await open([text()], '#step=3&lang=en');
    await page.evaluate(() => {
      const saved: Blob[] = [];
      Object.assign(window, { saved });
      URL.createObjectURL = (blob) => {
        saved.push(blob as Blob);
        return 'data:,';
      };
      HTMLAnchorElement.prototype.click = () => undefined;
    });
    const savedAt = (i: number) =>
      page.waitForFunction(
        async (i) => {
          const blob = (window as unknown as { saved: Blob[] }).saved[i];
          return (
            blob && { type: blob.type, size: blob.size, head: (await blob.text()).slice(0, 5) }
          );
        },
        {},
        i,
      );
    await (await page.$('.tools ::-p-text(SVG)'))!.click();
    expect(await (await savedAt(0)).jsonValue()).toMatchObject({ head: '<svg ' });
    await (await page.$('.tools ::-p-text(PNG)'))!.click();
    expect(await (await savedAt(1)).jsonValue()).toMatchObject({ type: 'image/png' });
    await (await page.$('summary'))!.click();
    await (await page.$('details ::-p-text(Save)'))!.click();
    expect(await (await savedAt(2)).jsonValue()).toMatchObject({ head: 'GIF89' });
  });

  it('asks for a file if it has no log, and says what is wrong with one', async () => {
    await open([], '#lang=en');
    const input = (await page.$('input[type=file]'))!;
    const bad = join(folder, 'bad.jsonl');
    writeFileSync(bad, '{"log":"other"}\n');
    await input.uploadFile(bad);
    await page.waitForSelector('[role=alert]');
    expect(await textOf('[role=alert]')).toContain('line 1: not a header');
    const good = join(folder, 'good.jsonl');
    writeFileSync(good, text());
    await (await page.$('input[type=file]'))!.uploadFile(good);
    await page.waitForSelector('section');
    expect(await textOf('output')).toBe('0 of 5');
  });
});
