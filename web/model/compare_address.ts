// The state of the page of a comparison in the address, "#show=newell,bsp&plane=difference".
import { addressOf, pixelFrom, putSettings, settingsFrom, type Settings } from './settings';

export const comparePlanes = ['picture', 'difference', 'writes', 'all'] as const;
export type ComparePlane = (typeof comparePlanes)[number];

export interface CompareState extends Settings {
  /** Names of algorithms; empty: the page chooses. */
  show: string[];
  plane: ComparePlane;
  /** The counter that sorts the table. */
  sort: string | undefined;
  descending: boolean;
  /** The algorithm that fills the page. */
  large: string | undefined;
  pixel: [number, number] | undefined;
}

export function toAddress(state: CompareState, defaults: Settings): string {
  const parts = new URLSearchParams();
  parts.set('show', state.show.join(','));
  parts.set('plane', state.plane);
  if (state.sort !== undefined) parts.set('sort', (state.descending ? '-' : '') + state.sort);
  if (state.large !== undefined) parts.set('large', state.large);
  if (state.pixel) parts.set('pixel', state.pixel.join(','));
  putSettings(parts, state, defaults);
  return addressOf(parts);
}

export function fromAddress(hash: string, defaults: Settings): CompareState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const sort = parts.get('sort') ?? undefined;
  return {
    ...settingsFrom(parts, defaults),
    show: (parts.get('show') ?? '').split(',').filter((name) => name !== ''),
    plane: comparePlanes.find((plane) => plane === parts.get('plane')) ?? 'picture',
    sort: sort?.replace(/^-/, ''),
    descending: sort?.startsWith('-') ?? false,
    large: parts.get('large') ?? undefined,
    pixel: pixelFrom(parts),
  };
}
