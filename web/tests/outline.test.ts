import { expect, it } from 'vitest';
import type { Loop } from '../model/steps/log';
import { whole } from '../model/steps/outline';

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
