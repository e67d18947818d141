// Three walls from above, seen by parallel lines of sight from below: the painter's order by three
// keys, and how much of the picture each order shows wrongly.
import type { Model, Shape, Spot } from './model';
import { mixed } from './plane';

const walls = ['1', '2', '3'] as const;
const tones = { '1': 'first', '2': 'second', '3': 'front' } as const;
type Wall = readonly [Spot, Spot];

/** The depth of a wall in a column; none: it is not there. */
function depthAt([a, b]: Wall, x: number): number | undefined {
  const [left, right] = a[0] <= b[0] ? [a, b] : [b, a];
  if (x < left[0] || x >= right[0]) return undefined;
  return left[1] + ((x - left[0]) / (right[0] - left[0])) * (right[1] - left[1]);
}

const keyOf: Readonly<Record<string, (a: number, b: number) => number>> = {
  nearest: Math.min,
  farthest: Math.max,
  centroid: (a, b) => (a + b) / 2,
};
const columns = Array.from({ length: 120 }, (_, i) => -5.95 + 0.1 * i);

export const keys: Model = {
  box: [-6, -4, 6, 4],
  grid: 0.5,
  spots: { a: [-5, -3], b: [5, 3], c: [-3, -0.5], d: [-1.5, -0.5], e: [1, 0.5], f: [3, 0.5] },
  names: {
    a: 'left end of wall 1',
    b: 'right end of wall 1',
    c: 'left end of wall 2',
    d: 'right end of wall 2',
    e: 'left end of wall 3',
    f: 'right end of wall 3',
  },
  look: (spots) => {
    const ends: Record<string, Wall> = {
      '1': [spots['a']!, spots['b']!],
      '2': [spots['c']!, spots['d']!],
      '3': [spots['e']!, spots['f']!],
    };
    const shapes: Shape[] = [];
    const values: Record<string, number | string> = {};
    for (const name of walls) {
      shapes.push({ id: `wall${name}`, kind: 'line', at: ends[name]!, tone: tones[name] });
      shapes.push({
        kind: 'text',
        at: [mixed(...ends[name]!, 0.5)],
        tone: tones[name],
        text: name,
      });
    }
    const nearestAt = (x: number) =>
      walls
        .map((name) => ({ name, z: depthAt(ends[name]!, x) }))
        .filter(({ z }) => z !== undefined)
        .sort((p, q) => p.z! - q.z!)[0]?.name;
    for (const [key, of] of Object.entries(keyOf)) {
      const distance = (name: string) => of(ends[name]![0][1], ends[name]![1][1]);
      for (const name of walls) values[`${key}${name}`] = distance(name);
      const order = [...walls].sort((p, q) => distance(q) - distance(p));
      const last = (x: number) => order.findLast((name) => depthAt(ends[name]!, x) !== undefined);
      const wrong = columns.filter((x) => last(x) !== nearestAt(x));
      values[`order_${key}`] = order.join(', ');
      values[`wrong_${key}`] = wrong.length;
      if (key === 'centroid')
        for (const x of wrong) shapes.push({ kind: 'dot', at: [[x, -3.9]], tone: 'wrong' });
    }
    return { shapes, values };
  },
};
