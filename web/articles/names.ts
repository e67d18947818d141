// Places for the names of a model's points: beside their circles, and none over another. Does not
// draw.
import type { Spot } from './models/model';

/** x, y: its middle. */
export interface Named {
  readonly text: string;
  readonly x: number;
  readonly y: number;
}
interface Box extends Named {
  readonly width: number;
  readonly height: number;
}

const circle = 30;
/** Latin letters are half as wide as Japanese ones. */
const widthOf = (text: string, letter: number): number =>
  [...text].reduce((sum, sign) => sum + (sign < '\u2e80' ? 0.54 : 1), 0) * letter;
const boxOf = (named: Named, letter: number): Box => ({
  ...named,
  width: widthOf(named.text, letter) + 4,
  height: letter * 1.2,
});
const common = (a: Box, b: Box): number =>
  Math.max(0, (a.width + b.width) / 2 - Math.abs(a.x - b.x)) *
  Math.max(0, (a.height + b.height) / 2 - Math.abs(a.y - b.y));

/** Where each point's name stands, among other texts of the picture. */
export function placedNames(
  points: readonly Named[],
  others: readonly Named[],
  letter: number,
  [width, height]: Spot,
): Named[] {
  const circles = points.map(({ x, y }) => ({ text: '', x, y, width: circle, height: circle }));
  const taken = [...circles, ...others.map((other) => boxOf(other, letter * 1.2))];
  const cost = (box: Box): number => {
    const outside = [
      box.width / 2 - box.x,
      box.x + box.width / 2 - width,
      box.height / 2 - box.y,
      box.y + box.height / 2 - height,
    ];
    const beyond = outside.reduce((sum, by) => sum + Math.max(0, by), 0) * letter;
    return taken.reduce((sum, other) => sum + common(box, other), beyond);
  };
  return points.map((point) => {
    const box = boxOf(point, letter);
    const aside = circle / 2 + box.width / 2;
    const steps = [1, 1.9, 2.8].map((by) => by * (circle / 2 + letter / 2));
    const moves = [
      ...steps.flatMap((dy) => [-dy, dy].map((y): Spot => [0, y])),
      ...[0, ...steps].flatMap((dy) =>
        [aside, -aside].flatMap((x) => [-dy, dy].map((y): Spot => [x, y])),
      ),
    ];
    const places = moves.map(([dx, dy]) => ({ ...box, x: box.x + dx, y: box.y + dy }));
    const best = places.reduce((a, b) => (cost(b) < cost(a) ? b : a));
    taken.push(best);
    return { text: best.text, x: best.x, y: best.y };
  });
}
