// Reports of the command, opened from disk and used as a person would: mouse, then keyboard.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { barriersOf } from '../barriers';
import { describePages, type Pages } from './browser';

const gw = process.env['GW'] ?? '';
const scenes = process.env['GW_SCENES'] ?? '';

interface Event {
  pass: number;
  command: number;
  command_name: string;
  fate?: string;
  color?: number[];
  depth?: number;
  draw?: number;
  primitive?: number;
  polygon?: number;
  before: Record<string, number | number[]>;
  after: Record<string, number | number[]>;
}
const value = (v: number | number[] | undefined): string =>
  v === undefined ? '–' : Array.isArray(v) ? v.join(' ') : String(v);

/** The rows of a history, but for the pass, as `gw pixel` knows them. */
function rowsOf(
  recording: string,
  x: number,
  y: number,
  keep: (event: Event) => boolean = () => true,
): string[][] {
  const words = ['pixel', recording, String(x), String(y), '--json', '--quiet'];
  const json = JSON.parse(execFileSync(gw, words, { encoding: 'utf8' })) as { events: Event[] };
  const change = (event: Event, plane: string): string => {
    const [before, after] = [value(event.before[plane]), value(event.after[plane])];
    return before === after ? before : `${before} → ${after}`;
  };
  const used = (e: Event) => `${value(e.before['accum'])} ${value(e.after['accum'])}`;
  const accum = json.events.some((e) => /[1-9]/.test(used(e)));
  return json.events
    .filter(keep)
    .map((e) => [
      e.fate === undefined ? e.command_name : e.fate === 'written' ? e.fate : `killed: ${e.fate}`,
      value(e.color),
      value(e.depth),
      ...['color', 'depth', 'stencil', ...(accum ? ['accum'] : [])].map((p) => change(e, p)),
      String(e.command),
      value(e.draw),
      value(e.primitive),
      value(e.polygon),
    ]);
}

const rowsShown = (pages: Pages) =>
  pages.page.$$eval('#events tbody tr', (rows) =>
    rows.map((row) => [...row.children].slice(1).map((cell) => cell.textContent ?? '')),
  );
const loaded = (pages: Pages) =>
  pages.page.waitForFunction(() =>
    [...document.querySelectorAll<HTMLImageElement>('.stack img')].every((i) => i.naturalWidth > 0),
  );

