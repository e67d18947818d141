// The lab's state in the address: the page's own, what the machine is asked for, and the choices of the
// exhibit that is shown.
import { fromAddress, toAddress, type PageState } from '../model/address';
import type { Eye } from '../model/orbit';
import type { Point } from '../model/steps/log';
import { known, pointFrom, type Settings } from '../model/settings';
import type { Exhibit } from './exhibit';
import type { SceneFacts, View } from './machine/protocol';

export interface LabState {
  exhibit: string;
  scene: string;
  size: string;
  profile: string;
  /** None: the scene's. */
  eye: Point | undefined;
  /** Of each exhibit, by its id. */
  choices: Record<string, unknown>;
  page: PageState;
}

export const sizes = ['64x48', '128x96', '160x120', '320x240', '640x480'];
export const profiles = ['vgx', 'reality', 'ideal'];

export function sizeOf(state: LabState): { width: number; height: number } {
  const [width, height] = state.size.split('x').map(Number);
  return { width: width ?? 320, height: height ?? 240 };
}

export const eyeOf = (state: LabState, scene: SceneFacts): Eye => ({
  eye: state.eye ?? scene.eye,
  at: scene.at,
  up: scene.up,
});

/** Another one for another scene, too. */
export function viewOf(state: LabState, scene: SceneFacts): View {
  const eye = state.eye && { eye: [...state.eye], at: [...scene.at], up: [...scene.up] };
  return { ...sizeOf(state), profile: state.profile, ...eye };
}

/** The state has the choices of the exhibit that it names. */
export function toLabAddress(
  state: LabState,
  defaults: Settings,
  exhibits: readonly Exhibit[],
): string {
  const parts = new URLSearchParams();
  parts.set('exhibit', state.exhibit);
  parts.set('scene', state.scene);
  parts.set('size', state.size);
  parts.set('profile', state.profile);
  if (state.eye) parts.set('eye', state.eye.join(','));
  const exhibit = exhibits.find(({ id }) => id === state.exhibit)!;
  exhibit.state.put(parts, state.choices[exhibit.id]);
  const lab = parts.toString().replaceAll('%2C', ',').replaceAll('%2F', '/').replaceAll('%3B', ';');
  return `#${lab}&${toAddress(state.page, defaults).slice(1)}`;
}

export function fromLabAddress(
  hash: string,
  defaults: Settings,
  exhibits: readonly Exhibit[],
): LabState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const exhibit = exhibits.find(({ id }) => id === parts.get('exhibit')) ?? exhibits[0]!;
  return {
    exhibit: exhibit.id,
    scene: parts.get('scene') ?? exhibit.firstScene,
    size: known(parts.get('size'), sizes, '320x240'),
    profile: known(parts.get('profile'), profiles),
    eye: pointFrom(parts.get('eye')),
    choices: Object.fromEntries(exhibits.map(({ id, state }) => [id, state.from(parts)])),
    page: fromAddress(hash, defaults),
  };
}
