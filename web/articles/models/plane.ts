// Points and lines of a plane.
import type { Spot } from './model';

export const minus = (a: Spot, b: Spot): Spot => [a[0] - b[0], a[1] - b[1]];
export const plus = (a: Spot, b: Spot): Spot => [a[0] + b[0], a[1] + b[1]];
export const scaled = (a: Spot, by: number): Spot => [a[0] * by, a[1] * by];
export const dot = (a: Spot, b: Spot): number => a[0] * b[0] + a[1] * b[1];
export const cross = (a: Spot, b: Spot): number => a[0] * b[1] - a[1] * b[0];
export const lengthOf = (a: Spot): number => Math.hypot(a[0], a[1]);
export const mixed = (a: Spot, b: Spot, t: number): Spot => plus(a, scaled(minus(b, a), t));
export const unit = (a: Spot): Spot => scaled(a, 1 / (lengthOf(a) || 1));
/** Turned by a right angle, clockwise: outwards from a side of a counterclockwise polygon. */
export const outwards = (side: Spot): Spot => [side[1], -side[0]];

/** Where the line a + t (b - a) meets the segment from c to d: t; none if it does not. */
export function meets(a: Spot, b: Spot, c: Spot, d: Spot): number | undefined {
  const along = minus(b, a);
  const side = minus(d, c);
  const area = cross(along, side);
  if (area === 0) return undefined;
  const t = cross(minus(c, a), side) / area;
  const s = cross(minus(c, a), along) / area;
  return s >= 0 && s <= 1 ? t : undefined;
}

/** The sides of a closed outline. */
export const sidesOf = (corners: readonly Spot[]): [Spot, Spot][] =>
  corners.map((corner, i) => [corner, corners[(i + 1) % corners.length]!]);