describe.skipIf(gw === '')('a report', () => {
  describePages('of a recording', (pages) => {
    const at = (name: string) => join(pages.folder, name);
    const open = (name: string, hash = '') => pages.openFile(join(at(name), 'index.html'), hash);
    const heading = () => pages.textOf('#name');
    const tab = () =>
      pages.page.$eval('#planes [aria-selected=true]', (e) => (e as HTMLElement).dataset['plane']);
    const click = (selector: string) => pages.page.click(selector);
    const key = (name: 'ArrowRight' | 'ArrowDown' | 'Home' | 'End' | 'Tab' | 'Enter' | 'l') =>
      pages.page.keyboard.press(name);

    /** Clicks a pixel of the picture after the pass. */
    async function clickPixel(x: number, y: number, width: number, height: number): Promise<void> {
      await loaded(pages);
      const stage = (await pages.page.$$('figure[data-picture] .stack'))[1]!;
      const box = (await stage.boundingBox())!;
      await stage.click({
        offset: { x: ((x + 0.5) / width) * box.width, y: ((y + 0.5) / height) * box.height },
      });
      await pages.page.waitForFunction(
        (text) => document.getElementById('history-note')!.textContent!.includes(text),
        {},
        `${x}, ${y}:`,
      );
    }

    beforeAll(() => {
      const rings = join(scenes, 'rings.toml');
      const cycle = join(scenes, 'hidden', 'cycle.toml');
      const run = (...words: string[]) => execFileSync(gw, [...words, '--quiet']);
      run('record', rings, '-o', at('rings.gwt'), '--size', '96x72');
      run('inspect', at('rings.gwt'), '-o', at('rings'));
      const part = ['--passes', '2-5', '--history', '3-4', '--lang', 'ja'];
      run('inspect', at('rings.gwt'), '-o', at('part'), ...part);
      const newell = ['--size', '64x48', '--algorithm', 'newell'];
      run('record', cycle, '-o', at('newell.gwt'), ...newell);
      run('inspect', at('newell.gwt'), '-o', at('newell'));
    });

    it('lists passes with their pictures, and a click shows one', async () => {
      await open('rings', '#lang=en');
      expect(await pages.page.$$('#timeline button')).toHaveLength(8);
      await loaded(pages);
      await click('[data-pass="3"]');
      expect(await heading()).toBe('3 ambient key');
      expect(await pages.textOf('#set')).toBe('(Ka=object, Kd=0, Ks=0, Ke=0, Map=ambient map)');
      expect(await pages.page.$$('figure[data-picture]')).toHaveLength(3);
      expect(await pages.textOf('#counters')).toContain('fragments');
      expect(await pages.textOf('#counters .sum')).toMatch(
        /estimated time on a VGX\s*[\d.]+ (ms|µs|s)/,
      );
      expect(await pages.textOf('#state')).toContain('color_source');
      expect(await barriersOf(pages.page)).toEqual([]);
    });

    it('has a picture of every plane, before, after and the difference', async () => {
      await open('rings', '#pass=0&plane=color&lang=en');
      expect(await pages.page.$$('#planes button')).toHaveLength(5);
      for (const plane of ['color', 'depth', 'stencil', 'accum', 'polygons']) {
        await click(`#tab-${plane}`);
        expect(await tab()).toBe(plane);
        await loaded(pages);
        expect((await pages.textOf('#legend')).length).toBeGreaterThan(10);
      }
      await click('#tab-depth');
      const names = await pages.page.$$eval('figure', (all) =>
        all.map((f) => f.dataset['picture']),
      );
      expect(names[1]).toBe('0000_depth');
      expect(await pages.textOf('#tab-depth small')).toMatch(/[\d,]+ pixels changed/);
      await click('#tab-accum');
      expect(await pages.page.$$('#pictures .same')).toHaveLength(1);
    });

    it('shows the history that gw pixel prints', async () => {
      await open('rings', '#pass=3&plane=color&lang=en');
      const some = [
        [48, 36],
        [10, 60],
        [95, 0],
        [0, 71],
        [64, 7],
      ] as const;
      for (const [x, y] of some) {
        await clickPixel(x, y, 96, 72);
        expect(await rowsShown(pages)).toEqual(rowsOf(at('rings.gwt'), x, y));
        expect(await pages.page.$eval('#x', (e) => (e as HTMLInputElement).value)).toBe(String(x));
      }
      await clickPixel(60, 39, 96, 72);
      await click('#only');
      expect(await rowsShown(pages)).toEqual(
        rowsOf(at('rings.gwt'), 60, 39, (event) => event.pass === 3),
      );
      await click('#only');
      await (await pages.page.$$('#events .link')).at(-1)!.click();
      expect(await heading()).toBe('7 specular fill');
    });

    it('keeps the language with the address', async () => {
      await open('rings', '#pass=3&plane=stencil&lang=en');
      await pages.page.select('.page-language', 'ja');
      expect(await pages.page.evaluate(() => document.documentElement.lang)).toBe('ja');
      expect(await pages.textOf('#tab-stencil')).toContain('ステンシル');
      expect(await pages.textOf('#facts')).toContain('推定時間');
      expect(await heading()).toBe('3 環境光 key');
      expect(await pages.hash()).toContain('lang=ja');
      await pages.page.reload();
      await pages.page.waitForSelector('main');
      expect(await pages.page.evaluate(() => document.documentElement.lang)).toBe('ja');
    });

    it('is reached by the keyboard everywhere', async () => {
      await open('rings', '#pass=0&plane=color&lang=en');
      await key('ArrowRight');
      expect(await heading()).toBe('1 count winners');
      await key('End');
      expect(await heading()).toBe('7 specular fill');
      const isInSight = () =>
        document.querySelector('#timeline [aria-current=true]')!.getBoundingClientRect().bottom <=
        innerHeight;
      expect(await pages.page.evaluate(isInSight)).toBe(true);
      expect(await pages.page.evaluate(() => scrollY)).toBe(0);
      await key('ArrowRight');
      expect(await heading()).toBe('7 specular fill');
      await key('Home');
      expect(await heading()).toBe('0 depth');
      await pages.page.keyboard.press('2');
      expect(await tab()).toBe('depth');
      await key('l');
      expect(await pages.page.evaluate(() => document.documentElement.lang)).toBe('ja');
      await key('l');
      // Tab: the link to the content, the settings, the pass that is shown, the plane, a picture.
      const focused = () =>
        pages.page.evaluate(() => {
          const e = document.activeElement as HTMLElement;
          return e.dataset['pass'] ?? e.dataset['plane'] ?? e.className.split(' ')[0] ?? '';
        });
      const order: string[] = [];
      for (let i = 0; i < 11; ++i) {
        await key('Tab');
        order.push(await focused());
      }
      expect(order[0]).toBe('skip');
      expect(order).toContain('page-language');
      expect(order.slice(order.indexOf('0'), order.indexOf('0') + 3)).toEqual([
        '0',
        'depth',
        'pick',
      ]);
      await pages.page.type('#x', '48');
      await pages.page.type('#y', '36');
      await key('Enter');
      await pages.page.waitForSelector('#events tbody tr');
      expect(await rowsShown(pages)).toEqual(rowsOf(at('rings.gwt'), 48, 36));
      await pages.page.focus('#timeline [aria-current=true]');
      await key('ArrowDown');
      expect(await focused()).toBe('1');
      await pages.page.focus('#planes [aria-selected=true]');
      await key('ArrowRight');
      expect(await tab()).toBe('stencil');
      expect(await focused()).toBe('stencil');
      expect(await heading()).toBe('1 count winners');
    });

    it('shows a part of a recording: its passes, histories and language', async () => {
      await open('part');
      expect(await pages.page.evaluate(() => document.documentElement.lang)).toBe('ja');
      expect(await pages.page.$$('#timeline button')).toHaveLength(4);
      expect(await heading()).toBe('2 画素を数える');
      await pages.page.select('.page-language', 'en');
      expect(await pages.textOf('#history-note')).toContain('passes 3 to 4');
      await pages.page.keyboard.press('1');
      await clickPixel(48, 36, 96, 72);
      const kept = (event: Event) => event.pass === 3 || event.pass === 4;
      expect(await rowsShown(pages)).toEqual(rowsOf(at('rings.gwt'), 48, 36, kept));
    });

    it('begins with the identifiers of a hidden-surface algorithm', async () => {
      await open('newell', '#lang=en');
      await loaded(pages);
      expect(await tab()).toBe('identifiers');
      await pages.page.keyboard.press('1');
      expect(await tab()).toBe('color');
      await clickPixel(32, 24, 64, 48);
      expect(await rowsShown(pages)).toEqual(rowsOf(at('newell.gwt'), 32, 24));
    });

    it('fits screens and walls', async () => {
      await open('rings', '#pass=3&plane=color&lang=en');
      for (const [width, height] of [
        [390, 800],
        [1024, 768],
        [1280, 720],
        [3840, 2160],
      ] as const) {
        await pages.page.setViewport({ width, height });
        expect(await pages.excess(), `${width}`).toBeLessThanOrEqual(0);
      }
      const size = () => parseFloat(getComputedStyle(document.documentElement).fontSize);
      expect(await pages.page.evaluate(size)).toBeGreaterThanOrEqual(23);
    });
  });
});
