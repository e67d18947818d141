// A ray through a pixel, from above: which of three walls it meets, and the rays that go on from
// there, to the light and, at a mirror, away from it.
import type { Model, Shape, Spot } from './model';
import { dot, meets, minus, mixed, outwards, plus, scaled, unit } from './plane';

const eye: Spot = [0, -4.5];
const screen = -3.5;
const far = 20;
const mirror = '3';

interface Hit {
  readonly name: string;
  readonly t: number;
}

export const ray: Model = {
  box: [-6, -5, 6, 5],
  grid: 0.25,
  spots: {
    pixel: [0.5, screen],
    light: [-4.5, -3.5],
    c: [5, -2.5],
    d: [5, 2.5],
    m: [1, 0],
    n: [4, 1],
  },
  names: {
    pixel: 'pixel',
    light: 'light',
    c: 'near end of wall 2',
    d: 'far end of wall 2',
    m: 'left end of the mirror',
    n: 'right end of the mirror',
  },
  limit: (name, [x, y]) => (name === 'pixel' ? [Math.min(2.5, Math.max(-2.5, x)), screen] : [x, y]),
  look: (spots) => {
    const light = spots['light']!;
    const walls: Readonly<Record<string, readonly [Spot, Spot]>> = {
      '1': [
        [-5, 4],
        [5, 4],
      ],
      '2': [spots['c']!, spots['d']!],
      [mirror]: [spots['m']!, spots['n']!],
    };
    /** What the ray meets, near to far; `without` is where it begins. */
    const hitsOf = (from: Spot, to: Spot, without?: string): Hit[] =>
      Object.entries(walls)
        .flatMap(([name, [a, b]]): Hit[] => {
          const t = name === without ? undefined : meets(from, to, a, b);
          return t !== undefined && t > 1e-9 ? [{ name, t }] : [];
        })
        .sort((one, other) => one.t - other.t);
    const pixel = spots['pixel']!;
    const hits = hitsOf(eye, pixel);
    const nearest = hits[0];
    const shapes: Shape[] = [
      {
        kind: 'line',
        at: [
          [-2.5, screen],
          [2.5, screen],
        ],
        tone: 'light',
      },
    ];
    const values: Record<string, number | string> = {
      t1: 0,
      t2: 0,
      t3: 0,
      hits: hits.length,
      nearest: nearest?.name ?? '0',
      lit: 0,
      second: '0',
      rays: 1,
      tests: 3,
    };
    for (const { name, t } of hits) values[`t${name}`] = t;
    const end = mixed(eye, pixel, nearest?.t ?? far);
    shapes.push({ id: 'ray', kind: 'arrow', at: [eye, end], tone: 'first' });
    for (const { t } of hits.slice(1))
      shapes.push({ id: 'behind', kind: 'dot', at: [mixed(eye, pixel, t)], tone: 'back' });
    if (nearest) {
      const [a, b] = walls[nearest.name]!;
      const line = unit(outwards(minus(b, a)));
      const normal = dot(line, minus(eye, end)) < 0 ? scaled(line, -1) : line;
      const shaded = dot(normal, minus(light, end)) > 0;
      const blocked = hitsOf(end, light, nearest.name).find(({ t }) => t < 1);
      const to = mixed(end, light, blocked?.t ?? 1);
      const lit = shaded && !blocked;
      shapes.push({ id: 'shadow', kind: 'arrow', at: [end, to], tone: lit ? 'front' : 'wrong' });
      values['lit'] = lit ? 1 : 0;
      values['rays'] = 2;
      if (nearest.name === mirror) {
        const along = minus(pixel, eye);
        const out = minus(along, scaled(normal, 2 * dot(along, normal)));
        const next = hitsOf(end, plus(end, out), mirror)[0];
        const stop = plus(end, scaled(out, next?.t ?? far));
        shapes.push({ id: 'reflected', kind: 'arrow', at: [end, stop], tone: 'first' });
        values['second'] = next?.name ?? '0';
        values['rays'] = 3;
      }
      values['tests'] = 3 + 2 * (Number(values['rays']) - 1);
    }
    for (const [name, at] of Object.entries(walls)) {
      shapes.push({
        id: `wall${name}`,
        kind: 'line',
        at,
        tone: 'second',
      });
      shapes.push({ kind: 'text', at: [mixed(...at, 0.25)], tone: 'faint', text: name });
    }
    shapes.push({ kind: 'dot', at: [eye], tone: 'faint' });
    return { shapes, values };
  },
};
