// The state of the exhibit of the item buffer and rays in the address.
import type { Point } from '../model/steps/log';

export type Corner = readonly [number, number];
export interface RaysState {
  /** Rays in a path, the one from the eye counted. */
  depth: number;
  show: string;
  /** The pixel's ray is that of the ordinary ray tracer. */
  ordinary: boolean;
  /** From where the rays are seen; none: from outside. */
  from: Point | undefined;
  /** Which part below the pictures is open: 'cast', 'inside', both or none. */
  open: string[];
  method: string;
  inside: string;
  polygon: Corner[];
}

export const mostDepth = 10;
export const shows = ['picture', 'identifiers', 'traced', 'reasons'] as const;
export const methods = ['brute-force', 'volumes', 'hierarchy', 'grid'] as const;
export const insideTests = ['crossings', 'products', 'angles'] as const;
/** Columns and rows of the pixels for which the inside tests are made. */
export const cells = { columns: 24, rows: 18 };
export const polygons: Readonly<Record<'convex' | 'concave' | 'star', Corner[]>> = {
  convex: [
    [3, 4],
    [16, 2],
    [21, 10],
    [12, 16],
    [4, 12],
  ],
  concave: [
    [3, 2],
    [21, 3],
    [20, 15],
    [12, 6],
    [4, 16],
  ],
  star: [
    [5, 1.5],
    [12, 17],
    [19, 1.5],
    [2, 11],
    [22, 11],
  ],
};

export function putRays(parts: URLSearchParams, state: RaysState): void {
  if (state.depth !== 2) parts.set('depth', String(state.depth));
  if (state.show !== 'picture') parts.set('show', state.show);
  if (state.ordinary) parts.set('ray', 'ordinary');
  if (state.from) parts.set('from', state.from.join(','));
  if (state.open.length > 0) parts.set('open', state.open.join(','));
  if (state.method !== 'grid') parts.set('method', state.method);
  if (state.inside !== 'crossings') parts.set('inside', state.inside);
  const polygon = state.polygon.flat().join(',');
  if (polygon !== polygons.star.flat().join(',')) parts.set('polygon', polygon);
}

function polygonFrom(text: string | null): Corner[] {
  const values = text?.split(',').map(Number) ?? [];
  if (values.length < 6 || values.length > 24 || values.length % 2 > 0) return polygons.star;
  if (!values.every((v) => Number.isFinite(v) && Math.abs(v) < 100)) return polygons.star;
  return values.flatMap((x, i): Corner[] => (i % 2 === 0 ? [[x, values[i + 1]!]] : []));
}

export function raysFrom(parts: URLSearchParams): RaysState {
  const depth = Number(parts.get('depth') ?? 2);
  const from = parts.get('from')?.split(',').map(Number) ?? [];
  const known = (name: string, words: readonly string[], otherwise: string): string =>
    words.find((word) => word === parts.get(name)) ?? otherwise;
  return {
    depth: Number.isInteger(depth) ? Math.min(mostDepth, Math.max(1, depth)) : 2,
    show: known('show', shows, 'picture'),
    ordinary: parts.get('ray') === 'ordinary',
    from: from.length === 3 && from.every(Number.isFinite) ? (from as unknown as Point) : undefined,
    open: (parts.get('open') ?? '').split(',').filter((w) => w === 'cast' || w === 'inside'),
    method: known('method', methods, 'grid'),
    inside: known('inside', insideTests, 'crossings'),
    polygon: polygonFrom(parts.get('polygon')),
  };
}
