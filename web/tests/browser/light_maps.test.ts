// Light maps of gw radiosity in another program: three.js draws their glTF in Chromium, as gw draws
// the solution from the same eye.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'esbuild';
import { decode } from 'fast-png';
import puppeteer, { type Browser } from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

const gw = process.env['GW'] ?? '';
const scenes = process.env['GW_SCENES'] ?? '';
const side = 256;

/** Draws a glTF in the size of its aspect. Nothing of three.js is set but the size; and, if
 * wanted, the textures that surfaces have, as docs/radiosity.md says. */
const program = `
  import { SRGBColorSpace, WebGLRenderer } from 'three';
  import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
  const texture = async (parser, material) => {
    const own = await parser.getDependency('texture', material.userData.own.index);
    own.colorSpace = SRGBColorSpace;
    material.color.setRGB(...material.userData.own.mean.map((m) => (m ? 1 / m : 0)));
    [material.lightMap, material.lightMapIntensity, material.map] = [material.map, Math.PI, own];
  };
  window.draw = async (text, side, textured) => {
    const { scene, cameras, parser } = await new GLTFLoader().parseAsync(text, '');
    const materials = new Set();
    scene.traverse((node) => node.material?.userData.own && materials.add(node.material));
    if (textured) for (const material of materials) await texture(parser, material);
    const renderer = new WebGLRenderer({ preserveDrawingBuffer: true });
    renderer.setSize(side, side);
    renderer.render(scene, cameras[0]);
    const gl = renderer.getContext();
    const pixels = new Uint8Array(4 * side * side);
    gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return [...pixels];
  };`;

interface Gltf {
  buffers: { uri: string }[];
  images: { uri: string }[];
}

/** The glTF with its files in it: a page from disk may fetch none. */
function embedded(folder: string): string {
  const data = (file: string, type: string) =>
    `data:${type};base64,${readFileSync(join(folder, file)).toString('base64')}`;
  const gltf = JSON.parse(readFileSync(join(folder, 'light_maps.gltf'), 'utf8')) as Gltf;
  for (const buffer of gltf.buffers) buffer.uri = data(buffer.uri, 'application/octet-stream');
  for (const image of gltf.images) image.uri = data(image.uri, 'image/png');
  return JSON.stringify(gltf);
}

/** A frame buffer's value, 0 to 1, as a display of 8 bits takes it. */
const encoded = (v: number) =>
  255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * Math.pow(v, 1 / 2.4) - 0.055);

const decoded = (v: number) =>
  v / 255 <= 0.04045 ? v / 255 / 12.92 : Math.pow((v / 255 + 0.055) / 1.055, 2.4);

/** Differences by channel of the pictures of gw, top row first, and three.js, bottom row first. */
function differences(folder: string, drawn: number[]): number[] {
  const picture = decode(readFileSync(join(folder, 'picture.png')));
  const most = 2 ** picture.depth - 1;
  const all: number[] = [];
  for (let y = 0; y < side; ++y)
    for (let x = 0; x < side; ++x)
      for (let c = 0; c < 3; ++c) {
        const ours = encoded(picture.data[(y * side + x) * picture.channels + c]! / most);
        all.push(Math.abs(ours - drawn[((side - 1 - y) * side + x) * 4 + c]!));
      }
  return all;
}

type Draw = (text: string, side: number, textured: boolean) => Promise<number[]>;

/** The pixels of three.js for the light maps of a folder, bottom row first. */
async function drawing(browser: Browser, folder: string, textured = false): Promise<number[]> {
  const page = await browser.newPage();
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  const bundle = await build({
    stdin: { contents: program, resolveDir: process.cwd() },
    bundle: true,
    format: 'iife',
    write: false,
    logLevel: 'error',
  });
  await page.addScriptTag({ content: bundle.outputFiles[0]!.text });
  const drawn = await page.evaluate(
    (text, size, own) => (window as unknown as { draw: Draw }).draw(text, size, own),
    embedded(folder),
    side,
    textured,
  );
  await page.close();
  expect(complaints).toEqual([]);
  return drawn;
}

