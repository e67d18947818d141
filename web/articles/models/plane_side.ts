// Two walls from above: on which side of the second one's plane the eye and both ends of the first
// one are, whether that gives an order, and where a cut would be.
import type { Model, Shape, Spot } from './model';
import { dot, minus, mixed, outwards, plus, scaled, unit } from './plane';

export const planeSide: Model = {
  box: [-6, -5, 6, 5],
  grid: 0.5,
  spots: { eye: [0, -4.5], p: [-3.5, 2.5], q: [1, -1], c: [-3, -1.5], d: [4, 2] },
  names: {
    eye: 'eye',
    p: 'end p of wall 1',
    q: 'end q of wall 1',
    c: 'left end of wall 2',
    d: 'right end of wall 2',
  },
  look: (spots) => {
    const [eye, p, q, c, d] = ['eye', 'p', 'q', 'c', 'd'].map((name) => spots[name]!) as [
      Spot,
      Spot,
      Spot,
      Spot,
      Spot,
    ];
    const along = unit(minus(d, c));
    const normal = outwards(along);
    const distance = (spot: Spot) => dot(minus(spot, c), normal);
    const [e, first, second] = [distance(eye), distance(p), distance(q)];
    const cuts = first * second < 0;
    const front = (first + second) * e >= 0;
    const shapes: Shape[] = [
      {
        kind: 'line',
        at: [plus(c, scaled(along, -20)), plus(c, scaled(along, 20))],
        tone: 'light',
      },
      { id: 'wall2', kind: 'line', at: [c, d], tone: 'second' },
      { kind: 'text', at: [mixed(c, d, 0.75)], tone: 'second', text: '2' },
    ];
    const t = cuts ? first / (first - second) : 1;
    const cut = mixed(p, q, t);
    const isNear = (value: number) => value * e >= 0;
    shapes.push(
      { id: 'wall1', kind: 'line', at: [p, cut], tone: isNear(first || second) ? 'front' : 'back' },
      { id: 'wall1', kind: 'line', at: [cut, q], tone: isNear(second || first) ? 'front' : 'back' },
      { kind: 'text', at: [mixed(p, q, 0.3)], tone: 'front', text: '1' },
    );
    if (cuts) shapes.push({ id: 'cut', kind: 'dot', at: [cut], tone: 'wrong' });
    const order = cuts ? '1b, 2, 1a' : front ? '2, 1' : '1, 2';
    const values = { eye: e, p: first, q: second, pieces: cuts ? 3 : 2, order };
    return { shapes, values: { ...values, part: cuts ? t : 0 } };
  },
};
