// What all exhibits share: the scene, how it is drawn, and from where.
import type { PageState } from '../../model/address';
import type { Eye } from '../../model/orbit';
import type { Point } from '../../model/point';
import type { SceneFacts, View } from '../machine/protocol';

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
