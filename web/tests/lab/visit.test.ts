// A visit as a lecturer makes one: own files, Back, a window that becomes narrower.
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
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
  ['a model in JSON', { 'm.gltf': '{"asset": 2}' }, 'own/m.gltf: '],
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

it('radiosity says what it leaves out', async () => {
  await open('#lang=en&exhibit=radiosity&size=64x48');
  await thePage().waitForSelector('canvas');
  await drop({
    'flat.mtl': 'newmtl lamp\nKe 1 1 1\n newmtl grey\nKd 0.5 0.5 0.5\n',
    'flat.obj':
      'mtllib flat.mtl\no lamp\nusemtl lamp\nv 0 2 0\nv 1 2 0\nv 1 2 1\nv 0 2 1\nf 1 2 3 4\n' +
      'o seam\nusemtl grey\nv 0 0 0\nv 1 0 0\nv 2 0 0\nf 5 6 7\n',
  });
  await thePage().waitForFunction(() =>
    [...document.querySelectorAll('p.warning')].some(
      (e) => e.textContent === "object 'seam' has no area, so radiosity leaves it out",
    ),
  );
  expect(await alerts()).toEqual([]);
});

/** A picture of one colour, as the browser writes it. */
const pictureOf = (type: string, color: string) =>
  thePage().evaluate(
    (type, color) => {
      const canvas = document.createElement('canvas');
      canvas.width = canvas.height = 8;
      const context = canvas.getContext('2d')!;
      context.fillStyle = color;
      context.fillRect(0, 0, 8, 8);
      return canvas.toDataURL(type).split(',')[1]!;
    },
    type,
    color,
  );

/** A square before the eye that shows the texture `image`, its buffer and what else is in it. */
function squareWith(image: object, buffer: object, picture: Buffer = Buffer.alloc(0)) {
  const floats = new Float32Array([
    ...[-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], // positions
    ...[0, 1, 1, 1, 1, 0, 0, 0],
  ]);
  const bytes = Buffer.concat([
    Buffer.from(floats.buffer),
    Buffer.from(new Uint16Array([0, 1, 2, 0, 2, 3]).buffer),
    picture,
  ]);
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [
      { primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, material: 0 }] },
    ],
    materials: [
      {
        extensions: { KHR_materials_unlit: {} },
        pbrMetallicRoughness: { baseColorTexture: { index: 0 } },
      },
    ],
    extensionsUsed: ['KHR_materials_unlit'],
    textures: [{ source: 0 }],
    images: [image],
    buffers: [{ byteLength: bytes.length, ...buffer }],
    bufferViews: [
      { buffer: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 32 },
      { buffer: 0, byteOffset: 80, byteLength: 12 },
      ...(picture.length > 0 ? [{ buffer: 0, byteOffset: 92, byteLength: picture.length }] : []),
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', ...box },
      { bufferView: 1, componentType: 5126, count: 4, type: 'VEC2' },
      { bufferView: 2, componentType: 5123, count: 6, type: 'SCALAR' },
    ],
  };
  return { json: JSON.stringify(json), bytes };
}
const box = { min: [-1, -1, 0], max: [1, 1, 0] };

/** glTF's binary container: a header, JSON, bytes; each of a multiple of four. */
function glb({ json, bytes }: { json: string; bytes: Buffer }): string {
  const chunk = (type: string, data: Buffer, fill: number) => {
    const padded = Buffer.concat([data, Buffer.alloc(-data.length & 3, fill)]);
    const head = Buffer.alloc(8);
    head.writeUInt32LE(padded.length, 0);
    head.write(type, 4, 'latin1');
    return Buffer.concat([head, padded]);
  };
  const chunks = [chunk('JSON', Buffer.from(json), 0x20), chunk('BIN\0', bytes, 0)];
  const head = Buffer.alloc(12);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + chunks[0]!.length + chunks[1]!.length, 8);
  return Buffer.concat([head, ...chunks]).toString('base64');
}

/** Waits for it in the middle of the picture; a JPEG's colour may be off by a step or two. */
const waitForColor = (color: readonly number[]) =>
  thePage().waitForFunction(
    (color) => {
      const canvas = document.querySelector<HTMLCanvasElement>('figure.plane:not(.old) canvas');
      const { width = 0, height = 0 } = canvas ?? {};
      const data = canvas?.getContext('2d')?.getImageData(width / 2, height / 2, 1, 1).data;
      return data && color.every((c, k) => Math.abs(c - data[k]!) <= 3);
    },
    { timeout: 20_000 },
    color,
  );
const passes = '#lang=en&exhibit=passes&size=64x48&scene=rings.toml';

it.each(['image/png', 'image/jpeg'])('opens a .glb with its %s', async (type) => {
  await open(passes);
  await thePage().waitForSelector('figure.many canvas');
  for (const color of [
    [255, 128, 0],
    [0, 128, 255], // the same name again
  ]) {
    const picture = Buffer.from(await pictureOf(type, `rgb(${color.join()})`), 'base64');
    const square = squareWith({ bufferView: 3, mimeType: type }, {}, picture);
    await drop({ 'square.glb': { base64: glb(square) } });
    await waitForColor(color);
  }
  expect(await alerts()).toEqual([]);
});

it('opens a folder with a .gltf, its buffer and its pictures', async () => {
  await open(passes);
  await thePage().waitForSelector('figure.many canvas');
  const square = squareWith({ uri: 'textures/blue%20sky.jpg' }, { uri: 'square.bin' });
  const root = mkdtempSync(join(tmpdir(), 'gw-lab-'));
  try {
    const folder = join(root, 'square');
    mkdirSync(join(folder, 'textures'), { recursive: true });
    writeFileSync(join(folder, 'square.gltf'), square.json);
    writeFileSync(join(folder, 'square.bin'), square.bytes);
    const sky = Buffer.from(await pictureOf('image/jpeg', 'rgb(40,90,200)'), 'base64');
    writeFileSync(join(folder, 'textures', 'blue sky.jpg'), sky);
    const session = await thePage().createCDPSession();
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
      await session.send('Input.dispatchDragEvent', {
        type,
        x: 400,
        y: 400,
        data: { items: [], files: [folder], dragOperationsMask: 1 },
      });
    await waitForColor([40, 90, 200]);
    expect(await alerts()).toEqual([]);
    expect(await thePage().$eval('select.scene', (e) => (e as HTMLSelectElement).value)).toBe(
      'own/square/square.gltf',
    );
  } finally {
    rmSync(root, { recursive: true });
  }
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
