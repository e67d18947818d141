// The same bits: what the machine leaves in Chromium and what this computer's gw leaves, compared
// pass by pass and step by step. Needs GW, the command.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { decode } from 'fast-png';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { inChromium, open, thePage, type LabWindow } from './page';

const gw = process.env['GW'] ?? '../build/release/bin/gw';
const scenes = process.env['GW_SCENES'] ?? '../scenes';
const folder = mkdtempSync(join(tmpdir(), 'gw-lab-'));
afterAll(() => rmSync(folder, { recursive: true }));
inChromium(true);
beforeAll(async () => {
  await open('#lang=en&size=64x48');
  await thePage().waitForSelector('canvas');
});

interface Manifest {
  commands_hash: string;
  passes: Record<string, unknown>[];
}
/** Without what only the command knows: the paper's parameter sets. */
const compared = (text: string) => {
  const { commands_hash, passes } = JSON.parse(text) as Manifest;
  return { commands_hash, passes: passes.map((pass) => ({ ...pass, set: '' })) };
};

type Picture = [scene: string, renderer: string, profile: string, width: number, height: number];
const pictures: Picture[] = [
  ...['hardware', 'multipass', 'scanline', 'raytrace', 'adaptive'].flatMap((renderer): Picture[] =>
    ['vgx', 'reality', 'ideal'].map((profile) => ['rings', renderer, profile, 96, 72]),
  ),
  ...['hardware', 'multipass', 'raytrace'].map((renderer): Picture => [
    'fig9',
    renderer,
    'vgx',
    80,
    60,
  ]),
  ...[
    'teapot',
    'lamps',
    'marble',
    'fog',
    'panes',
    'selective',
    'crystal',
    'water',
    'needles',
    'columns',
    'edges',
    'coarse_rings',
    'rings_plain',
    'soft',
    'motion',
    'focus',
    'glare',
    'facing_mirrors',
    'styles',
    'cornell',
  ].map((scene): Picture => [scene, 'multipass', 'vgx', 80, 60]),
  ...(['reality', 'ideal'] as const).flatMap((profile): Picture[] =>
    ['teapot', 'fog', 'columns'].map((scene) => [scene, 'multipass', profile, 80, 60]),
  ),
];
const surfaces = [
  'back-face',
  'painter-farthest',
  'painter-nearest',
  'painter-centroid',
  'newell',
  'bsp',
  'scan-line',
  'z-buffer',
  'ray-casting',
  'schumacker',
  'warnock',
  'bouknight',
  'watkins',
  'weiler-atherton',
  'a-buffer',
  'hierarchical-z',
  'quake',
];
const runs = [
  ...surfaces.map((algorithm) => ['hidden/cycle', algorithm, 'vgx'] as const),
  ...['newell', 'bsp', 'warnock', 'watkins'].map(
    (algorithm) => ['hidden/pierce', algorithm, 'ideal'] as const,
  ),
  ...['roberts', 'appel', 'floating-horizon'].map(
    (algorithm) => ['hidden/hills', algorithm, 'vgx'] as const,
  ),
];

describe('the lab leaves the bits of gw render', () => {
  it.each(pictures)('%s %s %s', async (scene, renderer, profile, width, height) => {
    const file = join(folder, 'manifest.json');
    const size = `${width}x${height}`;
    execFileSync(gw, [
      ...['render', `${scenes}/${scene}.toml`, '-o', join(folder, 'picture.png'), '--quiet'],
      ...['--renderer', renderer, '--profile', profile, '--size', size, '--manifest', file],
    ]);
    const ours = await thePage().evaluate(
      async (path, options) => {
        const { machine } = window as unknown as LabWindow;
        await machine.ask('open', path);
        return (await machine.ask('manifest', options)).text;
      },
      `/scenes/${scene}.toml`,
      { renderer, profile, width, height },
    );
    const theirs = compared(readFileSync(file, 'utf8'));
    expect(theirs.passes.length).toBeGreaterThan(0);
    expect(compared(ours)).toEqual(theirs);
  });
});

it.each(['fast', 'reference'])('%s reproduces every row of the table of digests', async (name) => {
  const program = process.env['GW_EXACTNESS'] ?? '../build/lab/engine/exactness.js';
  const table = process.env['GW_TABLE'] ?? '../tests/exactness/digests.txt';
  const expected = readFileSync(table, 'utf8').trim().split('\n');
  await thePage().addScriptTag({ path: program });
  const lines = await thePage().evaluate(async (machine) => {
    type Make = (settings: {
      arguments: string[];
      print: (line: string) => void;
    }) => Promise<unknown>;
    const { make_exactness } = window as unknown as { make_exactness: Make };
    const lines: string[] = [];
    await make_exactness({ arguments: ['--machine', machine], print: (line) => lines.push(line) });
    return lines;
  }, name);
  expect(expected.length).toBeGreaterThan(190);
  expect(lines).toEqual(expected);
});

