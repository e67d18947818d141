// The state of the exhibit of one pixel in the address: the triangle's corners and how it is drawn.
import { known, numbersFrom } from '../../model/settings';
import { profiles } from '../exhibit/lab_state';
import type { ExhibitState } from '../exhibit/exhibit';

export interface Corner {
  /** Sub-pixels: from the left, from the bottom. */
  x: number;
  y: number;
  /** 0 .. 1. */
  z: number;
  w: number;
  /** "#rrggbb", and 0 .. 1. */
  color: string;
  alpha: number;
  s: number;
  t: number;
}

export interface PixelState {
  /** The pixel of the grid that is explained; row 0 is at the bottom. */
  at: [number, number];
  corners: Corner[];
  filter: string;
  env: string;
  blend: string;
  background: string;
}

export const filters = ['none', 'nearest', 'linear'];
export const environments = ['modulate', 'replace', 'decal', 'blend'];
export const blends = ['none', 'add', 'over', 'modulate'];
/** Pixels of the window. */
export const grid = { width: 16, height: 12 };

/** The corners of the profile's grid: (13.5, 1.25), (3.25, 10.5), (1.5, 2.375) pixels. */
const first = (unit: number): Corner[] => [
  { x: 13.5 * unit, y: 1.25 * unit, z: 0.2, w: 1, color: '#ff2010', alpha: 1, s: 1, t: 0 },
  { x: 6.25 * unit, y: 10.5 * unit, z: 0.8, w: 2, color: '#20e040', alpha: 0.5, s: 0, t: 1 },
  { x: 1.5 * unit, y: 2.375 * unit, z: 0.5, w: 1, color: '#3050ff', alpha: 0.75, s: 0, t: 0 },
];

export const unitOf = (profile: string): number => (profile === 'ideal' ? 256 : 8);

export const firstChoices = (profile: string): Omit<PixelState, 'at'> => ({
  corners: first(unitOf(profile)),
  filter: 'linear',
  env: 'modulate',
  blend: 'over',
  background: '#203040',
});

const cornerText = (c: Corner): string =>
  [c.x, c.y, c.z, c.w, c.color.slice(1), c.alpha, c.s, c.t].join(',');

const isColor = (word: string | undefined): boolean => /^[0-9a-f]{6}$/.test(word ?? '');

function cornerFrom(text: string): Corner | undefined {
  const words = text.split(',');
  const [x, y, z, w, , alpha, s, t] = words.map(Number) as number[] & { length: 8 };
  if (words.length !== 8 || !isColor(words[4])) return undefined;
  if (![x, y, z, w, alpha, s, t].every(Number.isFinite) || !(w! > 0)) return undefined;
  return { x: x!, y: y!, z: z!, w: w!, color: `#${words[4]}`, alpha: alpha!, s: s!, t: t! };
}

function pixelFrom(text: string | null): [number, number] {
  const [x, y] = numbersFrom(text);
  const isInside =
    x !== undefined && y !== undefined && x >= 0 && y >= 0 && x < grid.width && y < grid.height;
  return isInside ? [Math.floor(x), Math.floor(y)] : [6, 4];
}

export const pixelState: ExhibitState<PixelState> = {
  from(parts) {
    const otherwise = firstChoices(known(parts.get('profile'), profiles));
    const corners = (parts.get('corners') ?? '').split(';').map(cornerFrom);
    const background = parts.get('background') ?? '';
    return {
      at: pixelFrom(parts.get('at')),
      corners:
        corners.length === 3 && corners.every((c) => c !== undefined) ? corners : otherwise.corners,
      filter: known(parts.get('filter'), filters, otherwise.filter),
      env: known(parts.get('env'), environments, otherwise.env),
      blend: known(parts.get('blend'), blends, otherwise.blend),
      background: isColor(background) ? `#${background}` : otherwise.background,
    };
  },
  put(parts, choices) {
    parts.set('at', choices.at.join(','));
    parts.set('corners', choices.corners.map(cornerText).join(';'));
    parts.set('filter', choices.filter);
    parts.set('env', choices.env);
    parts.set('blend', choices.blend);
    parts.set('background', choices.background.slice(1));
  },
};
