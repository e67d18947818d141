// A triangle on a grid of pixels and Warnock's windows: a window that is neither empty nor covered
// is divided into four, down to the pixel.
import type { Model, Shape, Spot } from './model';
import { cross, minus, outwards, dot, sidesOf } from './plane';

const across = 16;

type Answer = 'empty' | 'covered' | 'divided' | 'pixel';

const corners = (x: number, y: number, size: number): Spot[] => [
  [x, y],
  [x + size, y],
  [x + size, y + size],
  [x, y + size],
];

/** Two convex shapes are apart if a side of one of them separates them. */
function areApart(window: readonly Spot[], triangle: readonly Spot[]): boolean {
  return [...sidesOf(window), ...sidesOf(triangle)].some(([from, to]) => {
    const normal = outwards(minus(to, from));
    const [p, q] = [window, triangle].map((shape) => shape.map((spot) => dot(spot, normal)));
    return Math.max(...p!) <= Math.min(...q!) || Math.max(...q!) <= Math.min(...p!);
  });
}

const isCovered = (window: readonly Spot[], triangle: readonly Spot[]): boolean => {
  const sides = sidesOf(triangle);
  const turn = Math.sign(
    cross(minus(triangle[1]!, triangle[0]!), minus(triangle[2]!, triangle[0]!)),
  );
  return (
    turn !== 0 &&
    window.every((spot) =>
      sides.every(([from, to]) => turn * cross(minus(to, from), minus(spot, from)) >= 0),
    )
  );
};

export const windows: Model = {
  box: [0, 0, across, across],
  grid: 1,
  spots: { a: [2, 1], b: [15, 4], c: [6, 14] },
  names: { a: 'corner a', b: 'corner b', c: 'corner c' },
  look: (spots) => {
    const triangle = ['a', 'b', 'c'].map((name) => spots[name]!);
    const found: Record<Answer, number> = { empty: 0, covered: 0, divided: 0, pixel: 0 };
    const shapes: Shape[] = [];
    let first: Answer = 'empty';
    const look = (x: number, y: number, size: number): void => {
      const at = corners(x, y, size);
      const apart = areApart(at, triangle);
      const covered = !apart && isCovered(at, triangle);
      const answer = apart ? 'empty' : covered ? 'covered' : size === 1 ? 'pixel' : 'divided';
      found[answer] += 1;
      if (size === across) first = answer;
      if (answer === 'divided') {
        const half = size / 2;
        for (const [dx, dy] of corners(0, 0, half)) look(x + dx, y + dy, half);
      } else {
        const tone = answer === 'covered' ? 'front' : answer === 'pixel' ? 'wrong' : 'faint';
        shapes.push({ id: answer, kind: 'cell', at, tone });
        shapes.push({ kind: 'line', at: [...at, at[0]!], tone: 'light' });
      }
    };
    look(0, 0, across);
    shapes.push({ id: 'triangle', kind: 'line', at: [...triangle, triangle[0]!], tone: 'second' });
    const all = found.empty + found.covered + found.divided + found.pixel;
    return {
      shapes,
      values: { ...found, first, windows: all, pixels: across * across },
    };
  },
};
