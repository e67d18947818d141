// Measures the built lab in Chromium: frames of a turning eye beside the same frames through the
// browser's WebGL on SwiftShader, in turns in one page; and the time to the first picture from
// disk. GW_LAB: the page; GW_FRAMES: the folder of bench_lab_frames' files. scripts/lab --bench
// calls it.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import puppeteer, { type Browser } from 'puppeteer-core';
import type { Machine } from '../lab/machine/machine';
import { workerTime } from './processor_time';
import type { Frame, WebGlPlayer } from './webgl';

const lab = process.env['GW_LAB'] ?? '../build/lab/index.html';
const frames = process.env['GW_FRAMES'] ?? '../build/lab/frames';
const pictures = 12;

interface BenchWindow {
  machine: Machine;
  peer: { WebGlPlayer: typeof WebGlPlayer };
  workerTime(): Promise<number>;
}
interface Workload {
  name: string;
  scene: string;
  frame: string;
  renderer: string;
  reflections: string;
}
const workloads: Workload[] = [
  {
    name: 'teapot.toml 640x480, hardware',
    scene: 'teapot',
    frame: 'teapot.json',
    renderer: 'hardware',
    reflections: 'rays',
  },
  {
    name: 'fig9.toml 320x240, multipass without rays',
    scene: 'fig9',
    frame: 'fig9.json',
    renderer: 'multipass',
    reflections: 'maps',
  },
  {
    name: 'fig9.toml 320x240, multipass with rays (WebGL: without)',
    scene: 'fig9',
    frame: 'fig9.json',
    renderer: 'multipass',
    reflections: 'rays',
  },
];

const launch = (...args: string[]): Promise<Browser> =>
  puppeteer.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', ...args],
    protocolTimeout: 600_000,
  });
const swiftShader = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const median = (values: number[]): number => values.sort((a, b) => a - b)[values.length >> 1]!;

/** In the page. Each picture from another eye, first ours, then WebGL's. */
async function inTurns(
  frame: Frame,
  { scene, renderer, reflections }: Workload,
  count: number,
): Promise<{
  ours: number[];
  peer: number[];
  difference: number;
  by: string;
  seen: string;
}> {
  const { machine, peer } = window as unknown as BenchWindow;
  const facts = await machine.ask('open', `/scenes/${scene}.toml`);
  const player = new peer.WebGlPlayer(frame);
  const { width, height } = frame;
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d')!;
  const eyeAt = (angle: number): [number, number, number] => {
    const x = facts.eye[0]! - facts.at[0]!;
    const z = facts.eye[2]! - facts.at[2]!;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return [facts.at[0]! + c * x + s * z, facts.eye[1]!, facts.at[2]! - s * x + c * z];
  };
  /** The eye of the first frame to that of this angle: V T(at) R^-1 T(-at) V^-1. */
  const turnOf = (angle: number): number[] => {
    const v = new DOMMatrix([...frame.eye_from_world]);
    const about = new DOMMatrix()
      .translate(...frame.at)
      .rotateAxisAngle(0, 1, 0, (-angle * 180) / Math.PI)
      .translate(-frame.at[0], -frame.at[1], -frame.at[2]);
    return [...v.multiply(about).multiply(v.inverse()).toFloat64Array()];
  };
  const ours: number[] = [];
  const theirs: number[] = [];
  let difference = 0;
  const beside = Object.assign(document.createElement('canvas'), { width: width * 2, height });
  for (let i = 0; i < count + 2; ++i) {
    const angle = 0.03 * i;
    const begun = performance.now();
    const { picture } = await machine.ask('draw', {
      width,
      height,
      profile: 'vgx',
      renderer,
      reflections,
      eye: eyeAt(angle),
      at: [...facts.at],
      up: [...facts.up],
    });
    context.putImageData(new ImageData(new Uint8ClampedArray(picture), width, height), 0, 0);
    const between = performance.now();
    player.draw(turnOf(angle));
    const read = player.read();
    const end = performance.now();
    if (i < 2) continue; // both make what no eye changes
    ours.push(between - begun);
    theirs.push(end - between);
    let sum = 0;
    for (let y = 0; y < height; ++y)
      for (let k = 0; k < width * 4; ++k)
        if (k % 4 < 3)
          sum += Math.abs(picture[y * width * 4 + k]! - read[(height - 1 - y) * width * 4 + k]!);
    difference += sum / (width * height * 3) / count;
    const both = beside.getContext('2d')!;
    both.drawImage(canvas, 0, 0);
    both.drawImage(player.canvas, width, 0);
  }
  const seen = beside.toDataURL().split(',')[1]!;
  return { ours, peer: theirs, difference, by: player.renderer, seen };
}

/**
 * In the page. Pictures a second from two engines, as the exhibit of passes turns the eye, and the
 * processor's milliseconds for one.
 */
async function byTwo(
  { scene, renderer, reflections }: Workload,
  width: number,
  height: number,
  count: number,
): Promise<{ rate: number; processor: number }> {
  const { machine, workerTime: time } = window as unknown as BenchWindow;
  const { eye, at, up } = await machine.ask('open', `/scenes/${scene}.toml`);
  const twin = machine.twin();
  const size = { width, height, profile: 'vgx', renderer, reflections };
  const draw = (by: Machine, i: number) =>
    by.ask('draw', { ...size, eye: [eye[0] + 0.02 * i, eye[1], eye[2]], at: [...at], up: [...up] });
  for (const i of [0, 1]) await Promise.all([draw(machine, i), draw(twin, i)]);
  let next = 2;
  const turn = async (by: Machine): Promise<void> => {
    while (next < count + 2) await draw(by, next++);
  };
  const before = await time();
  const begun = performance.now();
  await Promise.all([turn(machine), turn(twin)]);
  const seconds = (performance.now() - begun) / 1000;
  const processor = ((await time()) - before) / count;
  twin.end();
  return { rate: count / seconds, processor };
}

