// Every exhibit by keys only: Tab, Enter, Space and arrows.
import { expect, it } from 'vitest';
import { inChromium, open, picture, thePage } from './page';

inChromium();
const keys = async (...all: Parameters<ReturnType<typeof thePage>['keyboard']['press']>[0][]) => {
  for (const key of all) await thePage().keyboard.press(key);
};
const hash = (): Promise<string> => thePage().evaluate(() => location.hash);
const part = async (name: string): Promise<string | null> =>
  new URLSearchParams((await hash()).slice(1)).get(name);
/** Until the address has another value of it. */
const changes = async (name: string, act: () => Promise<void>): Promise<void> => {
  const before = await part(name);
  await act();
  await thePage().waitForFunction(
    (key, old) => new URLSearchParams(location.hash.slice(1)).get(key) !== old,
    {},
    name,
    before,
  );
};
/** Presses Tab until the element has the focus. */
async function tabTo(selector: string): Promise<void> {
  for (let i = 0; i < 150; ++i) {
    await keys('Tab');
    if (await thePage().evaluate((s) => document.activeElement?.matches(s) ?? false, selector))
      return;
  }
  throw new Error(`Tab does not reach ${selector}`);
}

it('enters every exhibit, and its link opens it again', async () => {
  await open('#lang=en&size=64x48');
  await thePage().waitForSelector('canvas');
  const seen = new Set<string | null>();
  const tabs = await thePage().$$eval('nav > button', (buttons) => buttons.length);
  for (let place = 1; place <= tabs; ++place) {
    const before = await hash();
    await thePage().evaluate(() => (document.activeElement as HTMLElement).blur());
    await tabTo(`nav > button:nth-of-type(${place})`);
    await keys('Enter');
    if (place > 1) await thePage().waitForFunction((old) => location.hash !== old, {}, before);
    await thePage().waitForSelector(picture);
    const exhibit = await part('exhibit');
    seen.add(exhibit);
    await open(await hash());
    await thePage().waitForSelector(picture);
    expect(await part('exhibit')).toBe(exhibit);
  }
  expect(seen.size).toBe(tabs);
});

it('chooses an algorithm, steps, turns the eye and follows a pixel', async () => {
  await open('#lang=en&size=64x48&exhibit=hidden');
  await thePage().waitForSelector('.stack');
  await tabTo('.choices select');
  await changes('algorithm', () => keys('ArrowDown'));
  await tabTo('.stack button');
  await changes('pixel', () => keys('ArrowRight'));
  await changes('pixel', () => keys('ArrowDown'));
  await thePage().keyboard.down('Alt');
  await changes('eye', () => keys('ArrowLeft'));
  await changes('eye', () => keys('PageUp'));
  await thePage().keyboard.up('Alt');
});

it('runs a program', async () => {
  await open('#lang=en&size=64x48&exhibit=own');
  await thePage().waitForSelector('.cm-content');
  await tabTo('.cm-content');
  await changes('code', () => keys('Slash', 'Slash'));
  await tabTo('.stack button');
  await changes('pixel', () => keys('Enter'));
});

it('moves a corner and the pixels of both pictures', async () => {
  await open('#lang=en&size=64x48&exhibit=pixel');
  await thePage().waitForSelector('.any .stack');
  await tabTo('g.corner');
  await changes('corners', () => keys('ArrowRight'));
  await tabTo('.any .stack button');
  await keys('Enter');
  await thePage().waitForSelector('.history table');
});

it('shows a pass, a plane, the history of a pixel, and another cell', async () => {
  await open('#lang=en&size=64x48&exhibit=passes&scene=columns.toml&shadow=volume');
  await thePage().waitForSelector('.runs');
  await changes('step', () => keys('ArrowLeft'));
  await tabTo('.stack button');
  await keys('ArrowRight');
  await thePage().waitForSelector('.history table');
  await tabTo('.plane-depth');
  await keys('Space');
  await thePage().waitForSelector('.plane-depth[aria-pressed=true]');
  await tabTo('.runs button');
  await changes('step', () => keys('Enter'));
  await tabTo('.passes .row');
  await keys('Enter');
  await tabTo('.passes input');
  await keys('PageDown');
  await changes('list', () => keys('Digit1', 'Enter'));
  await tabTo('.volumes summary');
  await keys('Enter');
  await thePage().waitForSelector('.volumes .stack');
  await tabTo('.volumes .stack button');
  await thePage().keyboard.down('Alt');
  const eye = await part('eye');
  await changes('from', () => keys('ArrowLeft'));
  await thePage().keyboard.up('Alt');
  expect(await part('eye')).toBe(eye);
});

it('follows rays and turns the second view only', async () => {
  await open('#lang=en&size=64x48&exhibit=rays&scene=rings.toml');
  await thePage().waitForSelector('.path table');
  await tabTo('.passes .stack button');
  await changes('pixel', () => keys('ArrowRight'));
  await tabTo('.outside .stack button');
  await thePage().keyboard.down('Alt');
  const eye = await part('eye');
  await changes('from', () => keys('ArrowLeft'));
  await thePage().keyboard.up('Alt');
  expect(await part('eye')).toBe(eye);
  await tabTo('.inside summary');
  await keys('Enter');
  await thePage().waitForSelector('.inside [role=button]');
  await tabTo('.inside [role=button]');
  await changes('polygon', () => keys('ArrowRight'));
});

it('shoots, and turns the lit room', async () => {
  await open('#lang=en&size=64x48&exhibit=radiosity');
  await thePage().waitForSelector('.stack');
  await changes('shots', () => keys('ArrowRight'));
  await tabTo('.play');
  await changes('shots', () => keys('Enter'));
  await keys('Enter');
  await thePage().waitForSelector('.play:focus');
  await tabTo('.stack button');
  await thePage().keyboard.down('Alt');
  await changes('eye', () => keys('ArrowLeft'));
  await thePage().keyboard.up('Alt');
});

it('closes what lies over the page by Escape, and by a click elsewhere', async () => {
  await open('#lang=en');
  await thePage().waitForSelector('.stack canvas');
  for (const name of ['help', 'rare']) {
    const isOpen = (wanted: boolean) =>
      thePage().waitForFunction(
        (name, wanted) =>
          document.querySelector<HTMLDetailsElement>(`details.${name}`)!.open === wanted,
        {},
        name,
        wanted,
      );
    await thePage().click(`.${name} summary`);
    await isOpen(true);
    await keys('Escape');
    await isOpen(false);
    expect(await thePage().evaluate(() => document.activeElement?.tagName)).toBe('SUMMARY');
    await thePage().click(`.${name} summary`);
    await isOpen(true);
    await thePage().click('.sentence');
    await isOpen(false);
  }
});
