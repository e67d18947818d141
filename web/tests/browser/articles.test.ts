// The articles with the logs of the command: every name in a text exists, and the page does what
// the text promises.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Frame } from 'puppeteer-core';
import { build } from 'vite';
import { beforeAll, describe, expect, it } from 'vitest';
import { knowsPiece, placeOf, runNumber } from '../../articles/bind';
import { argumentsOf, runs } from '../../articles/figures';
import { filmNumber, frameOf } from '../../articles/film';
import { films } from '../../articles/films';
import { makeFilm } from '../../articles/make_film';
import { linesOf, stepNameOf } from '../../articles/markup';
import { articleOf, models, topics } from '../../articles/topics';
import { parseLog } from '../../model/steps/log';
import { Replay } from '../../model/steps/replay';
import { barriersOf } from '../barriers';
import { LearningPlatform, packagesOf } from '../platform';
import { describePages } from './browser';

const gw = process.env['GW'] ?? '';
const scenes = process.env['GW_SCENES'] ?? '';
const ids = topics.map(({ id }) => id);

describe.skipIf(gw === '')('a run that an article shows', () => {
  it.each(Object.keys(runs))('%s has every step, piece and number that is named', (name) => {
    const run = runs[name]!;
    const folder = mkdtempSync(join(tmpdir(), 'gw-article-'));
    execFileSync(gw, argumentsOf(run, scenes, folder), { stdio: 'ignore' });
    const replay = new Replay(parseLog(readFileSync(join(folder, 'steps.jsonl'), 'utf8')));
    rmSync(folder, { recursive: true });
    const { steps } = replay.log;
    if (run.at) expect(placeOf(steps, stepNameOf(run.at)), run.at).toBeGreaterThan(0);
    for (const part of ids.flatMap((id) => linesOf(articleOf(id, 'en')).flat())) {
      if (!('figure' in part) || part.figure !== name) continue;
      const what = JSON.stringify(part);
      if (part.kind === 'piece') expect(knowsPiece(replay, part.name), what).toBe(true);
      else if (part.kind === 'step') expect(placeOf(steps, part.step), what).toBeGreaterThan(0);
      else expect(runNumber(replay, steps.length, part.name, part.step), what).toBeDefined();
    }
  });
});

describe.skipIf(gw === '')('a film that an article shows', () => {
  it.each(Object.keys(films))(
    '%s has every frame and number that is named, and a picture for each frame',
    (name) => {
      const figure = films[name]!;
      const film = makeFilm(figure, gw, scenes);
      for (const part of ids.flatMap((id) => linesOf(articleOf(id, 'en')).flat())) {
        if (!('figure' in part) || part.figure !== name) continue;
        const what = JSON.stringify(part);
        if (part.kind === 'piece') expect.fail(`${what}: a film has no shapes`);
        else if (part.kind === 'step')
          expect(frameOf(figure, part.step), what).toBeGreaterThanOrEqual(0);
        else expect(filmNumber(figure, film, 0, part.name, part.step), what).toBeDefined();
      }
      const pictures = film.frames.map(({ picture }) => picture);
      for (const picture of pictures) expect(picture.slice(0, 11)).toBe('iVBORw0KGgo');
      expect(new Set(pictures).size).toBe(pictures.length);
    },
    300_000,
  );
});

/** In the page: what begins with a sign that ends a phrase, and stands on a line of its own. */
function badlyBegunLines(): string[] {
  const firstOf = (node: Node, from: number, to: number): DOMRect => {
    const range = document.createRange();
    range.setStart(node, from);
    range.setEnd(node, to);
    return range.getClientRects()[0] ?? new DOMRect();
  };
  return [...document.querySelectorAll('.piece, .step, .bound, strong')].flatMap((word) => {
    let after = word.nextSibling;
    while (after && !after.nodeValue) after = after.nextSibling; // Svelte's empty comments
    if (!after || !/^[.,;:!?)。、）」]/.test(after.nodeValue ?? '')) return [];
    const last = [...word.getClientRects()].at(-1)!;
    return firstOf(after, 0, 1).top < last.bottom ? [] : [`${word.textContent}${after.nodeValue}`];
  });
}

/** In the page: rows of lists that are wider than their boxes. */
const cutMarks = (): string[] =>
  [...document.querySelectorAll<HTMLElement>('.rows .piece')]
    .filter((row) => row.scrollWidth > row.clientWidth + 1)
    .map((row) => row.innerText);