it.each(['fig9', 'rings', 'fog'])('%s has the same bits from eye to eye', async (scene) => {
  // draw() keeps what no eye changes; passes() begins anew.
  const same = await thePage().evaluate(async (path) => {
    const { machine } = window as unknown as LabWindow;
    const { eye, at, up } = await machine.ask('open', path);
    const all: boolean[] = [];
    for (const by of [0, 0.3, 0.6]) {
      const view = { eye: [eye[0] + by, eye[1] + by, eye[2]], at: [...at], up: [...up] };
      const options = { renderer: 'multipass', profile: 'vgx', width: 80, height: 60, ...view };
      const { picture } = await machine.ask('draw', options);
      const anew = await machine.ask('passes', options);
      await machine.ask('draw', options); // passes() made another machine
      all.push(picture.length > 0 && picture.every((v, i) => v === anew.picture[i]));
    }
    return all;
  }, `/scenes/${scene}.toml`);
  expect(same).toEqual([true, true, true]);
});

/** A line without the count that depends on the size of a pointer. */
const portable = (line: string) => line.replace(/"peak_bytes":\d+,?/g, '');
const linesOf = (log: string): string[] => log.split('\n').map(portable);

describe('the lab makes the step log of gw hidden', () => {
  it.each(runs)('%s %s %s', async (scene, algorithm, profile) => {
    execFileSync(gw, [
      ...['hidden', `${scenes}/${scene}.toml`, '--algorithm', algorithm, '--profile', profile],
      ...['--size', '64x48', '--steps', join(folder, 'steps'), '--quiet'],
    ]);
    const { text } = await thePage().evaluate(
      async (path, options) => {
        const { machine } = window as unknown as LabWindow;
        await machine.ask('open', path);
        return machine.ask('hidden', options);
      },
      `/scenes/${scene}.toml`,
      { algorithm, profile, level: 'polygon', width: 64, height: 48 },
    );
    const theirs = readFileSync(join(folder, 'steps', 'steps.jsonl'), 'utf8');
    const expected = linesOf(theirs);
    expect(expected.length).toBeGreaterThan(3);
    const ours = linesOf(text);
    expect(ours.length).toBe(expected.length);
    for (const [i, line] of ours.entries()) expect(line).toBe(expected[i]);
  });
});

describe('the lab leaves the light of gw radiosity', () => {
  const change = (object: string, what: 'Kd' | 'move', value: number[]) => ({
    after: 2,
    object,
    what,
    value,
  });
  it.each([
    ['cornell', 32, 3, 0, []],
    ['cornell', 64, 2, 0, [change('left_wall', 'Kd', [0.1, 0.2, 0.9])]],
    ['cornell', 32, 2, 3, [change('short_block', 'move', [-0.2, 0, 0])]],
    ['sphere', 32, 4, 0, []],
  ] as const)('%s, hemicube %i, %i shots, then %i more, changes %j', async (...row) => {
    const [scene, hemicube, shots, more, changes] = row;
    const words = changes.flatMap((c) => [
      '--change',
      `${c.object}:${c.what}=${c.value.join(',')}`,
    ]);
    execFileSync(gw, [
      ...['radiosity', `${scenes}/radiosity/${scene}.toml`, '-o', join(folder, 'light')],
      ...['--hemicube', String(hemicube), '--shots', String(shots), '--size', '64x48'],
      // After the change, shots until as little is unshot as before it, or none.
      ...['--until', more > 0 ? '0.01' : '1', '--gamma', '2.2', '--quiet', ...words],
    ]);
    const ours = await thePage().evaluate(
      async (path, light) => {
        const { machine } = window as unknown as LabWindow;
        await machine.ask('open', path);
        while ((await machine.ask('light', light)).more);
        const tone = { exposure: 0, gamma: 2.2, ambient: true };
        const view = { width: 64, height: 48, profile: 'ideal' };
        return [...(await machine.ask('lit', { ...view, ...tone })).picture];
      },
      `/scenes/radiosity/${scene}.toml`,
      { width: 64, height: 48, hemicube, shots: shots + more, changes: [...changes] },
    );
    const name = changes.length > 0 ? 'changed.png' : 'picture.png';
    // The command keeps the 16 bits of `ideal`; a screen has 8.
    const { data, depth } = decode(readFileSync(join(folder, 'light', name)));
    expect(depth).toBe(16);
    const theirs = [...data].map((value) => Math.round(value / 257));
    expect(new Set(theirs).size).toBeGreaterThan(20);
    expect(ours.filter((_, i) => i % 4 !== 3)).toEqual(theirs);
  });
});
