// The lecture's links into the lab: every command has one, and it opens what the command shows.
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { inChromium, open, picture, thePage } from './page';

const docs = `${process.env['GW_SCENES'] ?? '../scenes'}/../docs`;
const lecture = (name: string): string => readFileSync(`${docs}/${name}`, 'utf8');

interface Block {
  readonly commands: string[];
  /** The addresses after it. */
  readonly links: string[];
}
/** Every block of commands with the links that follow it. */
function blocksOf(text: string): Block[] {
  const blocks: Block[] = [];
  for (const part of text.split(/\n\n+/)) {
    const commands = part.split('\n').filter((line) => line.startsWith('    gw '));
    if (commands.length > 0) blocks.push({ commands, links: [] });
    const links = [...part.matchAll(/\(\.\.\/build\/lab\/index\.html(#[^)]*)\)/g)];
    blocks.at(-1)?.links.push(...links.map((link) => link[1]!));
  }
  return blocks;
}
const parts = (link: string) => new URLSearchParams(link.slice(1));
const option = (command: string, name: string): string | null =>
  new RegExp(`--${name} (\\S+)`).exec(command)?.[1] ?? null;

const lectures = ['lecture.md', 'lecture.ja.md'];
const everyLink = lectures.flatMap((name) => blocksOf(lecture(name)).flatMap((b) => b.links));

/** What the lists of steps say of the steps at which the link opens. */
const stepsShown = () =>
  thePage().$$eval('section.pane', (panes) =>
    panes.map((pane) => {
      const at = Number(/^\d+/.exec(pane.querySelector('.bar output')!.textContent!)![0]);
      const row = pane.querySelector('.list button.now');
      const blamed = pane.querySelector('.blame')?.textContent ?? '';
      const spoils = new RegExp(`\\D${at}\\D`).test(blamed);
      return { at, tells: at === 1 || spoils || row?.classList.contains('decisive') };
    }),
  );

describe("the lecture's links into the lab", () => {
  it.each(lectures)('%s has one for every command', (name) => {
    const blocks = blocksOf(lecture(name));
    expect(blocks.length).toBeGreaterThan(8);
    for (const { commands, links } of blocks) {
      expect(links.length, commands[0]).toBeGreaterThanOrEqual(commands.length);
      for (const [i, command] of commands.entries()) {
        const link = parts(links[i]!);
        if (name.includes('.ja.')) expect(link.get('lang')).toBe('ja');
        const scene = /scenes\/(\S+\.toml)/.exec(command)?.[1];
        if (scene) expect(link.get('scene')).toBe(scene);
        if (!option(command, 'algorithm')) continue;
        for (const key of ['algorithm', 'level', 'size', 'eye'])
          expect(link.get(key), command).toBe(option(command, key));
      }
    }
  });

  it('those of the syllabus, too, begin at a step', () => {
    const links = [...lecture('syllabus.md').matchAll(/#(exhibit=hidden[^)]*)\)/g)];
    expect(links).not.toHaveLength(0);
    for (const [, link] of links) expect(link).toContain('&step=');
  });

  inChromium();
  it.each(everyLink)('opens %s', async (link) => {
    await open(link);
    const wanted = parts(link);
    await thePage().waitForSelector(picture);
    expect(await thePage().$('[role=alert]')).toBeNull();
    const shown = await thePage().evaluate(() => ({
      exhibit: new URLSearchParams(location.hash.slice(1)).get('exhibit'),
      language: document.documentElement.lang,
      scene: document.querySelector<HTMLSelectElement>('select.scene')?.value,
      size: document.querySelector<HTMLSelectElement>('select.size')?.value,
      algorithms: [...document.querySelectorAll<HTMLSelectElement>('select.algorithm')]
        .map((select) => select.value)
        .filter((name) => name !== ''),
      samples: document.querySelector<HTMLInputElement>('input.samples')?.value ?? null,
    }));
    expect(shown.exhibit).toBe(wanted.get('exhibit'));
    if (wanted.has('lang')) expect(shown.language).toBe(wanted.get('lang'));
    if (wanted.has('scene')) expect(shown.scene).toBe(wanted.get('scene'));
    if (wanted.has('size')) expect(shown.size).toBe(wanted.get('size'));
    if (wanted.has('algorithm'))
      expect(shown.algorithms).toEqual(wanted.get('algorithm')!.split(','));
    if (wanted.has('samples')) expect(shown.samples).toBe(wanted.get('samples'));
    if (shown.exhibit !== 'hidden') return;
    await thePage().waitForSelector('.list button.now');
    const steps = await stepsShown();
    expect(steps.map(({ at }) => at).join()).toBe(wanted.get('step'));
    for (const { at, tells } of steps) expect(tells, `step ${at} decides nothing`).toBe(true);
  });
});
