import { expect, it } from 'vitest';
import { edgesOfBox, lineOnPicture } from '../model/project';

/** An eye at 0 that looks along -z: 90 degrees, near 1, far 3. By columns. */
const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0];

it('puts a line in space on the picture, the upper row first', () => {
  expect(lineOnPicture(matrix, [-1, 1, -1], [0, 0, -2], 80, 60)).toEqual([0, 0, 40, 30]);
});

it('cuts off what is behind the eye', () => {
  const line = lineOnPicture(matrix, [0, 0, -2], [1, 0, 2], 80, 60)!;
  expect(line.slice(0, 2)).toEqual([40, 30]);
  // It leaves the picture to the right, where x = w at last.
  expect(line[2]).toBeGreaterThan(80);
  expect(Number.isFinite(line[2])).toBe(true);
  expect(line[3]).toBe(30);
  expect(lineOnPicture(matrix, [0, 0, 1], [1, 0, 2], 80, 60)).toBeUndefined();
});

it('has twelve different edges of a box', () => {
  const edges = edgesOfBox([0, 0, 0], [1, 2, 3]);
  expect(new Set(edges.map(String)).size).toBe(12);
  for (const [a, b] of edges) expect(a.filter((v, i) => v !== b[i])).toHaveLength(1);
});
