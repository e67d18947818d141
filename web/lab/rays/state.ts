// The state of the exhibit of the item buffer and rays in the address.
import { clamped } from '../../model/numbers';
import { known, pointFrom } from '../../model/settings';
import type { Point } from '../../model/point';
import type { ExhibitState } from '../exhibit/exhibit';

export type Corner = readonly [number, number];
export interface RaysState {
  /** Rays in a path, the one from the eye counted. */
  depth: number;
  show: string;
  /** The pixel's ray is that of the ordinary ray tracer. */
  ordinary: boolean;
  /** From where the rays are seen; none: from outside. */
  from: Point | undefined;
  /** Which parts below the pictures are open. */
  open: string[];
  /** What the sweep varies. */
  sweep: string;
  method: string;
  inside: string;
  polygon: Corner[];
}

export const mostDepth = 10;
export const openParts = ['sweep', 'cast', 'inside'];
export const sweeps = ['lights', 'samples', 'share', 'polygons', 'resolution', 'depth'] as const;
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

function polygonFrom(text: string | null): Corner[] {
  const values = text?.split(',').map(Number) ?? [];
  if (values.length < 6 || values.length > 24 || values.length % 2 > 0) return polygons.star;
  if (!values.every((v) => Number.isFinite(v) && Math.abs(v) < 100)) return polygons.star;
  return values.flatMap((x, i): Corner[] => (i % 2 === 0 ? [[x, values[i + 1]!]] : []));
}

export const raysState: ExhibitState<RaysState> = {
  from(parts) {
    const depth = Number(parts.get('depth') ?? 2);
    return {
      depth: Number.isInteger(depth) ? clamped(depth, 1, mostDepth) : 2,
      show: known(parts.get('show'), shows),
      ordinary: parts.get('ray') === 'ordinary',
      from: pointFrom(parts.get('from')),
      open: (parts.get('open') ?? '').split(',').filter((w) => openParts.includes(w)),
      sweep: known(parts.get('sweep'), sweeps),
      method: known(parts.get('method'), methods, 'grid'),
      inside: known(parts.get('inside'), insideTests),
      polygon: polygonFrom(parts.get('polygon')),
    };
  },
  put(parts, choices) {
    if (choices.depth !== 2) parts.set('depth', String(choices.depth));
    if (choices.show !== 'picture') parts.set('show', choices.show);
    if (choices.ordinary) parts.set('ray', 'ordinary');
    if (choices.from) parts.set('from', choices.from.join(','));
    if (choices.open.length > 0) parts.set('open', choices.open.join(','));
    if (choices.sweep !== 'lights') parts.set('sweep', choices.sweep);
    if (choices.method !== 'grid') parts.set('method', choices.method);
    if (choices.inside !== 'crossings') parts.set('inside', choices.inside);
    const polygon = choices.polygon.flat().join(',');
    if (polygon !== polygons.star.flat().join(',')) parts.set('polygon', polygon);
  },
  forget(choices) {
    choices.from = undefined;
  },
};
