// The exhibit of hidden surfaces as a hand uses it.
import { expect, it } from 'vitest';
import { inChromium, open, thePage } from './page';

inChromium();
const output = () => thePage().$eval('output', (e) => e.textContent?.trim());
const address = () => thePage().evaluate(() => location.hash);

it('runs an algorithm and follows the keys', async () => {
  await open('#lang=en&scene=hidden/cycle.toml&algorithm=newell&size=160x120');
  await thePage().waitForSelector('output');
  const [at, all] = (await output())!.split(' of ');
  expect(at).toBe(all);
  await thePage().keyboard.press('Home');
  expect(await output()).toBe(`0 of ${all}`);
  await thePage().keyboard.press('ArrowRight');
  expect(await output()).toBe(`1 of ${all}`);
});

it.each(['en', 'ja'])('shows no codes of a lecture, in %s', async (language) => {
  await open(`#lang=${language}&exhibit=hidden&algorithm=newell,z-buffer&size=64x48`);
  await thePage().waitForSelector('.stack');
  expect(await thePage().$$eval('option', (all) => all.length)).toBeGreaterThan(40);
  expect(await thePage().$eval('body', (e) => e.innerText)).not.toMatch(/\[L\d/);
  expect(await thePage().$eval('select.algorithm', (e) => e.textContent)).not.toMatch(/\[L\d/);
});

it('begins the machine while the page is still read', async () => {
  await thePage().evaluateOnNewDocument(() => {
    const begun: boolean[] = [];
    Object.assign(window, { allThere: begun });
    window.Worker = class extends Worker {
      constructor(address: string | URL) {
        super(address);
        begun.push(['scalar', 'editor', 'app'].some((id) => document.getElementById(id)));
      }
    };
  });
  await open('#lang=en&scene=hidden/cycle.toml&algorithm=newell&size=64x48');
  await thePage().waitForSelector('.stack');
  const workers = await thePage().evaluate(
    () => (window as unknown as { allThere: boolean[] }).allThere,
  );
  expect(workers).toEqual([false]); // one, before the rest of the page
});

it('turns the eye by a drag, and keeps it in the link', async () => {
  await open('#lang=en&scene=hidden/cycle.toml&algorithm=bsp,newell&size=160x120');
  await thePage().waitForSelector('.stack');
  expect(await thePage().$$('section.pane')).toHaveLength(2);
  expect(await address()).not.toContain('eye=');
  const box = (await (await thePage().$('.stack'))!.boundingBox())!;
  await thePage().mouse.move(box.x + 40, box.y + 40);
  await thePage().mouse.down();
  await thePage().mouse.move(box.x + 90, box.y + 60, { steps: 5 });
  await thePage().mouse.up();
  await thePage().waitForFunction(() => location.hash.includes('eye='));
  const eyeOf = (hash: string) => new URLSearchParams(hash.slice(1)).get('eye');
  const before = eyeOf(await address());
  await thePage().reload();
  await thePage().waitForSelector('.stack');
  expect(eyeOf(await address())).toBe(before);
});

it('opens a dropped model and says what is wrong with another one', async () => {
  await open('#lang=en&size=64x48&algorithm=z-buffer');
  await thePage().waitForSelector('.stack');
  const give = (name: string, text: string) =>
    thePage().evaluate(
      (name, text) => {
        const data = new DataTransfer();
        data.items.add(new File([text], name));
        window.dispatchEvent(new DragEvent('drop', { dataTransfer: data }));
      },
      name,
      text,
    );
  await give('two.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n');
  await thePage().waitForFunction(
    () => document.querySelector<HTMLSelectElement>('select.scene')?.value === 'own/two.obj',
  );
  await give('bad.obj', 'v 0 0 zero\n');
  await thePage().waitForSelector('[role=alert]');
  const why = await thePage().$eval('[role=alert]', (e) => e.textContent);
  expect(why).toContain('own/bad.obj:1');
});

it('refuses a run that would take too long, and goes on', async () => {
  await open('#lang=en&scene=hidden/solids.toml&algorithm=ray-casting&size=640x480');
  await thePage().waitForSelector('[role=alert]');
  expect(await thePage().$eval('[role=alert]', (e) => e.textContent)).toContain('would take');
  await thePage().select('select.algorithm', 'z-buffer');
  await thePage().waitForSelector('.stack');
});

it('marks the side in question of a hidden-line algorithm, its hidden parts broken', async () => {
  await open('#lang=en&scene=hidden/cycle.toml&algorithm=appel&step=3&size=160x120');
  await thePage().waitForSelector('.stack path.side');
  const paths = await thePage().$$eval('.stack svg path', (all) =>
    all.map((path) => [path.getAttribute('class') ?? '', path.getAttribute('d') ?? '']),
  );
  const parts = (name: string) =>
    paths.find(([found]) => found === name)![1]!.split('M').length - 1;
  expect(await thePage().$eval('.sentence', (e) => e.textContent)).toContain('0, 1, 0');
  expect([parts('side'), parts('side-hidden')]).toEqual([2, 1]);
  // No polygon's outline lies over it.
  expect(paths.slice(-1)[0]![0]).toBe('side');
});

it("names a tree's nodes and sides as the sentences do", async () => {
  const tree = '#lang=en&scene=hidden/cycle.toml&algorithm=bsp&view=tree&size=160x120&step=';
  const texts = () =>
    thePage().$$eval('.second svg[role=img] text', (all) => all.map((text) => text.textContent));
  await open(`${tree}4`);
  await thePage().waitForSelector('.second text');
  const sentence = await thePage().$eval('.sentence', (e) => e.textContent);
  expect(sentence).toContain('Node 1 is in front of node 0, the plane of 2a.');
  expect(await texts()).toEqual(['front', '0: 1', '1: 2a']);
  await open(`${tree.replace('en', 'ja')}4`);
  await thePage().waitForFunction(
    () => document.querySelector('.second text')?.textContent === '表',
  );
  await open(`${tree}1`);
  await thePage().waitForFunction(() =>
    document.querySelector('.second')?.textContent?.includes('No node'),
  );
});

it('shows a made node of a large tree beside another algorithm', async () => {
  await open('#lang=en&scene=hidden/solids.toml&algorithm=bsp,z-buffer&step=200&size=64x48');
  await thePage().waitForSelector('.second svg rect');
});

it.each([
  ['en', 'story=first', 'Hidden surfaces'],
  ['en', 'exhibit=hidden', 'Hidden surfaces'],
  ['ja', 'story=first', '隠面消去'],
  ['ja', 'exhibit=hidden', '隠面消去'],
])('fits a phone, in %s, with %s', async (language, address, title) => {
  await open(`#lang=${language}&${address}&size=160x120`, 390, 844);
  await thePage().waitForSelector('.stack');
  const [content, screen] = await thePage().evaluate(() => [
    document.documentElement.scrollWidth,
    window.innerWidth,
  ]);
  expect(content).toBeLessThanOrEqual(screen!);
  expect(await thePage().$eval('.exhibit', (e) => e.textContent)).toBe(title);
});

it.each(['en', 'ja'])('has a line and a group for every scene, in %s', async (language) => {
  await open(`#lang=${language}&exhibit=hidden&size=64x48`);
  await thePage().waitForSelector('.stack');
  const scenes = await thePage().$$eval('select.scene option', (all) =>
    all.map((e) => ({ line: e.textContent!, name: (e as HTMLOptionElement).value })),
  );
  expect(scenes.length).toBeGreaterThan(50);
  expect(scenes.filter(({ line, name }) => line === name && !name.startsWith('own/'))).toEqual([]);
});

it('says that no pixel differs instead of showing it', async () => {
  const difference = () => thePage().$eval('details[open] > div > p', (e) => e.textContent);
  await open('#lang=en&exhibit=hidden&scene=hidden/cycle.toml&algorithm=newell&size=64x48');
  await thePage().waitForSelector('.stack');
  expect(await difference()).toBe('No pixel differs.');
  await open(
    '#lang=en&exhibit=hidden&scene=hidden/centroid_fails.toml&algorithm=painter-farthest&size=64x48',
  );
  await thePage().waitForSelector('details[open] > div > canvas');
});

it('has words beside the signs of the controls if there is room', async () => {
  const words = () =>
    thePage().$eval('.bar', (e) => (e as HTMLElement).innerText.replace(/\s+/g, ' '));
  await open('#lang=en&exhibit=hidden&size=64x48', 1920, 1080);
  await thePage().waitForSelector('.bar');
  expect(await words()).toMatch(/Start Decisive Back Play Next Decisive End/);
  await thePage().setViewport({ width: 1280, height: 720 });
  expect(await words()).not.toContain('Decisive');
  const names = await thePage().$$eval('.bar button', (all) =>
    all.map((e) => e.getAttribute('aria-label') ?? e.textContent),
  );
  expect(names.every((name) => name)).toBe(true);
});
