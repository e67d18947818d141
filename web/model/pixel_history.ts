// Histories of pixels. They lie in scripts of 64 x 64 pixels, loaded on demand: a page from disk
// may run scripts but not read files. Does not show anything.
import type { MapChange, Pass, Report } from './report';

type Four = readonly number[];
export interface PixelValues {
  readonly color: Four;
  readonly depth: number;
  readonly stencil: number;
  readonly accum: Four;
  readonly back: Four;
}
export type ValuePlane = keyof PixelValues;

/** New values, by the first letter of the plane; 0: none. */
type Change = 0 | { c?: Four; z?: number; s?: number; a?: Four; b?: Four };
type Row = readonly [number, number, number, Change, ...number[]];
interface Tile {
  readonly width: number;
  readonly start: readonly (readonly [number, Change])[];
  readonly rows: readonly Row[];
}

export interface Fragment {
  readonly draw: number;
  readonly primitive: number;
  readonly polygon: number;
  /** 0 alpha, 1 stencil, 2 depth test, 3 written. */
  readonly fate: number;
  readonly color: Four;
  readonly depth: number;
}

export interface PixelEvent {
  readonly command: number;
  readonly fragment: Fragment | undefined;
  readonly before: PixelValues;
  after: PixelValues;
}

const waiting = new Map<string, (tile: Tile) => void>();
const tiles = new Map<string, Promise<Tile>>();

/** Called by a tile's script. */
export function takeTile(name: string, tile: Tile): void {
  waiting.get(name)?.(tile);
}

function tileNamed(name: string): Promise<Tile> {
  const known = tiles.get(name);
  if (known) return known;
  const loaded = new Promise<Tile>((resolve, reject) => {
    waiting.set(name, resolve);
    const script = document.createElement('script');
    script.src = `history/${name}.js`;
    script.onerror = () => {
      tiles.delete(name);
      reject(new Error(script.getAttribute('src')!));
    };
    document.head.append(script);
  });
  tiles.set(name, loaded);
  return loaded;
}

function changed(values: PixelValues, change: Change): PixelValues {
  if (change === 0) return values;
  return {
    color: change.c ?? values.color,
    depth: change.z ?? values.depth,
    stencil: change.s ?? values.stencil,
    accum: change.a ?? values.accum,
    back: change.b ?? values.back,
  };
}

function startOf(tile: Tile, pixel: number): PixelValues {
  const none = [0, 0, 0, 0];
  const zero = { color: none, depth: 0, stencil: 0, accum: none, back: none };
  let first = 0;
  for (const [count, change] of tile.start) {
    if (pixel < first + count) return changed(zero, change);
    first += count;
  }
  return zero;
}

function fragmentOf(row: Row): Fragment | undefined {
  if (row.length === 4) return undefined;
  const [draw, primitive, polygon, fate] = row.slice(4, 8) as [number, number, number, number];
  const depth = row[13] as number;
  return { draw, primitive, polygon, fate, color: row.slice(9, 13) as number[], depth };
}

/** Everything that happened to a pixel of a tile, in order. */
export function eventsOf(tile: Tile, pixel: number): PixelEvent[] {
  const events: PixelEvent[] = [];
  let values = startOf(tile, pixel);
  for (const row of tile.rows) {
    if (pixel < row[0] || pixel >= row[0] + row[1]) continue;
    const before = values;
    const fragment = fragmentOf(row);
    const last = events.at(-1);
    values = changed(values, row[3]);
    // A command that touches the pixel plane by plane is one event.
    if (!fragment && last && !last.fragment && last.command === row[2]) last.after = values;
    else events.push({ command: row[2], fragment, before, after: values });
  }
  return events;
}

/** As `gw pixel` prints it. Picture coordinates. */
export async function pixelHistory(report: Report, x: number, y: number): Promise<PixelEvent[]> {
  const row = report.height - 1 - y;
  const side = report.tile;
  const tile = await tileNamed(`${Math.floor(x / side)}_${Math.floor(row / side)}`);
  return eventsOf(tile, (row % side) * tile.width + (x % side));
}

/** The call of the program that made the event; empty if it is unknown. */
export function callOf(report: Report, event: PixelEvent, first: number): string {
  const place = Math.max(event.fragment?.polygon ?? 0, 0);
  const run = (report.calls[event.command - first] ?? []).findLast((r) => r[0] <= place);
  if (!run) return '';
  const [begin, before, number, step, after, primitive, ordinal] = run;
  const named = `${before}${number + step * (place - begin)}${after}`;
  return event.fragment && primitive ? `${named}, ${primitive} ${ordinal + place - begin}` : named;
}

export interface ColorMap extends MapChange {
  readonly entries: ReadonlyMap<number, number>;
}

/** The maps of a report, whole. */
export function mapsOf(report: Report): ColorMap[] {
  const maps: ColorMap[] = [];
  for (const map of report.maps ?? []) {
    const last = maps.at(-1);
    const known = [...(last?.entries ?? [])].filter(([index]) => index < 2 ** last!.bits);
    maps.push({ ...map, entries: new Map([...known, ...map.changes]) });
  }
  return maps;
}

export const mapOf = (maps: readonly ColorMap[], pass: Pass): ColorMap | undefined =>
  pass.map === undefined ? undefined : maps[pass.map];

export function indexOf(map: ColorMap, [r, g]: readonly number[]): number {
  const inR = 2 ** map.bits_in_r - 1;
  return ((r! & inR) | (g! << map.bits_in_r)) & (2 ** map.bits - 1);
}

/** R, G, B of an index, 0 to 255; undefined: what is below shows. */
export function entryOf(map: ColorMap, index: number): readonly number[] | undefined {
  if (index === 0 && map.planes !== 'window') return undefined;
  const rgb = map.entries.get(index) ?? 0;
  return [rgb & 255, (rgb >> 8) & 255, (rgb >> 16) & 255];
}
