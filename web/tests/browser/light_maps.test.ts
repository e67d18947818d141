// Light maps of gw radiosity in another program: three.js draws their glTF in Chromium, as gw draws
// the solution from the same eye.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'esbuild';
import { decode } from 'fast-png';
import puppeteer, { type Browser } from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

const gw = process.env['GW'] ?? '';
const scenes = process.env['GW_SCENES'] ?? '';
const side = 256;

/** Draws a glTF in the size of its aspect. Nothing of three.js is set but the size. */
const program = `
  import { PerspectiveCamera, WebGLRenderer } from 'three';
  import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
  window.draw = async (text, side) => {
    const { scene, cameras } = await new GLTFLoader().parseAsync(text, '');
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
      (text, size) =>
        (window as unknown as { draw(text: string, side: number): Promise<number[]> }).draw(
          text,
          size,
        ),
      embedded(folder),
      side,
    );
    await page.close();
    expect(complaints).toEqual([]);
    const off = differences(folder, drawn);
    const mean = off.reduce((sum, v) => sum + v, 0) / off.length;
    const farther = off.filter((v) => v > 2).length / off.length;
    const lit = drawn.filter((v, i) => i % 4 < 3 && v > 20).length / off.length;
    expect(lit).toBeGreaterThan(0.5);
    expect(mean).toBeLessThan(0.5);
    expect(farther).toBeLessThan(0.002);
  });
});
