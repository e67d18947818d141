// The state of the exhibit of passes in the address.
import { clamped } from '../../model/numbers';
import { known, pointFrom } from '../../model/settings';
import type { Point } from '../../model/point';
import type { ExhibitState } from '../exhibit/exhibit';

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

export const passesState: ExhibitState<PassesState> = {
  from(parts) {
    const samples = Number(parts.get('samples') ?? 1);
    return {
      samples: Number.isInteger(samples) ? clamped(samples, 1, mostSamples) : 1,
      shadow: known(parts.get('shadow'), shadows),
      translucency: known(parts.get('translucency'), translucencies),
      list: parts.get('list') ?? '',
      from: pointFrom(parts.get('from')),
    };
  },
  put(parts, choices) {
    if (choices.samples !== 1) parts.set('samples', String(choices.samples));
    if (choices.shadow) parts.set('shadow', choices.shadow);
    if (choices.translucency !== 'sorted') parts.set('translucency', choices.translucency);
    if (choices.list) parts.set('list', choices.list);
    if (choices.from) parts.set('from', choices.from.join(','));
  },
  forget(choices) {
    choices.from = undefined;
  },
};
