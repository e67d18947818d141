import { describe, expect, it } from 'vitest';
import type { Loop } from '../model/steps/log';
import { whole } from '../model/steps/outline';
import { entryOf, indexOf, mapsOf } from '../model/pixel_history';
import type { Report } from '../model/report';

const a = [0, 0, 1] as const;
const b = [8, 0, 2] as const;
const c = [8, 8, 3] as const;
const d = [0, 8, 4] as const;

it('a quad of two triangles has four sides and no diagonal', () => {
  const [loop, ...rest] = whole([
    [a, b, c],
    [a, c, d],
  ]);
  expect(rest).toEqual([]);
  expect(loop).toHaveLength(4);
  for (const corner of [a, b, c, d]) expect(loop).toContain(corner);
});

it('parts that share no side stay as they are', () => {
  const hole: Loop = [
    [2, 2, 0],
    [2, 4, 0],
    [4, 2, 0],
  ];
  expect(whole([[a, b, c, d], hole])).toEqual([[a, b, c, d], hole]);
  expect(whole([[a, b, c]])).toEqual([[a, b, c]]);
  expect(whole([])).toEqual([]);
});

it('corners that differ by rounding are one', () => {
  const near = [8 + 1e-9, 8 - 1e-9, 3] as const;
  expect(
    whole([
      [a, b, c],
      [a, near, d],
    ]),
  ).toHaveLength(1);
});

it('parts that turn against each other stay parts', () => {
  const parts: Loop[] = [
    [a, b, c],
    [a, d, c],
  ];
  expect(whole(parts)).toEqual(parts);
});

const rgb = (r: number, g: number, b: number) => r | (g << 8) | (b << 16);
const report = {
  maps: [
    {
      planes: 'window',
      bits: 12,
      bits_in_r: 8,
      changes: [
        [37, rgb(200, 100, 50)],
        [258, rgb(1, 2, 3)],
      ],
    },
    { planes: 'window', bits: 12, bits_in_r: 8, changes: [[37, rgb(9, 8, 7)]] },
    { planes: 'overlay', bits: 2, bits_in_r: 8, changes: [[2, rgb(4, 5, 6)]] },
    { planes: 'window', bits: 12, bits_in_r: 8, changes: [] },
  ],
} as unknown as Report;

describe('maps of a report', () => {
  const [first, second, overlay, last] = mapsOf(report);
  it('have the index in R and G', () => {
    expect(indexOf(first!, [2, 1, 0, 255])).toBe(258);
    expect(indexOf(first!, [37, 0, 0, 255])).toBe(37);
    expect(indexOf(first!, [255, 255, 0, 0])).toBe(4095);
    expect(indexOf(overlay!, [6, 1, 0, 0])).toBe(2);
  });
  it('keep what the next one does not change', () => {
    expect(entryOf(first!, 37)).toEqual([200, 100, 50]);
    expect(entryOf(second!, 37)).toEqual([9, 8, 7]);
    expect(entryOf(second!, 258)).toEqual([1, 2, 3]);
    expect(entryOf(second!, 5)).toEqual([0, 0, 0]);
  });
  it('keep only as many entries as there are indices', () => {
    expect(entryOf(overlay!, 2)).toEqual([4, 5, 6]);
    expect(entryOf(last!, 258)).toEqual([0, 0, 0]);
    expect(entryOf(last!, 2)).toEqual([4, 5, 6]);
  });
  it('show what is below at index 0 of planes above', () => {
    expect(entryOf(overlay!, 0)).toBeUndefined();
    expect(entryOf(first!, 0)).toEqual([0, 0, 0]);
  });
});
