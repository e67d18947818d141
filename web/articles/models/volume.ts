// Two walls between a light and a point, from above: their shadow volumes, and the counts of the
// borders that a line of sight crosses before the point and behind it.
import type { Model, Shape, Spot } from './model';
import { cross, minus, mixed, plus, scaled, sidesOf, unit } from './plane';

const far = 1000;

/** The volume behind a wall, counterclockwise; none if the wall points at the light. */
function volumeOf(light: Spot, from: Spot, to: Spot): Spot[] | undefined {
  const area = cross(minus(from, light), minus(to, light));
  if (area === 0) return undefined;
  const [a, b] = area > 0 ? [from, to] : [to, from];
  const away = (spot: Spot): Spot => plus(spot, scaled(unit(minus(spot, light)), far));
  return [a, away(a), away(b), b];
}

/** Where the line enters and leaves, as parts of the way from p to q; none if it passes by. */
function bordersOf(p: Spot, q: Spot, outline: readonly Spot[]): [number, number] | undefined {
  let [enter, leave] = [-Infinity, Infinity];
  for (const [begin, end] of sidesOf(outline)) {
    const side = minus(end, begin);
    const [first, change] = [cross(side, minus(p, begin)), cross(side, minus(q, p))];
    if (change === 0) {
      if (first < 0) return undefined;
    } else if (change > 0) enter = Math.max(enter, -first / change);
    else leave = Math.min(leave, -first / change);
  }
  return enter < leave ? [enter, leave] : undefined;
}

export const volume: Model = {
  box: [-6, -5, 6, 5],
  grid: 0.5,
  spots: {
    light: [-4.5, 4],
    eye: [-5, -4],
    point: [3, -1],
    a: [-2, 3],
    b: [-2.5, 1],
    c: [0, 0.5],
    d: [1, 2],
  },
  names: {
    light: 'light',
    eye: 'eye',
    point: 'point',
    a: 'end of wall 1',
    b: 'other end of wall 1',
    c: 'end of wall 2',
    d: 'other end of wall 2',
  },
  look: (spots) => {
    const [light, eye, point] = [spots['light']!, spots['eye']!, spots['point']!];
    const shapes: Shape[] = [];
    const walls: [Spot, Spot][] = [
      [spots['a']!, spots['b']!],
      [spots['c']!, spots['d']!],
    ];
    const values = { enter: 0, leave: 0, out: 0, into: 0, around: 0 };
    const dots: Shape[] = [];
    walls.forEach(([from, to], i) => {
      const tone = i === 0 ? 'first' : 'second';
      const outline = volumeOf(light, from, to);
      if (outline)
        shapes.push({
          id: `volume${i + 1}`,
          kind: 'polygon',
          at: outline,
          tone,
        });
      const middle = mixed(from, to, 0.5);
      shapes.push({ id: `wall${i + 1}`, kind: 'line', at: [from, to], tone });
      shapes.push({ kind: 'text', at: [middle], tone, text: String(i + 1) });
      const borders = outline && bordersOf(eye, point, outline);
      if (!borders) return;
      const [enter, leave] = borders;
      if (enter < 0 && leave > 0) values.around += 1;
      for (const [t, front, behind, shown] of [
        [enter, 'enter', 'into', 'front'],
        [leave, 'leave', 'out', 'wrong'],
      ] as const) {
        if (t <= 0) continue;
        values[t < 1 ? front : behind] += 1;
        dots.push({
          id: shown === 'front' ? 'entering' : 'leaving',
          kind: 'dot',
          at: [mixed(eye, point, t)],
          tone: shown,
        });
      }
    });
    shapes.push({ kind: 'line', at: [eye, mixed(eye, point, 10)], tone: 'light' });
    shapes.push({ id: 'sight', kind: 'line', at: [eye, point], tone: 'faint' }, ...dots);
    const [pass, fail] = [values.enter - values.leave, values.out - values.into];
    return { shapes, values: { ...values, pass, fail } };
  },
};
