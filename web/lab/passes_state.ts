// The state of the exhibit of passes in the address.
import type { Point } from '../model/steps/log';

export interface PassesState {
  samples: number;
  shadow: string;
  translucency: string;
  /** The visitor's list, packed; '': the scene's. */
  list: string;
  /** From where the shadow volumes are seen; none: from outside. */
  from: Point | undefined;
}

export const mostSamples = 16;
/** Of the lights that cast any; '': as the scene has it. */
export const shadows = ['', 'volume', 'map', 'none'];
export const translucencies = ['sorted', 'unsorted', 'layers'];

export function putPasses(parts: URLSearchParams, state: PassesState): void {
  if (state.samples !== 1) parts.set('samples', String(state.samples));
  if (state.shadow) parts.set('shadow', state.shadow);
  if (state.translucency !== 'sorted') parts.set('translucency', state.translucency);
  if (state.list) parts.set('list', state.list);
  if (state.from) parts.set('from', state.from.join(','));
}

export function passesFrom(parts: URLSearchParams): PassesState {
  const samples = Number(parts.get('samples') ?? 1);
  const from = parts.get('from')?.split(',').map(Number) ?? [];
  const known = (word: string | null, words: readonly string[]): string =>
    word !== null && words.includes(word) ? word : words[0]!;
  return {
    samples: Number.isInteger(samples) ? Math.min(mostSamples, Math.max(1, samples)) : 1,
    shadow: known(parts.get('shadow'), shadows),
    translucency: known(parts.get('translucency'), translucencies),
    list: parts.get('list') ?? '',
    from: from.length === 3 && from.every(Number.isFinite) ? (from as unknown as Point) : undefined,
  };
}
