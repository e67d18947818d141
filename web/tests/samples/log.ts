// A small log made by hand: two squares of 16 x 8 pixels, one behind the other, and a cut.
import type { Blame } from '../../model/steps/blame';
import type { Header, Loop, Step } from '../../model/steps/log';

const square = (x0: number, y0: number, x1: number, y1: number, z: number): Loop => [
  [x0, y0, z],
  [x1, y0, z],
  [x1, y1, z],
  [x0, y1, z],
];

export const header: Header = {
  log: 'gw hidden steps',
  version: 1,
  algorithm: 'newell',
  title: 'Newell, Newell, Sancha',
  draws: 'surfaces',
  decides: 'window',
  level: 'polygon',
  scene: 'sample',
  size: [16, 8],
  unit: 8,
  depth: 1000,
  view: { eye: [0, 0, 5], at: [0, 0, 0], up: [0, 1, 0], fov: 90, ortho_height: 0, near: 1, far: 9 },
  background: '#000000',
  words: {
    'z-extents': {
      yes: {
        en: '{first} {first_reach} is behind {second}.',
        ja: '{first} は {second} の奥です。',
      },
    },
    draw: { piece: { en: '{first}: {pixels} pixels.', ja: '{first}：{pixels} 画素。' } },
    order: { sorted: { en: '{pieces}.', ja: '{pieces}。' } },
    split: { plane: { en: '{second} cuts {first}.', ja: '{second} が {first} を切ります。' } },
  },
  polygons: [
    {
      id: 1,
      part: 'far',
      color: '#ff0000',
      world: square(-4, 2, 2, -2, 0),
      nearest: 5,
      farthest: 5,
      centroid: 5,
      outline: [square(0, 0, 80, 64, 600)],
      pieces: [{ name: '1', outline: [square(0, 0, 80, 64, 600)], plane: [0, 0, 1, -600] }],
    },
    {
      id: 2,
      part: 'near',
      color: '#0000ff',
      world: square(-2, 2, 4, -2, 2),
      nearest: 3,
      farthest: 3,
      centroid: 3,
      outline: [square(48, 0, 128, 64, 300)],
      pieces: [{ name: '2', outline: [square(48, 0, 128, 64, 300)], plane: [0, 0, 1, -300] }],
    },
  ],
};

const rows = [0, 1, 2, 3, 4, 5, 6, 7];

export const steps: Step[] = [
  {
    step: 1,
    level: 'polygon',
    kind: 'sort',
    test: 'order',
    result: 'sorted',
    pieces: ['1', '2'],
    values: { z: [600, 300], marked: [] },
    counts: { keys: 1 },
  },
  {
    step: 2,
    level: 'polygon',
    kind: 'compare',
    test: 'z-extents',
    result: 'yes',
    pieces: ['1', '2'],
    decisive: true,
    values: { first_reach: [600.5, 600.5] },
    counts: { extents: 1 },
  },
  {
    step: 3,
    level: 'polygon',
    kind: 'split',
    test: 'split',
    result: 'plane',
    pieces: ['1', '2'],
    decisive: true,
    made: [
      { name: '1a', outline: [square(0, 0, 40, 64, 600)] },
      { name: '1b', outline: [square(40, 0, 80, 64, 600)] },
    ],
  },
  {
    step: 4,
    level: 'polygon',
    kind: 'draw',
    test: 'draw',
    result: 'piece',
    pieces: ['1a'],
    values: { pixels: 80 },
    painted: rows.map((y) => [y, 0, 10, 1] as const),
    counts: { pixels: 80 },
  },
  {
    step: 5,
    level: 'polygon',
    kind: 'draw',
    test: 'draw',
    result: 'piece',
    pieces: ['2'],
    values: { pixels: 80 },
    painted: rows.map((y) => [y, 6, 16, 2] as const),
    counts: { pixels: 160 },
  },
];

export const totals = { keys: 1, extents: 1, pixels: 160 };

/** Of a picture with wrong pixels. */
export const blame: readonly Blame[] = [1, 2, 3, 4, 5, 6].map((pixels) => ({
  step: pixels % 2 ? 5 : 4,
  polygon: 2,
  over: 1,
  expected: 1,
  pixels,
  first: [pixels, 7],
}));

export function text(blame: readonly Blame[] = []): string {
  const end = { end: steps.length, counts: totals, blame };
  return `${[header, ...steps, end].map((line) => JSON.stringify(line)).join('\n')}\n`;
}
