// The state of the exhibit of radiosity in the address.
import type { ExhibitState } from '../exhibit/exhibit';
import type { LightChange } from './protocol';

export const changesOf = ['Kd', 'dim', 'move'] as const satisfies LightChange['what'][];

export interface RadiosityState {
  /** Pixels across. */
  hemicube: number;
  shots: number;
  changes: LightChange[];
  /** Whether the changed scene is also solved from the beginning. */
  resolved: boolean;
  /** Stops. */
  exposure: number;
  ambient: boolean;
  /** The point of the shooting patch whose hemicube is shown. */
  point: number;
}

export const hemicubes = [32, 64, 128, 256];
export const mostShots = 10000;
const unlit = (): RadiosityState => ({
  hemicube: 64,
  shots: 1,
  changes: [],
  resolved: false,
  exposure: 0,
  ambient: true,
  point: 0,
});

function changeFrom(text: string): LightChange[] {
  const found = /^(\d+):(.+):(Kd|dim|move):([^:]+)$/.exec(text);
  const value = found?.[4]!.split(',').map(Number) ?? [];
  if (!found || value.length !== 3 || !value.every(Number.isFinite)) return [];
  const what = changesOf.find((word) => word === found[3])!;
  return [{ after: Number(found[1]), object: found[2]!, what, value }];
}

export const radiosityState: ExhibitState<RadiosityState> = {
  from(parts) {
    const none = unlit();
    const whole = (name: string, otherwise: number): number => {
      const value = Number(parts.get(name) ?? otherwise);
      return Number.isInteger(value) && value >= 0 ? Math.min(value, mostShots) : otherwise;
    };
    const exposure = Number(parts.get('exposure') ?? 0);
    const hemicube = whole('hemicube', none.hemicube);
    return {
      hemicube: hemicubes.includes(hemicube) ? hemicube : none.hemicube,
      shots: whole('shots', none.shots),
      changes: parts.getAll('change').flatMap(changeFrom),
      resolved: parts.get('anew') === '1',
      exposure: Math.abs(exposure) <= 8 ? exposure : 0,
      ambient: parts.get('ambient') !== '0',
      point: whole('point', 0),
    };
  },
  put(parts, choices) {
    parts.set('hemicube', String(choices.hemicube));
    parts.set('shots', String(choices.shots));
    for (const { after, object, what, value } of choices.changes)
      parts.append('change', `${after}:${object}:${what}:${value.join(',')}`);
    if (choices.resolved) parts.set('anew', '1');
    if (choices.exposure !== 0) parts.set('exposure', String(choices.exposure));
    if (!choices.ambient) parts.set('ambient', '0');
    if (choices.point > 0) parts.set('point', String(choices.point));
  },
  forget: (choices) => void Object.assign(choices, unlit()),
};
