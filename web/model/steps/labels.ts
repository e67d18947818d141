// Places for the names of outlines, so that none covers another. Does not draw.
import type { Loop } from './log';

export interface Label {
  readonly text: string;
  readonly x: number;
  readonly y: number;
  /** Placed even if it covers another. */
  readonly important: boolean;
}

/** The middle of the largest loop's corners. */
export function middleOf(outline: readonly Loop[]): [number, number] | undefined {
  const [first, ...others] = outline;
  const loop = others.reduce((most, l) => (areaOf(l) > areaOf(most) ? l : most), first ?? []);
  if (loop.length === 0) return undefined;
  const mean = (axis: 0 | 1) => loop.reduce((sum, p) => sum + p[axis], 0) / loop.length;
  return [mean(0), mean(1)];
}

/**
 * Where the outline's name stands: in its middle if it has room there, else above it, or below at
 * the picture's top.
 */
export function nameAt(
  outline: readonly Loop[],
  text: string,
  letter: number,
): [number, number] | undefined {
  const middle = middleOf(outline);
  const corners = outline.flat();
  const ends = (axis: 0 | 1): [number, number] => {
    const all = corners.map((p) => p[axis]);
    return [Math.min(...all), Math.max(...all)];
  };
  if (!middle) return undefined;
  const [left, right] = ends(0);
  const [top, bottom] = ends(1);
  if (right - left > widthOf(text, letter) && bottom - top > 1.5 * letter) return middle;
  const above = top - 0.9 * letter;
  return [middle[0], above > 0.6 * letter ? above : bottom + 0.9 * letter];
}

const widthOf = (text: string, letter: number): number => 0.62 * text.length * letter;

function areaOf(loop: Loop): number {
  const twice = loop.reduce((sum, a, i) => {
    const b = loop[(i + 1) % loop.length]!;
    return sum + a[0] * b[1] - b[0] * a[1];
  }, 0);
  return Math.abs(twice) / 2;
}

/** Moves labels of this letter height apart; drops those that find no place. */
export function spread(labels: readonly Label[], letter: number): Label[] {
  const placed: Label[] = [];
  const meet = (a: Label, b: Label) =>
    Math.abs(a.x - b.x) < widthOf(a.text + b.text, letter) / 2 + 0.3 * letter &&
    Math.abs(a.y - b.y) < 1.05 * letter;
  const moves = [0, 1.1, -1.1, 2.2, -2.2].flatMap((dy) => [0, 1.5, -1.5].map((dx) => [dx, dy]));
  for (const label of [...labels].sort((a, b) => Number(b.important) - Number(a.important))) {
    const places = moves.map(([dx, dy]) => ({
      ...label,
      x: label.x + dx! * letter,
      y: label.y + dy! * letter,
    }));
    const free = places.find((place) => !placed.some((other) => meet(place, other)));
    if (free) placed.push(free);
    else if (label.important) placed.push(label);
  }
  return placed;
}
