// The state of the exhibit of radiosity in the address.
import type { LightChange } from './machine/protocol';

export const changesOf = ['Kd', 'dim', 'move'] as const satisfies LightChange['what'][];

export interface RadiosityState {
  /** Pixels across. */
  hemicube: number;
  shots: number;
  changes: LightChange[];
  /** Whether the changed scene is also solved from the beginning. */
  anew: boolean;
  /** Stops. */
  exposure: number;
  ambient: boolean;
  /** The point of the shooting patch whose hemicube is shown. */
  point: number;
}

export const hemicubes = [32, 64, 128, 256];
export const mostShots = 10000;
export const unlit = (): RadiosityState => ({
  hemicube: 64,
  shots: 1,
  changes: [],
  anew: false,
  exposure: 0,
  ambient: true,
  point: 0,
});

export function putRadiosity(parts: URLSearchParams, state: RadiosityState): void {
  parts.set('hemicube', String(state.hemicube));
  parts.set('shots', String(state.shots));
  for (const { after, object, what, value } of state.changes)
    parts.append('change', `${after}:${object}:${what}:${value.join(',')}`);
  if (state.anew) parts.set('anew', '1');
  if (state.exposure !== 0) parts.set('exposure', String(state.exposure));
  if (!state.ambient) parts.set('ambient', '0');
  if (state.point > 0) parts.set('point', String(state.point));
}

function changeFrom(text: string): LightChange[] {
  const found = /^(\d+):(.+):(Kd|dim|move):([^:]+)$/.exec(text);
  const value = found?.[4]!.split(',').map(Number) ?? [];
  if (!found || value.length !== 3 || !value.every(Number.isFinite)) return [];
  const what = changesOf.find((word) => word === found[3])!;
  return [{ after: Number(found[1]), object: found[2]!, what, value }];
}

export function radiosityFrom(parts: URLSearchParams): RadiosityState {
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
    anew: parts.get('anew') === '1',
    exposure: Math.abs(exposure) <= 8 ? exposure : 0,
    ambient: parts.get('ambient') !== '0',
    point: whole('point', 0),
  };
}