describe('three.js', () => {
  const folder = mkdtempSync(join(tmpdir(), 'gw-light-maps-'));
  let browser: Browser;
  beforeAll(async () => {
    browser = await puppeteer.launch({
      executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
      args: [
        '--no-sandbox',
        '--use-gl=angle',
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
      ],
    });
  });
  afterAll(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });

  // In 8 bits the map is rounded by 1/2, the picture by 1/2, and a texture's weights are of 8 bits:
  // 2 in all. Pixels on outlines may show the other figure: 2 of 1000.
  it.each(['cornell', 'sphere'])('shows the light of %s as gw does', async (name) => {
    execFileSync(gw, [
      ...['radiosity', join(scenes, `radiosity/${name}.toml`), '-o', folder, '--shots', '40'],
      ...['--hemicube', '64', '--size', `${side}x${side}`, '--lightmaps'],
      '--quiet',
    ]);
    const drawn = await drawing(browser, folder);
    const off = differences(folder, drawn);
    const mean = off.reduce((sum, v) => sum + v, 0) / off.length;
    const farther = off.filter((v) => v > 2).length / off.length;
    const lit = drawn.filter((v, i) => i % 4 < 3 && v > 20).length / off.length;
    expect(lit).toBeGreaterThan(0.5);
    expect(mean).toBeLessThan(0.5);
    expect(farther).toBeLessThan(0.002);
  });

  // A floor of four colours fills the picture; the lamp above it turns its back.
  it('shows the textures that surfaces have, as light times texel by mean', async () => {
    const colors = [
      [255, 51, 0],
      [51, 255, 102],
      [0, 0, 255],
      [153, 153, 153],
    ];
    const rows = [0, 1, 2, 3, 4, 5, 6, 7].map((y) =>
      [0, 1, 2, 3, 4, 5, 6, 7].map((x) => colors[(y >> 2) * 2 + (x >> 2)]!.join(' ')).join(' '),
    );
    writeFileSync(join(folder, 'four.ppm'), `P3 8 8 255 ${rows.join(' ')}\n`);
    writeFileSync(
      join(folder, 'floor.toml'),
      `texels = 8
[camera]
eye = [0, 4, 0]
at = [0, 0, 0]
up = [0, 0, -1]
ortho = 2
[[object]]
shape = "rectangle"
width = 2
depth = 2
material = { Kd = 0.8, map_Kd = "four.ppm" }
[[object]]
shape = "rectangle"
width = 1
depth = 1
rotate = [180, 0, 0]
translate = [0, 1.5, 0]
material = { Kd = 0 }
pixmap = { size = [2, 2], emission = 2 }
`,
    );
    execFileSync(gw, [
      ...['radiosity', join(folder, 'floor.toml'), '-o', folder, '--hemicube', '64'],
      ...['--size', `${side}x${side}`, '--lightmaps', '--quiet'],
    ]);
    const plain = await drawing(browser, folder);
    const textured = await drawing(browser, folder, true);
    const mean = [0, 1, 2].map((c) => colors.reduce((sum, color) => sum + color[c]!, 0) / 4);
    let lit = 0;
    for (let y = 24; y < side - 16; y += 16)
      for (let x = 24; x < side - 16; x += 16) {
        if (Math.abs(x - 128) < 32 || Math.abs(y - 128) < 32) continue; // between texels
        const color = colors[(y < 128 ? 2 : 0) + (x < 128 ? 0 : 1)]!;
        for (let c = 0; c < 3; ++c) {
          const at = (y * side + x) * 4 + c;
          const light = decoded(plain[at]!);
          lit += light > 0.05 ? 1 : 0;
          const expected = encoded(Math.min(1, (light * color[c]!) / mean[c]!));
          expect(Math.abs(expected - textured[at]!)).toBeLessThan(4);
        }
      }
    expect(lit).toBeGreaterThan(100);
  });
});
