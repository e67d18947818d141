// The state of a report's page in the address, "#pass=3&plane=stencil".
import { planeNames, type PlaneName } from './report';
import { addressOf, pixelFrom, putSettings, settingsFrom, type Settings } from './settings';

export interface ReportState extends Settings {
  /** Its number; undefined: the page chooses. */
  pass: number | undefined;
  plane: PlaneName | undefined;
  pixel: [number, number] | undefined;
}

export function toAddress(state: ReportState, defaults: Settings): string {
  const parts = new URLSearchParams();
  if (state.pass !== undefined) parts.set('pass', String(state.pass));
  if (state.plane !== undefined) parts.set('plane', state.plane);
  putSettings(parts, state, defaults);
  if (state.pixel) parts.set('pixel', state.pixel.join(','));
  return addressOf(parts);
}

export function fromAddress(hash: string, defaults: Settings): ReportState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const pass = Number(parts.get('pass') ?? NaN);
  return {
    ...settingsFrom(parts, defaults),
    pass: Number.isInteger(pass) ? pass : undefined,
    plane: planeNames.find((plane) => plane === parts.get('plane')),
    pixel: pixelFrom(parts),
  };
}
