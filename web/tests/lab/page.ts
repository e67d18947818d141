// The built lab in Debian's Chromium, from disk.
import puppeteer, { type Browser, type Page } from 'puppeteer-core';
import { afterAll, afterEach, beforeAll, beforeEach, expect } from 'vitest';
import type { Machine } from '../../lab/machine/machine';
import type { Methods } from '../../lab/machine/protocol';

export const lab = process.env['GW_LAB'] ?? '../build/lab/index.html';

let browser: Browser;
let page: Page;
let complaints: string[];

export const thePage = (): Page => page;

/** Before each test a new page, or one for all; after it no complaint and no network request. */
export function inChromium(once = false, ...options: string[]): void {
  const before = once ? beforeAll : beforeEach;
  const after = once ? afterAll : afterEach;
  beforeAll(async () => {
    browser = await puppeteer.launch({
      executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
      args: ['--no-sandbox', '--disable-gpu', ...options],
      protocolTimeout: 600_000,
    });
  });
  afterAll(() => browser.close());
  before(async () => {
    complaints = [];
    page = await browser.newPage();
    page.setDefaultTimeout(100_000); // computers may be busy
    page.on('console', (message) => {
      const isAboutTest = message.text().includes('willReadFrequently');
      if (['error', 'warn'].includes(message.type()) && !isAboutTest)
        complaints.push(message.text());
    });
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('request', (request) => {
      if (!/^(file|data|blob):/.test(request.url())) complaints.push(`asks for ${request.url()}`);
    });
  });
  after(async () => {
    expect(complaints).toEqual([]);
    await page.close();
  });
}

export async function openFile(
  file: string,
  hash: string,
  width = 1280,
  height = 720,
): Promise<void> {
  await page.setViewport({ width, height });
  await page.goto(`file://${file}${hash}`);
  await page.waitForSelector('header');
}
export const open = (hash: string, width?: number, height?: number): Promise<void> =>
  openFile(lab, hash, width, height);

/** What every exhibit shows, the quiz as well; a program in its frame. */
export const picture = 'canvas, .question img, .window iframe';

/** Chooses the exhibit by the word on its tab. */
export const enter = (title: string) =>
  page.$$eval(
    'nav > button',
    (tabs, title) => {
      const tab = tabs.find((each) => each.textContent === title);
      if (!tab) throw new Error(`no tab ${title}`);
      tab.click();
    },
    title,
  );

export interface LabWindow {
  machine: Machine;
  facts: ReturnType<Methods['start']>;
}
