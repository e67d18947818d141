// A line in the picture and two surfaces before it: how many of them hide each part of the line,
// and where this number changes.
import type { Model, Shape, Spot } from './model';
import { cross, minus, mixed, plus, sidesOf } from './plane';

/** Corners around a spot: convex, counterclockwise. */
const outlines: Readonly<Record<string, readonly Spot[]>> = {
  a: [
    [-2, -2.2],
    [2.2, -1.4],
    [0.6, 2.6],
  ],
  b: [
    [-2.4, -1.2],
    [1.8, -1.8],
    [2.4, 1.6],
    [-1.4, 2],
  ],
};

/** The part of the line from p to q that is inside: two parameters; none if it passes by. */
function insideOf(p: Spot, q: Spot, outline: readonly Spot[]): [number, number] | undefined {
  let [from, to] = [0, 1];
  for (const [begin, end] of sidesOf(outline)) {
    const side = minus(end, begin);
    const [first, last] = [cross(side, minus(p, begin)), cross(side, minus(q, begin))];
    if (first < 0 && last < 0) return undefined;
    const t = first / (first - last);
    if (first < 0) from = Math.max(from, t);
    else if (last < 0) to = Math.min(to, t);
  }
  return from < to ? [from, to] : undefined;
}

export const invisibility: Model = {
  box: [-6, -5, 6, 5],
  grid: 0.5,
  spots: { p: [-5, -1], q: [5, 1.5], a: [-1.5, 0], b: [1.5, 0.5] },
  names: { p: 'end p of the line', q: 'end q of the line', a: 'surface 1', b: 'surface 2' },
  look: (spots) => {
    const [p, q] = [spots['p']!, spots['q']!];
    const shapes: Shape[] = [];
    const changes: { t: number; by: number }[] = [];
    ['a', 'b'].forEach((name, i) => {
      const outline = outlines[name]!.map((corner) => plus(corner, spots[name]!));
      const tone = i === 0 ? 'first' : 'second';
      shapes.push({
        id: `surface${i + 1}`,
        kind: 'polygon',
        at: outline,
        tone,
      });
      shapes.push({
        id: `surface${i + 1}`,
        kind: 'line',
        at: [...outline, outline[0]!],
        tone,
      });
      const part = insideOf(p, q, outline);
      if (part) changes.push({ t: part[0], by: 1 }, { t: part[1], by: -1 });
    });
    changes.sort((one, other) => one.t - other.t || one.by - other.by);
    const ends = [0, ...changes.map(({ t }) => t), 1];
    const numbers: number[] = [];
    let number = 0;
    let seen = 0;
    ends.slice(0, -1).forEach((from, i) => {
      if (i > 0) number += changes[i - 1]!.by;
      const to = ends[i + 1]!;
      if (to <= from) return;
      numbers.push(number);
      if (number === 0) seen += to - from;
      const at = [mixed(p, q, from), mixed(p, q, to)];
      shapes.push({ id: 'line', kind: 'line', at, tone: number === 0 ? 'front' : 'back' });
      const middle = plus(mixed(p, q, (from + to) / 2), [0, 0.5]);
      shapes.push({ kind: 'text', at: [middle], tone: 'faint', text: String(number) });
    });
    const crossings = changes.filter(({ t }) => t > 0 && t < 1);
    for (const { t } of crossings)
      shapes.push({ id: 'crossing', kind: 'dot', at: [mixed(p, q, t)], tone: 'wrong' });
    const values = {
      crossings: crossings.length,
      numbers: numbers.join(', '),
      start: numbers[0] ?? 0,
      most: Math.max(0, ...numbers),
      parts: numbers.filter((value) => value === 0).length,
      seen: 100 * seen,
    };
    return { shapes, values };
  },
};
