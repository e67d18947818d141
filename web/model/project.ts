// Lines in space on a picture: a matrix of 4 x 4 numbers, by columns, from world to clip space, as
// the machine has it. Does not draw.
import type { Point } from './point';

export type Line = readonly [x1: number, y1: number, x2: number, y2: number];

const nearest = 1e-3; // of the farther end's distance: what is behind the eye is cut off

/** In pixels, the upper row first; none: all of it is behind the eye. */
export function lineOnPicture(
  matrix: readonly number[],
  from: Point,
  to: Point,
  width: number,
  height: number,
): Line | undefined {
  const clip = (p: Point): [number, number, number] => {
    const row = (i: number): number =>
      matrix[i]! * p[0] + matrix[4 + i]! * p[1] + matrix[8 + i]! * p[2] + matrix[12 + i]!;
    return [row(0), row(1), row(3)];
  };
  let a = clip(from);
  let b = clip(to);
  const least = nearest * Math.max(a[2], b[2]);
  if (!(Math.max(a[2], b[2]) > 0)) return undefined;
  const cut = (p: typeof a, q: typeof a): typeof a => {
    if (p[2] >= least) return p;
    const t = (least - p[2]) / (q[2] - p[2]);
    return [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), least];
  };
  [a, b] = [cut(a, b), cut(b, a)];
  const place = (p: typeof a): [number, number] => [
    ((p[0] / p[2] + 1) / 2) * width,
    ((1 - p[1] / p[2]) / 2) * height,
  ];
  return [...place(a), ...place(b)];
}

/** The twelve edges of a box. */
export function edgesOfBox(low: Point, high: Point): [Point, Point][] {
  const corner = (i: number): Point => [
    i & 1 ? high[0] : low[0],
    i & 2 ? high[1] : low[1],
    i & 4 ? high[2] : low[2],
  ];
  const edges: [Point, Point][] = [];
  for (let i = 0; i < 8; ++i)
    for (const bit of [1, 2, 4]) if (!(i & bit)) edges.push([corner(i), corner(i | bit)]);
  return edges;
}
