// The player in a real browser: Debian's Chromium clicks, drags, types and reads.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { storyIn } from '../../words/language';
import { blame, text } from '../samples/log';
import { describePages } from './browser';

const scenes = process.env['GW_SCENES'] ?? '';

describePages('the player', (pages) => {
  const open = (logs: readonly string[], hash = '') => pages.open('player', logs, hash);

  it('steps on, back, to decisive steps and to the ends by keys', async () => {
    await open([text()], '#lang=en');
    expect(await pages.textOf('output')).toBe('0 of 5');
    await pages.page.keyboard.press('ArrowRight');
    expect(await pages.textOf('.sentence')).toBe('1, 2.');
    await pages.page.keyboard.down('Shift');
    await pages.page.keyboard.press('ArrowRight');
    await pages.page.keyboard.press('ArrowRight');
    await pages.page.keyboard.up('Shift');
    expect(await pages.textOf('output')).toBe('3 of 5');
    expect(await pages.textOf('.sentence')).toBe('2 cuts 1.');
    await pages.page.keyboard.press('End');
    expect(await pages.colorAt(2, 3)).toEqual([255, 0, 0, 255]);
    expect(await pages.colorAt(8, 3)).toEqual([0, 0, 255, 255]);
    await pages.page.keyboard.press('ArrowLeft');
    expect(await pages.colorAt(8, 3)).toEqual([255, 0, 0, 255]);
    expect(await pages.colorAt(12, 3)).toEqual([0, 0, 0, 255]);
    await pages.page.keyboard.press('Home');
    expect(await pages.colorAt(2, 3)).toEqual([0, 0, 0, 255]);
  });

  it('scrubs, plays and pauses', async () => {
    await open([text()], '#lang=en');
    await pages.page.$eval('input[type=range]', (input) => {
      (input as HTMLInputElement).value = '4';
      input.dispatchEvent(new Event('input', { bubbles: true }));
    });
    expect(await pages.textOf('output')).toBe('4 of 5');
    await pages.page.keyboard.press('Home');
    await pages.page.select('.bar select', '30');
    await pages.page.click('button.play');
    await pages.page.waitForFunction(
      () => document.querySelector('output')?.textContent === '5 of 5',
    );
    await pages.page.waitForFunction(
      () => document.querySelector('button.play')?.textContent === 'Play',
    );
  });

  it('goes to a step by the list, and finds steps of a polygon', async () => {
    await open([text()], '#lang=en');
    await pages.page.type('input[type=search]', 'split');
    const rows = await pages.page.$$('.list button');
    expect(rows).toHaveLength(1);
    await rows[0]!.click();
    expect(await pages.textOf('output')).toBe('3 of 5');
    expect(
      await pages.page.$$eval('.stack text', (all) => all.map((t) => t.textContent)),
    ).toContain('1a');
  });

  it('opens the same page again by its link', async () => {
    await open(
      [text()],
      '#step=4&view=side&pixel=8,3&lang=ja&theme=dark&projector=1&colors=distinct',
    );
    const address = await pages.hash();
    expect(address).toContain('step=4');
    expect(await pages.textOf('.sentence')).toBe('1a：80 画素。');
    expect(await pages.page.$eval('[role=tab][aria-selected=true]', (e) => e.textContent)).toBe(
      '横から見た図',
    );
    expect(await pages.page.evaluate(() => document.documentElement.dataset['theme'])).toBe('dark');
    await pages.page.reload();
    await pages.page.waitForSelector('section');
    expect(await pages.hash()).toBe(address);
  });

  it('follows a pixel that is clicked', async () => {
    await open([text()], '#lang=en');
    const box = (await (await pages.page.$('.stack'))!.boundingBox())!;
    await pages.page.mouse.click(box.x + box.width * (8.5 / 16), box.y + box.height * (3.5 / 8));
    expect(await pages.hash()).toContain('pixel=8,3');
    const next = await pages.page.$('::-p-aria(Next step at this pixel)');
    await next!.click();
    expect(await pages.textOf('output')).toBe('4 of 5');
    await next!.click();
    expect(await pages.textOf('output')).toBe('5 of 5');
    expect((await pages.textOf('.at-pixel span')).replace(/\s+/g, ' ')).toBe('Pixel 8, 3: 2');
  });

  it('shows every second view', async () => {
    await open([text()], '#step=5&lang=en');
    for (const tab of await pages.page.$$('[role=tab]')) {
      await tab.click();
      const marks = await pages.page.$$eval('figure:nth-of-type(2)', (all) =>
        all.map((f) => f.querySelectorAll('svg path, svg line, svg rect, .piece, tr').length),
      );
      expect(marks[0]).toBeGreaterThan(1);
    }
  });

  it('steps two logs by the same pixel', async () => {
    await open([text(), text().replace('"newell"', '"bsp"')], '#pixel=12,3&lang=en&step=0,4');
    expect(await pages.page.$$('section')).toHaveLength(2);
    await (await pages.page.$('.together ::-p-text(Next step at this pixel)'))!.click();
    expect(await pages.page.$$eval('output', (all) => all.map((o) => o.textContent))).toEqual([
      '5 of 5',
      '5 of 5',
    ]);
  });

  it('fits a phone', async () => {
    await open([text()], '#step=5&lang=en');
    await pages.page.setViewport({ width: 390, height: 800 });
    expect(await pages.excess()).toBeLessThanOrEqual(0);
  });

  it('has a larger picture on a projector', async () => {
    const widthOf = async (look: string, width: number, height: number): Promise<number> => {
      await open([text()], `#step=3&lang=en${look}`);
      await pages.page.setViewport({ width, height });
      await pages.excess(); // once it has been laid out
      return pages.page.$eval('.stack', (e) => e.getBoundingClientRect().width);
    };
    for (const [width, height] of [
      [1280, 720],
      [1920, 1080],
    ] as const)
      expect(await widthOf('&projector=1', width, height)).toBeGreaterThan(
        1.1 * (await widthOf('', width, height)),
      );
  });

  it('shows what is wrong beside views that keep their size', async () => {
    for (const look of ['', '&projector=1']) {
      const heights: number[] = [];
      for (const log of [text(), text(blame)]) {
        await open([log], `#step=5&lang=en${look}`);
        await pages.page.setViewport({ width: 1280, height: 720 });
        await pages.excess(); // once it has been laid out
        heights.push(await pages.page.$eval('.second', (e) => e.getBoundingClientRect().height));
      }
      expect(heights[1], look).toBe(heights[0]);
      await pages.page.waitForSelector('.side > .blame button');
    }
  });

  it('shows all of a step without scrolling on a projector of 1280x720', async () => {
    for (const logs of [[text()], [text(blame)], [text(), text()]])
      for (const look of ['', '&projector=1'])
        for (const view of ['top', 'side', 'row', 'depth', 'list']) {
          await open(logs, `#step=3&lang=en&view=${view}${look}`);
          await pages.excess(); // once it has been laid out
          const parts = ['.bar', '.sentence', '.stack', '.second', '[role=tab]'];
          for (const part of parts)
            for (const bottom of await pages.page.$$eval(part, (all) =>
              all.map((e) => e.getBoundingClientRect().bottom),
            ))
              expect(bottom, `${part} of ${view}${look}`).toBeLessThanOrEqual(720);
        }
  });

  it('saves a step as SVG and a range as GIF', async () => {
    await open([text()], '#step=3&lang=en');
    await pages.page.evaluate(() => {
      const saved: Blob[] = [];
      Object.assign(window, { saved });
      URL.createObjectURL = (blob) => {
        saved.push(blob as Blob);
        return 'data:,';
      };
      HTMLAnchorElement.prototype.click = () => undefined;
    });
    const savedAt = (i: number) =>
      pages.page.waitForFunction(
        async (i) => {
          const blob = (window as unknown as { saved: Blob[] }).saved[i];
          return (
            blob && { type: blob.type, size: blob.size, head: (await blob.text()).slice(0, 5) }
          );
        },
        {},
        i,
      );
    await (await pages.page.$('.tools ::-p-text(SVG)'))!.click();
    expect(await (await savedAt(0)).jsonValue()).toMatchObject({ head: '<svg ' });
    await (await pages.page.$('.tools ::-p-text(PNG)'))!.click();
    expect(await (await savedAt(1)).jsonValue()).toMatchObject({ type: 'image/png' });
    await (await pages.page.$('.exports summary'))!.click();
    await (await pages.page.$('.exports ::-p-text(Save)'))!.click();
    expect(await (await savedAt(2)).jsonValue()).toMatchObject({ head: 'GIF89' });
  });

  it('prints a slide for each decisive step and the end, and is then as before', async () => {
    await open([text()], '#step=1&lang=en');
    await pages.page.evaluate(() => {
      window.print = () => {
        const decks = [...document.querySelectorAll('.deck > svg')];
        Object.assign(window, { printed: decks.map((e) => e.getAttribute('aria-label')) });
      };
    });
    await pages.page.click('button.slides');
    await pages.page.waitForFunction(() => 'printed' in window);
    expect(await pages.page.evaluate('printed')).toEqual([
      'Newell, Newell, Sancha 1 600.5, 600.5 is behind 2.',
      'Newell, Newell, Sancha 2 cuts 1.',
      'Newell, Newell, Sancha 2: 80 pixels.',
    ]);
    await pages.page.evaluate(() => dispatchEvent(new Event('afterprint')));
    expect(await pages.page.$$('.deck')).toEqual([]);
    expect(await pages.textOf('.bar output')).toBe('1 of 5');
  });

  it.skipIf(scenes === '')(
    'becomes a PDF and SVGs by scripts/slides, in the language asked for',
    async () => {
      await open([text()]);
      const player = join(pages.folder, 'player.html');
      const out = join(pages.folder, 'slides');
      execFileSync(join(scenes, '../scripts/slides'), [player, out, '--language', 'ja']);
      expect(readdirSync(out).sort()).toEqual([
        'slide_01.svg',
        'slide_02.svg',
        'slide_03.svg',
        'slides.pdf',
      ]);
      const pdf = readFileSync(join(out, 'slides.pdf'), 'latin1');
      expect(pdf.match(/\/Type\s*\/Page\b/g)).toHaveLength(3);
      expect(readFileSync(join(out, 'slide_03.svg'), 'utf8')).toContain('2：80 画素。');
      await pages.page.goto(`file://${join(out, 'slide_02.svg')}`);
      const size = await pages.page.$eval('svg', (e) => e.getBoundingClientRect().toJSON());
      expect(size).toMatchObject({ width: 1280, height: 720 });
      expect(await pages.page.$$eval('image', (all) => all.length)).toBe(1);
    },
    300_000,
  );

  it.skipIf(process.env['GW'] === undefined)(
    'shows the stages of a story as slides, in both languages, and names the stories',
    () => {
      const slides = (...options: string[]) =>
        execFileSync(join(scenes, '../scripts/slides'), options, { stdio: 'pipe' });
      for (const language of ['en', 'ja']) {
        const out = join(pages.folder, language);
        slides('painter', out, '--language', language);
        const said = storyIn('painter', language, true);
        const files = readdirSync(out).filter((name) => name.endsWith('.svg'));
        const texts = files.sort().map((name) => readFileSync(join(out, name), 'utf8'));
        expect(texts).toHaveLength(3);
        ['begin', 'distance.sorted', 'end'].forEach((stage, i) => {
          expect(texts[i]).toContain(said['title']);
          expect(texts[i]).toContain(`${said['title']} ${said[stage]}`);
        });
        expect(readFileSync(join(out, 'slides.pdf'), 'latin1')).toMatch(/^%PDF/);
      }
      expect(() => slides('nope', pages.folder)).toThrow(
        /no story; the stories are first, painter/,
      );
      expect(() => slides('first', pages.folder, '--size', '9x9')).toThrow(/has its own algorithm/);
    },
    300_000,
  );

  it('asks for a file if it has no log, and says what is wrong with one', async () => {
    await open([], '#lang=en');
    const input = (await pages.page.$('input[type=file]'))!;
    const bad = join(pages.folder, 'bad.jsonl');
    writeFileSync(bad, '{"log":"other"}\n');
    await input.uploadFile(bad);
    await pages.page.waitForSelector('[role=alert]');
    expect(await pages.textOf('[role=alert]')).toContain('line 1: not a header');
    const good = join(pages.folder, 'good.jsonl');
    writeFileSync(good, text());
    await (await pages.page.$('input[type=file]'))!.uploadFile(good);
    await pages.page.waitForSelector('section');
    expect(await pages.textOf('output')).toBe('0 of 5');
  });
});
