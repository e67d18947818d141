// The lab's state in the address: the page's own, and what the machine is asked for.
import { fromAddress, toAddress, type PageState } from '../model/address';
import type { Point } from '../model/steps/log';
import { numbersFrom, type Settings } from '../model/settings';
import { grid, pixelChoicesFrom, putPixel, type PixelChoices } from './pixel_state';
import { putRadiosity, radiosityFrom, type RadiosityState } from './radiosity_state';
import { passesFrom, putPasses, type PassesState } from './passes_state';
import { putRays, raysFrom, type RaysState } from './rays_state';

export interface LabState {
  exhibit: string;
  scene: string;
  /** One or two. */
  algorithms: string[];
  level: string;
  size: string;
  profile: string;
  /** None: the scene's. */
  eye: Point | undefined;
  /** The visitor's program, packed; '': the example. */
  code: string;
  passes: PassesState;
  pixel: PixelChoices;
  /** The pixel of the grid that is explained; row 0 is at the bottom. */
  pixelAt: [number, number];
  radiosity: RadiosityState;
  rays: RaysState;
  page: PageState;
}

/** The scene that an exhibit begins with. */
export const firstScene = (exhibit: string): string =>
  exhibit === 'radiosity'
    ? 'radiosity/cornell.toml'
    : exhibit === 'rays'
      ? 'fig9.toml'
      : exhibit === 'passes' || exhibit === 'pixel'
        ? 'rings.toml'
        : 'hidden/cycle.toml';

export const sizes = ['64x48', '128x96', '160x120', '320x240', '640x480'];
export const profiles = ['vgx', 'reality', 'ideal'];
export const levels = ['polygon', 'line', 'span', 'pixel'];

export function sizeOf(state: LabState): { width: number; height: number } {
  const [width, height] = state.size.split('x').map(Number);
  return { width: width ?? 320, height: height ?? 240 };
}

export function toLabAddress(state: LabState, defaults: Settings): string {
  const parts = new URLSearchParams();
  parts.set('exhibit', state.exhibit);
  parts.set('scene', state.scene);
  parts.set('algorithm', state.algorithms.join(','));
  parts.set('size', state.size);
  parts.set('profile', state.profile);
  parts.set('level', state.level);
  if (state.eye) parts.set('eye', state.eye.join(','));
  if (state.exhibit === 'own' && state.code) parts.set('code', state.code);
  if (state.exhibit === 'passes') putPasses(parts, state.passes);
  if (state.exhibit === 'pixel') {
    parts.set('at', state.pixelAt.join(','));
    putPixel(parts, state.pixel);
  }
  if (state.exhibit === 'rays') putRays(parts, state.rays);
  if (state.exhibit === 'radiosity') putRadiosity(parts, state.radiosity);
  const lab = parts.toString().replaceAll('%2C', ',').replaceAll('%2F', '/').replaceAll('%3B', ';');
  return `#${lab}&${toAddress(state.page, defaults).slice(1)}`;
}

const oneOf = (word: string | null, known: readonly string[], otherwise: string): string =>
  word !== null && known.includes(word) ? word : otherwise;

export function fromLabAddress(
  hash: string,
  defaults: Settings,
  exhibits: readonly string[],
): LabState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const eye = parts.get('eye')?.split(',').map(Number) ?? [];
  const exhibit = oneOf(parts.get('exhibit'), exhibits, exhibits[0]!);
  const profile = oneOf(parts.get('profile'), profiles, 'vgx');
  const [x, y] = numbersFrom(parts.get('at'));
  const isInside =
    x !== undefined && y !== undefined && x >= 0 && y >= 0 && x < grid.width && y < grid.height;
  return {
    exhibit,
    scene: parts.get('scene') ?? firstScene(exhibit),
    algorithms: (parts.get('algorithm') ?? 'newell').split(',').slice(0, 2),
    level: oneOf(parts.get('level'), levels, 'polygon'),
    size: oneOf(parts.get('size'), sizes, '320x240'),
    profile,
    eye: eye.length === 3 && eye.every(Number.isFinite) ? (eye as unknown as Point) : undefined,
    code: parts.get('code') ?? '',
    passes: passesFrom(parts),
    pixel: pixelChoicesFrom(parts, profile),
    pixelAt: isInside ? [Math.floor(x), Math.floor(y)] : [6, 4],
    radiosity: radiosityFrom(parts),
    rays: raysFrom(parts),
    page: fromAddress(hash, defaults),
  };
}
