// A comparison as `gw hidden --compare` writes it: every algorithm's picture, its difference from
// the Z-buffer's, how often it wrote each pixel, and its counts. Does not draw.
import type { Palette } from './palette';

/** Count, value, count, value ...: pixels in rows, the upper row first. */
export type Runs = readonly number[];

export interface Compared {
  readonly name: string;
  readonly title: string;
  readonly counts: Readonly<Record<string, number>>;
  readonly ids: Runs;
  /** Places in `differences`. */
  readonly difference: Runs;
  readonly writes: Runs;
}

export interface Comparison {
  readonly data: 'gw hidden comparison';
  readonly version: number;
  readonly scene: string;
  readonly size: readonly [number, number];
  readonly background: string;
  readonly polygons: readonly {
    readonly id: number;
    readonly part: string;
    readonly color: string;
  }[];
  /** How many polygons lie over each pixel. */
  readonly complexity: Runs;
  readonly algorithms: readonly Compared[];
}

export const differences = ['same', 'tie', 'edge', 'snap', 'wrong'] as const;

export function spreadRuns(runs: Runs, size: number): Uint32Array {
  const values = new Uint32Array(size);
  let at = 0;
  for (let i = 0; i + 1 < runs.length; i += 2) values.fill(runs[i + 1]!, at, (at += runs[i]!));
  return values;
}

/** One algorithm's planes, pixel by pixel. */
export interface Planes {
  readonly ids: Uint32Array;
  readonly difference: Uint32Array;
  readonly writes: Uint32Array;
}

export function planesOf(run: Compared, [width, height]: readonly [number, number]): Planes {
  const size = width * height;
  return {
    ids: spreadRuns(run.ids, size),
    difference: spreadRuns(run.difference, size),
    writes: spreadRuns(run.writes, size),
  };
}

/** Colours of the four kinds of difference, by their places in `differences`. */
export function differenceColors(palette: Palette): Record<number, string> {
  return palette === 'scene'
    ? { 1: '#ffe600', 2: '#00d2e6', 3: '#465aff', 4: '#e61414' }
    : { 1: '#f0e442', 2: '#56b4e9', 3: '#0072b2', 4: '#d55e00' };
}

/** A difference picture's values: identifiers, with the kinds above them where pixels differ. */
const firstKind = 2 ** 30;
export function differenceIds(planes: Planes): Uint32Array {
  return planes.ids.map((id, i) =>
    planes.difference[i] === 0 ? id : firstKind + planes.difference[i]!,
  );
}

/** Pixels that do not differ are pale, so that those that differ stand out. */
export function differencePalette(
  colors: ReadonlyMap<number, string>,
  palette: Palette,
): Map<number, string> {
  const found = new Map<number, string>();
  for (const [id, color] of colors) found.set(id, mixed(color, '#606060', 0.7));
  for (const [kind, color] of Object.entries(differenceColors(palette)))
    found.set(firstKind + Number(kind), color);
  return found;
}

function mixed(a: string, b: string, part: number): string {
  const value = (color: string, place: number) =>
    Number.parseInt(color.slice(1 + 2 * place, 3 + 2 * place), 16);
  const channel = (place: number) =>
    Math.round(value(a, place) * (1 - part) + value(b, place) * part)
      .toString(16)
      .padStart(2, '0');
  return `#${channel(0)}${channel(1)}${channel(2)}`;
}

/** 0, 1, 2, 3, 4, 5 times. */
export const timesColors = ['#000000', '#325ae6', '#14963c', '#f0d228', '#f08214', '#e61414'];

/** A colour for each number of times; beyond 5 the red turns to white, as in the picture files. */
export function timesPalette(): Map<number, string> {
  const found = new Map<number, string>();
  for (let times = 0; times <= 255; ++times) {
    const more = Math.min(Math.max(times - 5, 0) * 20, 225);
    const base = timesColors[Math.min(times, 5)]!;
    const channel = (place: number) =>
      Math.min(255, Number.parseInt(base.slice(1 + 2 * place, 3 + 2 * place), 16) + more)
        .toString(16)
        .padStart(2, '0');
    found.set(times, `#${channel(0)}${channel(1)}${channel(2)}`);
  }
  return found;
}

/** The counters that are not 0 everywhere; what is wrong first, then in the order of the data. */
export function countersOf(comparison: Comparison): string[] {
  const names = Object.keys(comparison.algorithms[0]?.counts ?? {});
  const order = ['wrong', ...names.filter((name) => name !== 'wrong')];
  return order.filter((name) => comparison.algorithms.some((run) => (run.counts[name] ?? 0) > 0));
}

/** By a counter, or as in the data if there is none. Equal ones keep the order of the data. */
export function sorted(
  runs: readonly Compared[],
  counter: string | undefined,
  descending: boolean,
): Compared[] {
  if (counter === undefined) return [...runs];
  const sign = descending ? -1 : 1;
  return [...runs].sort((a, b) => sign * ((a.counts[counter] ?? 0) - (b.counts[counter] ?? 0)));
}

/** Worth a look at first: those that are wrong most, and the Z-buffer, the measure of all. */
export function tellingRuns(comparison: Comparison, most = 4): string[] {
  const wrong = sorted(comparison.algorithms, 'wrong', true)
    .filter((run) => (run.counts['wrong'] ?? 0) > 0)
    .map((run) => run.name);
  const others = ['z-buffer', 'newell', 'bsp', ...comparison.algorithms.map((run) => run.name)];
  const known = new Set(comparison.algorithms.map((run) => run.name));
  const all = [...wrong.slice(0, most - 1), ...others].filter((name) => known.has(name));
  return [...new Set(all)].slice(0, most);
}
