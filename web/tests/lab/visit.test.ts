// A visit as a lecturer makes one: own files, Back, a window that becomes narrower.
import { expect, it } from 'vitest';
import { enter, inChromium, open, thePage } from './page';

inChromium();
/** By name; texts, or bytes in base 64. */
const drop = (files: Record<string, string | { base64: string }>) =>
  thePage().evaluate((files) => {
    const data = new DataTransfer();
    for (const [name, content] of Object.entries(files)) {
      const part =
        typeof content === 'string'
          ? content
          : Uint8Array.from(atob(content.base64), (c) => c.charCodeAt(0));
      data.items.add(new File([part], name));
    }
    window.dispatchEvent(new DragEvent('drop', { dataTransfer: data }));
  }, files);
const alerts = () => thePage().$$eval('[role=alert]', (all) => all.map((e) => e.textContent));
const exhibit = () => thePage().$eval('.exhibit[aria-current]', (e) => e.textContent);

const ball = '[[object]]\nshape = "sphere"\nmaterial = "skin"\n[material.skin]\n';

it.each([
  [
    'a texture',
    { 'm.toml': ball + 'map_Kd = "gone.png"\n' },
    'own/m.toml:5: own/gone.png is not here',
  ],
  ['a picture', { 'm.toml': ball + 'map_Kd = "bad.png"\n', 'bad.png': '?' }, 'own/bad.png: '],
  ['a key', { 'm.toml': ball + 'colour = 1\n' }, "own/m.toml:5: unknown key 'colour'"],
  ['a number', { 'm.toml': ball + 'Ks = nan\n' }, 'own/m.toml:5: '],
  ['a model', { 'm.obj': 'v 0 0 0\nf 1 2 3\n' }, 'own/m.obj:2: v index 2 is out of range'],
  ['all files', { 'm.png': '?' }, 'No scene among these files'],
])('says in one line what is wrong with %s, and goes on', async (_, files, why) => {
  await open('#lang=en&exhibit=passes&size=64x48&scene=rings.toml');
  await thePage().waitForSelector('figure.many canvas');
  await drop(files);
  await thePage().waitForSelector('[role=alert]');
  const said = await alerts();
  expect(said).toHaveLength(1);
  expect(said[0]).toContain(why);
  expect(said[0]).not.toContain('\n');
  await drop({ 'GOOD.OBJ': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' });
  await thePage().waitForFunction(
    () => document.querySelector<HTMLSelectElement>('select.scene')?.value === 'own/GOOD.OBJ',
  );
  await thePage().waitForFunction(() => !document.querySelector('[role=alert]'));
  await thePage().waitForSelector('figure.plane:not(.old) canvas');
});

// A PNG of 2 x 1 texels, white: alpha 255 and 51.
const leaf =
  'iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADElEQVR4nGP4DwHGACMZBy2/ARpLAAAAAElFTkSuQmCC';
const square = 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n';

it.each(['passes', 'hidden', 'rays'])('%s says what finishing a scene warns of', async (name) => {
  await open(`#lang=en&exhibit=${name}&size=64x48`);
  await thePage().waitForSelector('canvas');
  await drop({
    'leaf.mtl': 'newmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\n',
    'leaf.obj':
      `mtllib leaf.mtl\nusemtl leaf\n${square}vt 0 0\nvt 1 0\nvt 1 1\n` +
      'f 1/1 2/2 3/3\no bare\nf 1 3 4\n',
    'leaf.png': { base64: leaf },
  });
  const why =
    "own/leaf.mtl:3: object 'bare' has no texture coordinates; expected some for its map of " +
    'opacity, which is not used';
  await thePage().waitForFunction(
    (why) => [...document.querySelectorAll('p.warning')].some((e) => e.textContent === why),
    {},
    why,
  );
  expect(await alerts()).toEqual([]);
});

it('goes back to the exhibit and the scene before', async () => {
  await open('#lang=en&exhibit=hidden&size=64x48&scene=hidden/five.toml');
  await thePage().waitForSelector('.stack');
  await enter('Passes');
  await thePage().waitForSelector('figure.many canvas');
  await thePage().select('select.scene', 'rings.toml');
  await thePage().waitForFunction(() => location.hash.includes('rings.toml'));
  await thePage().goBack();
  await thePage().waitForFunction(() => location.hash.includes('five.toml'));
  expect(await exhibit()).toBe('Passes');
  await thePage().goBack();
  await thePage().waitForFunction(() => location.hash.includes('exhibit=hidden'));
  await thePage().waitForSelector('.bar .play');
  expect(await exhibit()).toBe('Hidden surfaces');
});

it.each(['hidden', 'own', 'pixel', 'passes', 'rays', 'radiosity'])(
  '%s fits a window that becomes narrower',
  async (name) => {
    await open(`#lang=en&projector=1&exhibit=${name}&size=64x48`, 1920, 1080);
    await thePage().waitForSelector('canvas');
    for (const width of [1024, 768, 390]) {
      await thePage().setViewport({ width, height: 800 });
      await thePage().waitForFunction(() => document.documentElement.scrollWidth <= innerWidth);
    }
  },
);
