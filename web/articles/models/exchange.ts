// Two long strips that send light to each other, from the end: their form factor by the difference
// of distances (Hottel's crossed strings), and what each sends after some shots.
import type { Model, Shape, Spot } from './model';
import { lengthOf, minus, mixed } from './plane';

const floor = -3;
const [rho1, rho2] = [0.5, 0.8];

/** The light that leaves the part from p to q of the floor and reaches the strip. */
const reaching = (p: Spot, q: Spot, c: Spot, d: Spot): number => {
  const of = (from: Spot, to: Spot) => lengthOf(minus(from, to));
  return Math.abs(of(p, d) - of(q, d) - of(p, c) + of(q, c)) / 2;
};

/** Of all the light of strip 1, the part that reaches strip 2, from either side of it. */
function formFactor(a: Spot, b: Spot, c: Spot, d: Spot): number {
  const slope = (d[0] - c[0]) / (d[1] - c[1]);
  /** Where the line of strip 2 meets the floor: the two parts see different sides. */
  const x = c[0] + (floor - c[1]) * slope;
  const between = Number.isFinite(x) ? Math.min(b[0], Math.max(a[0], x)) : b[0];
  const middle: Spot = [between, floor];
  return (reaching(a, middle, c, d) + reaching(middle, b, c, d)) / (b[0] - a[0]);
}

export const exchange: Model = {
  box: [-6, -5, 6, 5],
  grid: 0.5,
  spots: { a: [-3, floor], b: [3, floor], c: [-2, 1], d: [2, 2] },
  names: {
    a: 'left end of strip 1',
    b: 'right end of strip 1',
    c: 'left end of strip 2',
    d: 'right end of strip 2',
  },
  limit: (name, [x, y]) =>
    name === 'a'
      ? [Math.min(-0.5, x), floor]
      : name === 'b'
        ? [Math.max(0.5, x), floor]
        : [name === 'c' ? Math.min(-0.5, x) : Math.max(0.5, x), Math.max(floor + 1, y)],
  look: (spots) => {
    const [a, b, c, d] = ['a', 'b', 'c', 'd'].map((name) => spots[name]!) as [
      Spot,
      Spot,
      Spot,
      Spot,
    ];
    const [length1, length2] = [lengthOf(minus(a, b)), lengthOf(minus(c, d))];
    const F12 = formFactor(a, b, c, d);
    const F21 = (F12 * length1) / length2;
    const back = rho1 * rho2 * F12 * F21;
    const values = {
      F12,
      F21,
      length1,
      length2,
      rho1,
      rho2,
      E: 1,
      shot1: rho2 * F21,
      shot2: back,
      B1: 1 / (1 - back),
      B2: (rho2 * F21) / (1 - back),
      share: 100 * F12,
      escaped: 100 * (1 - F12),
    };
    const string = (from: Spot, to: Spot, id: string): Shape => ({
      id,
      kind: 'line',
      at: [from, to],
      tone: id === 'crossed' ? 'wrong' : 'light',
    });
    const shapes: Shape[] = [
      string(a, c, 'straight'),
      string(b, d, 'straight'),
      string(a, d, 'crossed'),
      string(b, c, 'crossed'),
      { id: 'strip1', kind: 'line', at: [a, b], tone: 'first' },
      { id: 'strip2', kind: 'line', at: [c, d], tone: 'second' },
      { kind: 'text', at: [mixed(a, b, 0.5)], tone: 'first', text: '1' },
      { kind: 'text', at: [mixed(c, d, 0.5)], tone: 'second', text: '2' },
    ];
    return { shapes, values };
  },
};
