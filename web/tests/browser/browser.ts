// A page in Debian's Chromium: opened from disk. It may neither ask for the network nor complain.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer, { type Browser, type Page } from 'puppeteer-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect } from 'vitest';
import { pageOf } from '../page';

export const launched = (): Promise<Browser> =>
  puppeteer.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--allow-file-access-from-files'],
  });

/** What a page complains about and asks of the network from now on. */
export function complaintsOf(page: Page): string[] {
  const complaints: string[] = [];
  page.on('console', (message) => {
    const isAboutTest = message.text().includes('willReadFrequently');
    if (['error', 'warn'].includes(message.type()) && !isAboutTest) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`request of ${request.url()}`);
  });
  return complaints;
}

export class Pages {
  readonly folder = mkdtempSync(join(tmpdir(), 'gw-pages-'));
  private browser: Browser | undefined;
  private opened: Page | undefined;
  private complaints: string[] = [];

  get page(): Page {
    return this.opened!;
  }

  async start(): Promise<void> {
    this.browser = await launched();
  }
  async stop(): Promise<void> {
    await this.browser?.close();
    rmSync(this.folder, { recursive: true });
  }
  async begin(): Promise<void> {
    this.opened = await this.browser!.newPage();
    this.complaints = complaintsOf(this.page);
  }
  async end(): Promise<void> {
    expect(this.complaints).toEqual([]);
    await this.page.close();
  }

  /** Opens a built page with data in it. */
  async open(name: string, data: readonly string[], hash = ''): Promise<void> {
    const file = join(this.folder, `${name}.html`);
    writeFileSync(file, pageOf(name, data));
    await this.openFile(file, hash);
  }
  async openFile(file: string, hash = '', width = 1280, height = 720): Promise<void> {
    await this.page.setViewport({ width, height });
    await this.page.goto('about:blank'); // another address in the same file would not load it again
    await this.page.goto(`file://${file}${hash}`);
    await this.page.waitForSelector('main, #app:not(:empty)');
  }

  textOf(selector: string): Promise<string> {
    return this.page.$eval(selector, (e) => e.textContent?.trim() ?? '');
  }
  textsOf(selector: string): Promise<string[]> {
    return this.page.$$eval(selector, (all) => all.map((e) => e.textContent?.trim() ?? ''));
  }
  /** The address, when it has taken all changes: they wait for at most 240 ms (put_address.ts). */
  hash(): Promise<string> {
    return this.page.evaluate(async () => {
      let before: string;
      do {
        before = location.hash;
        await new Promise((done) => setTimeout(done, 300));
      } while (location.hash !== before);
      return before;
    });
  }
  /** The colour of a pixel of a canvas. */
  colorAt(x: number, y: number, canvas = 0): Promise<number[]> {
    return this.page.$$eval(
      'canvas',
      (all, x, y, canvas) => [...all[canvas]!.getContext('2d')!.getImageData(x, y, 1, 1).data],
      x,
      y,
      canvas,
    );
  }
  /** By how much the page is wider than the screen, once it has been laid out. */
  excess(): Promise<number> {
    return this.page.evaluate(async () => {
      const frame = () => new Promise((done) => requestAnimationFrame(done));
      for (let i = 0; i < 3; ++i) await frame();
      return document.documentElement.scrollWidth - window.innerWidth;
    });
  }
}

/** Tests that each have a page of their own. */
export function describePages(name: string, tests: (pages: Pages) => void): void {
  describe(name, () => {
    const pages = new Pages();
    beforeAll(() => pages.start());
    afterAll(() => pages.stop());
    beforeEach(() => pages.begin());
    afterEach(() => pages.end());
    tests(pages);
  });
}
