// Moves an eye around the point it looks at, as a hand on the picture does. Does not draw.
import { cross, dot, minus, unit, type Point } from './point';

export interface Eye {
  readonly eye: Point;
  readonly at: Point;
  readonly up: Point;
}

const scaled = (a: Point, by: number): Point => [a[0] * by, a[1] * by, a[2] * by];
const plus = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** `p` turned about the unit vector `axis` by `angle` radians. */
function turned(p: Point, axis: Point, angle: number): Point {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return plus(plus(scaled(p, c), scaled(cross(axis, p), s)), scaled(axis, dot(axis, p) * (1 - c)));
}

/** Numbers of an address: as short as a hand is exact. */
const rounded = (p: Point): Point => p.map((v) => Number(v.toPrecision(6))) as unknown as Point;

/** Turns by angles in radians: to the right about `up`, and upwards, but never over the pole. */
export function orbit(from: Eye, right: number, upwards: number): Eye {
  const up = unit(from.up);
  const away = turned(minus(from.eye, from.at), up, -right);
  const side = unit(cross(up, away));
  const height = Math.asin(Math.min(1, Math.max(-1, dot(unit(away), up))));
  const limit = (85 * Math.PI) / 180;
  const wanted = Math.min(limit, Math.max(-limit, height + upwards));
  const bent = Math.abs(height) > limit ? away : turned(away, side, height - wanted);
  return { ...from, eye: rounded(plus(from.at, bent)) };
}

/** Nearer (by < 1) or farther. */
export const dolly = (from: Eye, by: number): Eye => ({
  ...from,
  eye: rounded(plus(from.at, scaled(minus(from.eye, from.at), by))),
});
