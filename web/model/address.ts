// The player's state in the address, "#step=12&view=top": a link opens the same page.
import {
  addressOf,
  numbersFrom,
  pixelFrom,
  putSettings,
  settingsFrom,
  type Settings,
} from './settings';

export interface PageState extends Settings {
  /** Steps done, one for each log. */
  steps: number[];
  views: string[];
  pixel: [number, number] | undefined;
  labels: boolean;
  outlines: boolean;
}

export function toAddress(state: PageState, defaults: Settings): string {
  const parts = new URLSearchParams();
  parts.set('step', state.steps.join(','));
  parts.set('view', state.views.join(','));
  if (state.pixel) parts.set('pixel', state.pixel.join(','));
  putSettings(parts, state, defaults);
  if (!state.labels) parts.set('names', '0');
  if (!state.outlines) parts.set('outlines', '0');
  return addressOf(parts);
}

export function fromAddress(hash: string, defaults: Settings): PageState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  return {
    ...settingsFrom(parts, defaults),
    steps: numbersFrom(parts.get('step')),
    views: (parts.get('view') ?? '').split(',').filter((view) => view !== ''),
    pixel: pixelFrom(parts),
    labels: parts.get('names') !== '0',
    outlines: parts.get('outlines') !== '0',
  };
}