async function measureFrames(browser: Browser): Promise<void> {
  const page = await browser.newPage();
  await page.exposeFunction('workerTime', () => workerTime(browser.process()!.pid!));
  const bundle = await build({
    entryPoints: [fileURLToPath(new URL('webgl.ts', import.meta.url))],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'peer',
  });
  await page.goto(`file://${lab}#lang=en&size=64x48`);
  await page.waitForSelector('canvas');
  await page.addScriptTag({ content: bundle.outputFiles[0]!.text });
  for (const workload of workloads) {
    const frame = JSON.parse(readFileSync(join(frames, workload.frame), 'utf8')) as Frame;
    const run = await page.evaluate(inTurns, frame, workload, pictures);
    const two = await page.evaluate(byTwo, workload, frame.width, frame.height, 2 * pictures);
    const [ours, peer] = [median(run.ours), median(run.peer)];
    const png = `${workload.scene}_${workload.reflections}.png`;
    writeFileSync(join(frames, png), Buffer.from(run.seen, 'base64'));
    console.log(
      `${workload.name}: lab ${ours.toFixed(0)} ms (${(1000 / ours).toFixed(1)} pictures a second, ` +
        `fastest ${run.ours[0]!.toFixed(0)} ms; two engines ${two.rate.toFixed(1)} a second, ${two.processor.toFixed(0)} ms of the processor each), WebGL ${peer.toFixed(1)} ms, ` +
        `lab / WebGL ${(ours / peer).toFixed(1)}; mean difference ${run.difference.toFixed(2)} of 255; ${run.by}`,
    );
  }
}

/**
 * From navigation to the first pixels on a canvas, with a new profile each time. Without
 * SwiftShader, whose start alone takes seconds.
 */
async function firstPicture(hash: string): Promise<number> {
  const browser = await launch();
  const page = await browser.newPage();
  await page.evaluateOnNewDocument(() => {
    const prototype = CanvasRenderingContext2D.prototype;
    const put = prototype.putImageData;
    prototype.putImageData = function (this: CanvasRenderingContext2D, ...values: unknown[]) {
      put.apply(this, values as Parameters<typeof put>);
      (window as { first?: number }).first ??= performance.now();
    };
  });
  await page.goto(`file://${lab}${hash}`);
  await page.waitForFunction(() => (window as { first?: number }).first !== undefined);
  const first = await page.evaluate(() => (window as unknown as { first: number }).first);
  await browser.close();
  return first;
}

/**
 * Pictures of eq. 2 a second that a visitor sees while the mouse turns the exhibit of passes: of
 * other bytes than the one before. The second machine has begun before the time is taken.
 */
async function turnedByMouse(scene: string): Promise<number> {
  const browser = await launch();
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 720 });
  await page.evaluateOnNewDocument(() => {
    const prototype = CanvasRenderingContext2D.prototype;
    const put = prototype.putImageData;
    let last: Uint32Array | undefined;
    prototype.putImageData = function (this: CanvasRenderingContext2D, ...values: unknown[]) {
      put.apply(this, values as Parameters<typeof put>);
      if (!this.canvas.closest('figure.many')) return;
      const now = new Uint32Array((values[0] as ImageData).data.buffer);
      const counted = window as { shown?: number };
      if (last?.some((pixel, i) => pixel !== now[i])) counted.shown = (counted.shown ?? 0) + 1;
      last = now;
    };
  });
  const shown = () => page.evaluate(() => (window as { shown?: number }).shown ?? 0);
  await page.goto(`file://${lab}#lang=en&exhibit=passes&size=320x240&scene=${scene}`);
  await page.waitForSelector('figure.plane:not(.old) canvas');
  const box = (await (await page.$('figure.many .stack'))!.boundingBox())!;
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  const turnFor = async (seconds: number): Promise<void> => {
    const begun = performance.now();
    const since = () => (performance.now() - begun) / 1000;
    while (since() < seconds) {
      await page.mouse.move(
        middle.x + 40 * Math.sin(2 * since()),
        middle.y + 8 * Math.sin(since()),
      );
      await new Promise((done) => setTimeout(done, 16));
    }
  };
  await turnFor(3);
  const before = await shown();
  const begun = performance.now();
  await turnFor(6);
  const rate = ((await shown()) - before) / ((performance.now() - begun) / 1000);
  await browser.close();
  return rate;
}

const browser = await launch(...swiftShader);
await measureFrames(browser);
await browser.close();
for (const scene of ['teapot', 'fig9']) {
  const rate = await turnedByMouse(`${scene}.toml`);
  console.log(
    `passes turned by the mouse, ${scene}.toml 320x240: ${rate.toFixed(1)} pictures a second`,
  );
}
for (const exhibit of ['hidden', 'pixel', 'passes', 'rays', 'radiosity']) {
  const times: number[] = [];
  for (let i = 0; i < 5; ++i) times.push(await firstPicture(`#lang=en&exhibit=${exhibit}`));
  console.log(`first picture, ${exhibit}: median ${(median(times) / 1000).toFixed(2)} s of 5`);
}
