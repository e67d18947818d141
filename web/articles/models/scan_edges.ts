// A triangle on a grid of pixels and one scan line: where its edges cross the line, and how x grows
// from line to line. y counts upwards, as in the textbooks.
import type { Model, Shape, Spot } from './model';
import { minus, mixed, sidesOf } from './plane';

export const scanEdges: Model = {
  box: [0, 0, 24, 18],
  grid: 1,
  spots: { a: [3, 2], b: [21, 6], c: [9, 16], line: [23, 8] },
  names: { a: 'corner a', b: 'corner b', c: 'corner c', line: 'scan line' },
  limit: (name, [x, y]) => (name === 'line' ? [23, Math.min(17, y)] : [x, y]),
  look: (spots) => {
    const corners = ['a', 'b', 'c'].map((name) => spots[name]!);
    const row = spots['line']![1];
    const y = row + 0.5;
    const shapes: Shape[] = [{ kind: 'polygon', at: corners, tone: 'second' }];
    const values: Record<string, number | string> = { row };
    const crossed: number[] = [];
    let edges = 0;
    sidesOf(corners).forEach(([from, to], i) => {
      const name = `edge${i + 1}`;
      const [low, high] = from[1] <= to[1] ? [from, to] : [to, from];
      const [dx, dy] = minus(high, low);
      const active = low[1] <= y && y < high[1];
      values[`dx${i + 1}`] = dy === 0 ? 0 : dx / dy;
      values[`top${i + 1}`] = high[1];
      if (active) {
        edges += 1;
        const x = low[0] + ((y - low[1]) * dx) / dy;
        crossed.push(x);
        shapes.push({ kind: 'dot', at: [[x, y]], tone: 'wrong' });
      }
      shapes.push({ id: name, kind: 'line', at: [from, to], tone: active ? 'first' : 'back' });
      shapes.push({ kind: 'text', at: [mixed(from, to, 0.5)], tone: 'faint', text: String(i + 1) });
    });
    crossed.sort((p, q) => p - q);
    const [left, right] = [crossed[0] ?? 0, crossed[1] ?? 0];
    /** Pixels whose centre is between the crossings. */
    const [begin, end] = [Math.ceil(left - 0.5), Math.ceil(right - 0.5)];
    for (let x = begin; x < end; ++x) {
      const at: Spot[] = [
        [x, row],
        [x + 1, row],
        [x + 1, row + 1],
        [x, row + 1],
      ];
      shapes.push({ id: 'span', kind: 'cell', at, tone: 'first' });
    }
    shapes.push({
      kind: 'line',
      at: [
        [0, y],
        [24, y],
      ],
      tone: 'light',
    });
    return { shapes, values: { ...values, edges, left, right, begin, pixels: end - begin } };
  },
};