describe.skipIf(gw === '')('the page', () => {
  const out = mkdtempSync(join(tmpdir(), 'gw-articles-page-'));
  beforeAll(async () => {
    process.env['GW_WEB_OUT'] = out;
    await build({ configFile: 'vite.articles.config.ts', logLevel: 'error' });
  }, 900_000);

  describePages('of the articles', (pages) => {
    const open = (hash: string, width?: number, height?: number) =>
      pages.openFile(join(out, 'index.html'), `#${hash}`, width, height);

    it('shows every article whole in both languages, on a telephone too', async () => {
      await open('', 390, 844);
      await pages.page.addStyleTag({ content: '.text p { max-width: 8em }' }); // many ends of lines
      for (const language of ['en', 'ja'] as const)
        for (const id of ids) {
          const { title } = articleOf(id, language);
          await pages.page.evaluate((hash) => {
            location.hash = hash;
          }, `article=${id}&lang=${language}`);
          await pages.page.waitForFunction(
            (title) =>
              document.querySelector('h1')?.textContent === title &&
              document.querySelectorAll('fieldset').length === 3,
            {},
            title,
          );
          expect(await pages.textsOf('output.bound'), title).not.toContain('–');
          expect(await pages.excess(), title).toBeLessThanOrEqual(0);
          expect(await pages.page.evaluate(badlyBegunLines), title).toEqual([]);
          expect(await pages.page.evaluate(cutMarks), title).toEqual([]);
        }
    }, 300_000);

    it('has no barriers that axe-core finds: in the list, with a run, a model and a film', async () => {
      for (const address of [
        'lang=en',
        ...['visibility', 'back-faces', 'radiosity'].map((id) => `article=${id}&lang=ja`),
      ]) {
        await open(address);
        await pages.page.waitForSelector('main li, figure canvas, figure svg, figure img');
        expect(await barriersOf(pages.page), address).toEqual([]);
      }
    }, 300_000);

    it('has links to the lab only if it is marked as standing beside it', async () => {
      const links = async (): Promise<string[]> =>
        pages.page.$$eval('a', (all) =>
          all.map((e) => e.getAttribute('href')!).filter((link) => link.startsWith('the-lab.html')),
        );
      await open('article=radiosity&lang=en');
      await pages.page.waitForSelector('figure img');
      expect(await links()).toEqual([]);
      const page = readFileSync(join(out, 'index.html'), 'utf8');
      expect(page).toContain('data-beside=""');
      writeFileSync(
        join(out, 'marked.html'),
        page.replace('data-beside=""', 'data-beside="the-lab.html"'),
      );
      await pages.openFile(join(out, 'marked.html'), '#article=radiosity&lang=en');
      await pages.page.waitForSelector('figure img');
      expect((await links()).length).toBeGreaterThan(1);
    });

    it('shows the picture of a film whose word is reached', async () => {
      await open('article=radiosity&lang=en');
      await pages.page.waitForSelector('figure img');
      const name = () => pages.page.$eval('figure img', (e) => (e as HTMLImageElement).alt);
      expect(await name()).toBe('1 shot');
      const words = await pages.page.$$('.step');
      await words[1]!.focus();
      expect(await name()).toBe('20 shots');
    });

    it('lights the shape of a word that Tab reaches, and moves the numbers of a dragged eye', async () => {
      await open('article=back-faces&lang=en');
      await pages.page.waitForSelector('figure svg');
      await pages.page.focus('.piece');
      expect(await pages.page.$$eval('g.lit', (all) => all.length)).toBeGreaterThan(0);
      const before = await pages.textsOf('output.bound');
      await pages.page.$eval('circle.eye', (e) => (e as SVGElement).focus());
      for (let i = 0; i < 12; ++i) await pages.page.keyboard.press('ArrowUp');
      for (let i = 0; i < 12; ++i) await pages.page.keyboard.press('ArrowLeft');
      expect(await pages.textsOf('output.bound')).not.toEqual(before);
      const eye = await (await pages.page.$('circle.eye'))!.boundingBox();
      const at = [eye!.x + eye!.width / 2, eye!.y + eye!.height / 2] as const;
      await pages.page.mouse.move(...at);
      await pages.page.mouse.down();
      await pages.page.mouse.move(at[0] + 120, at[1] + 60, { steps: 4 });
      await pages.page.mouse.up();
      const moved = await (await pages.page.$('circle.eye'))!.boundingBox();
      expect(Math.abs(moved!.x - eye!.x - 120)).toBeLessThan(30);
      expect(Math.abs(moved!.y - eye!.y - 60)).toBeLessThan(30);
    });

    it('goes to the step of a word, and lights the word of a polygon under the mouse', async () => {
      await open('article=visibility&lang=en');
      await pages.page.waitForSelector('figure canvas');
      const step = (await pages.page.$('.step'))!;
      await step.focus();
      expect(await pages.page.$eval('.step', (e) => e.classList.contains('now'))).toBe(true);
      const canvas = (await pages.page.$('figure canvas'))!;
      await canvas.scrollIntoView();
      const box = (await canvas.boundingBox())!;
      await pages.page.mouse.move(box.x + 0.3 * box.width, box.y + 0.75 * box.height);
      await pages.page.waitForSelector('.piece.lit');
    });

    it('has the figure below its heading on a telephone, and names what a figure shows', async () => {
      await open('article=visibility&lang=en', 390, 844);
      await pages.page.waitForSelector('figure canvas');
      const isAbove = await pages.page.$$eval('section.beside', (all) =>
        all.map((section) => {
          const top = (part: string) => section.querySelector(part)!.getBoundingClientRect().top;
          return top('h2') < top('figure') && top('figure') < top('.text');
        }),
      );
      expect(isAbove).toEqual(isAbove.map(() => true));
      const [source] = await pages.textsOf('.source');
      expect(source).toContain('Drawn in the order of the file');
      // It opens before the picture is spoilt.
      expect(await pages.textOf('.sentence')).toContain('1 is drawn');
    });

    it('tells at once whether an answer is right, and counts', async () => {
      await open('article=back-faces&lang=en');
      await pages.page.waitForSelector('fieldset');
      await pages.page.type('fieldset input[type=text]', '1');
      await pages.page.keyboard.press('Enter');
      expect(await pages.textOf('fieldset .feedback')).toContain('Not yet: too large');
      await pages.page.$$eval('fieldset', (all) =>
        all.forEach((e) => e.querySelectorAll<HTMLElement>('input[type=radio]')[1]?.click()),
      );
      expect(await pages.textOf('.score')).toBe('2 of 3 solved');
    });

    it('tells a learning platform score and completion, and goes on at the next visit', async () => {
      const page = join(out, 'index.html');
      packagesOf(pages.folder, page, page, '--language', 'ja');
      const zip = join(pages.folder, 'gw-newell-bsp.zip');
      const platform = new LearningPlatform(pages.folder, pages.page);
      const { title, exercises } = articleOf('newell-bsp', 'ja');
      const solve = async (frame: Frame, number: number): Promise<void> => {
        const box = (await frame.$$('fieldset'))[number]!;
        const wanted = exercises[number]!.number?.wanted;
        if (!wanted) {
          const right = exercises[number]!.answers.findIndex((answer) => answer.right);
          return (await box.$$('input[type=radio]'))[right]!.click();
        }
        const { look, spots } = models[wanted.figure]!;
        await (await box.$('input'))!.type(String(look(spots).values[wanted.name]));
        await pages.page.keyboard.press('Enter');
      };
      const told = async (): Promise<string[]> => [
        await platform.value('cmi.core.score.raw'),
        await platform.value('cmi.core.lesson_status'),
      ];

      let frame = await platform.run(zip);
      await frame.waitForSelector('fieldset');
      expect(await frame.$eval('h1', (e) => e.textContent)).toBe(title);
      expect(await frame.$$('header a, main nav')).toEqual([]); // one article, no way out of it
      expect(await told()).toEqual(['', 'incomplete']);
      await solve(frame, 0);
      await solve(frame, 1);
      expect(await told()).toEqual(['67', 'incomplete']);
      const kept = await platform.value('cmi.suspend_data');
      await platform.leave();
      const names = (await platform.calls()).map(([name]) => name);
      expect([names[0], names.at(-1)]).toEqual(['LMSInitialize', 'LMSFinish']);
      expect((await platform.calls()).filter(([, , error]) => error !== '0')).toEqual([]);
      expect((await platform.calls()).map(([, args]) => args.join('='))).toContain(
        'cmi.core.exit=suspend',
      );

      frame = await platform.run(zip, {
        suspend_data: kept,
        core: { entry: 'resume', lesson_status: 'incomplete', score: { raw: '67' } },
      });
      await frame.waitForSelector('fieldset');
      expect(await frame.$$eval('legend .done', (all) => all.length)).toBe(2);
      await solve(frame, 2);
      expect(await told()).toEqual(['100', 'completed']);
      await platform.leave();
      expect((await platform.calls()).filter(([, , error]) => error !== '0')).toEqual([]);
    });
  });
});
