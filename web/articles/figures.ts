// What the figures of the articles show. A run is a log of `gw hidden --steps`, which stands in the
// page; a model is drawn and computed by the page (models/). Does not import the texts, because the
// build reads this table too.
import type { Level } from '../model/steps/log';

export type SecondView = 'top' | 'side' | 'row' | 'depth' | 'tree' | 'list' | 'windows';

export interface RunFigure {
  readonly scene: string;
  readonly algorithm: string;
  readonly size: string;
  readonly level?: Level;
  readonly view: SecondView;
  /** The step at which it opens, as in a text (markup.ts); none: the last one. */
  readonly at?: string;
  /** What it shows here; none: the algorithm's title. */
  readonly title?: string;
}

export const runs: Readonly<Record<string, RunFigure>> = {
  ring: { scene: 'ring', algorithm: 'back-face', size: '320x240', view: 'top', at: 'facing/back' },
  five: { scene: 'five', algorithm: 'z-buffer', size: '160x120', view: 'top' },
  centroid: {
    scene: 'centroid_fails',
    algorithm: 'painter-centroid',
    size: '160x120',
    view: 'top',
    at: 'distance/sorted',
  },
  wheel: { scene: 'pinwheel', algorithm: 'painter-farthest', size: '160x120', view: 'list' },
  tests: {
    scene: 'centroid_fails',
    algorithm: 'newell',
    size: '160x120',
    view: 'top',
    at: 'farthest-corner/sorted',
  },
  marks: {
    scene: 'pinwheel',
    algorithm: 'newell',
    size: '160x120',
    view: 'list',
    at: 'marks/cycle',
  },
  tree: { scene: 'cycle', algorithm: 'bsp', size: '160x120', view: 'tree', at: 'eye-side/front' },
  lines: {
    scene: 'five',
    algorithm: 'scan-line',
    size: '64x48',
    level: 'span',
    view: 'row',
    at: 'span/one-nearest',
  },
  zpixels: {
    scene: 'cycle',
    algorithm: 'z-buffer',
    size: '64x48',
    level: 'pixel',
    view: 'depth',
    at: 'z/not-nearer:3',
  },
  areas: {
    scene: 'five',
    algorithm: 'warnock',
    size: '64x48',
    view: 'windows',
    at: 'window/hidden',
  },
  clipped: {
    scene: 'cycle',
    algorithm: 'weiler-atherton',
    size: '160x120',
    view: 'top',
    at: 'split/outline',
  },
  sides_of_five: {
    scene: 'five',
    algorithm: 'appel',
    size: '160x120',
    view: 'top',
    at: 'carried/parts',
  },
  bodies: { scene: 'five', algorithm: 'roberts', size: '160x120', view: 'top' },
  cast: {
    scene: 'cycle',
    algorithm: 'ray-casting',
    size: '64x48',
    level: 'pixel',
    view: 'depth',
    at: 'ray/nearest',
  },
  culled: {
    scene: 'five',
    algorithm: 'back-face',
    size: '160x120',
    view: 'top',
    at: 'draw/piece',
    title: 'Drawn in the order of the file',
  },
};

/** Arguments of the command that writes a figure's log into a folder. */
export function argumentsOf(run: RunFigure, scenes: string, out: string): string[] {
  const scene = `${scenes}/hidden/${run.scene}.toml`;
  const level = run.level ?? 'polygon';
  const how = ['--algorithm', run.algorithm, '--size', run.size, '--level', level];
  return ['hidden', scene, ...how, '--quiet', '--steps', out];
}

/** The lab's address of the run, at a step. */
export function labAddress(run: RunFigure, step: number): string {
  const level = run.level ? `&level=${run.level}` : '';
  const what = `scene=hidden/${run.scene}.toml&algorithm=${run.algorithm}&size=${run.size}`;
  return `#exhibit=hidden&${what}${level}&step=${step}`;
}
