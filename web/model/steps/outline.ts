// The outline of a polygon or piece that a log gives in triangles: a side between two of them is no
// side of the whole. Does not draw.
import type { Loop } from './log';
import type { Point } from '../point';

/** The same for points that differ by rounding only. */
const keyOf = (p: Point): string => `${Math.round(p[0] * 256)},${Math.round(p[1] * 256)}`;

type Side = readonly [from: Point, to: Point];

/** The sides that one part only has. */
function outerSides(parts: readonly Loop[]): Side[] {
  const sides = new Map<string, Side>();
  for (const part of parts)
    part.forEach((from, i) => {
      const to = part[(i + 1) % part.length]!;
      const ends = [keyOf(from), keyOf(to)].sort();
      if (ends[0] === ends[1]) return;
      const name = ends.join(' ');
      if (!sides.delete(name)) sides.set(name, [from, to]);
    });
  return [...sides.values()];
}

/** The sides one after the other as closed loops; none if they do not close. */
function chained(sides: readonly Side[]): Loop[] | undefined {
  const leaving = new Map<string, Side[]>();
  for (const side of sides) {
    const key = keyOf(side[0]);
    leaving.set(key, [...(leaving.get(key) ?? []), side]);
  }
  const loops: Loop[] = [];
  for (const first of sides) {
    if (!leaving.get(keyOf(first[0]))?.includes(first)) continue;
    const loop: Point[] = [];
    let side = first;
    for (;;) {
      const [from, to]: Side = side;
      const others: Side[] = leaving.get(keyOf(from)) ?? [];
      leaving.set(
        keyOf(from),
        others.filter((other) => other !== side),
      );
      loop.push(from);
      if (keyOf(to) === keyOf(first[0])) break;
      const next = leaving.get(keyOf(to))?.[0];
      if (!next) return undefined;
      side = next;
    }
    loops.push(loop);
  }
  return loops;
}

const known = new WeakMap<readonly Loop[], readonly Loop[]>();

/** The outline of all parts together; the parts if their sides do not close. */
export function whole(parts: readonly Loop[]): readonly Loop[] {
  if (parts.length < 2) return parts;
  const found = known.get(parts) ?? chained(outerSides(parts)) ?? parts;
  known.set(parts, found);
  return found;
}
