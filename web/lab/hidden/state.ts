// The state of the exhibit of hidden surfaces in the address, and what it asks the engine.
import { known } from '../../model/settings';
import type { ExhibitState } from '../exhibit/exhibit';
import type { View } from '../machine/protocol';
import { stories } from '../../model/steps/stories';

export interface HiddenOptions extends View {
  readonly algorithm: string;
  readonly level: string;
  /** Seconds: an algorithm that would take longer is refused. */
  readonly limit?: number;
}

export interface Graded {
  /** The text of steps.jsonl. */
  readonly text: string;
  /** By pixel, the upper row first: equal, tie, edge, snapped, wrong. Empty for lines. */
  readonly difference: Uint8Array;
}

declare module '../machine/protocol' {
  interface Methods {
    hidden(options: HiddenOptions): Graded;
  }
}

export interface HiddenState {
  /** One or two. */
  algorithms: string[];
  level: string;
  /** The story that is told; '': none. */
  story: string;
}

/** A visit without an address begins with it. */
const firstStory = 'first';
const namesPicture = ['exhibit', 'scene', 'algorithm', 'step', 'story'];

export const levels = ['polygon', 'line', 'span', 'pixel'];

export const hiddenState: ExhibitState<HiddenState> = {
  from: (parts) => ({
    algorithms: (parts.get('algorithm') ?? 'newell').split(',').slice(0, 2),
    level: known(parts.get('level'), levels),
    story: namesPicture.some((name) => parts.has(name)) ? (parts.get('story') ?? '') : firstStory,
  }),
  /** A story that is named without a scene is told from its own picture. */
  complete(parts) {
    const story = stories.find(({ id }) => id === parts.get('story'));
    if (!story || parts.has('scene')) return;
    parts.set('scene', story.scene);
    parts.set('algorithm', story.algorithm);
    parts.set('level', story.level);
    if (!parts.has('size')) parts.set('size', story.size);
  },
  put(parts, choices) {
    parts.set('algorithm', choices.algorithms.join(','));
    parts.set('level', choices.level);
    if (choices.story) parts.set('story', choices.story);
  },
  forget(choices) {
    choices.story = '';
  },
};
