// The lab's state in the address: the page's own, what the machine is asked for, and the choices of
// the exhibit that is shown.
import { fromAddress, toAddress } from '../model/address';
import { known, pointFrom, type Settings } from '../model/settings';
import type { Exhibit } from './exhibit/exhibit';
import { profiles, sizes, type LabState } from './exhibit/lab_state';

/** The state has the choices of the exhibit that it names. */
export function toLabAddress(
  state: LabState,
  defaults: Settings,
  exhibits: readonly Exhibit[],
): string {
  const parts = new URLSearchParams();
  parts.set('exhibit', state.exhibit);
  parts.set('scene', state.scene);
  parts.set('size', state.size);
  parts.set('profile', state.profile);
  if (state.eye) parts.set('eye', state.eye.join(','));
  const exhibit = exhibits.find(({ id }) => id === state.exhibit)!;
  exhibit.state.put(parts, state.choices[exhibit.id]);
  const lab = parts.toString().replaceAll('%2C', ',').replaceAll('%2F', '/').replaceAll('%3B', ';');
  return `#${lab}&${toAddress(state.page, defaults).slice(1)}`;
}

export function fromLabAddress(
  hash: string,
  defaults: Settings,
  exhibits: readonly Exhibit[],
): LabState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const exhibit = exhibits.find(({ id }) => id === parts.get('exhibit')) ?? exhibits[0]!;
  exhibit.state.complete?.(parts);
  return {
    exhibit: exhibit.id,
    scene: parts.get('scene') ?? exhibit.firstScene,
    size: known(parts.get('size'), sizes, '320x240'),
    profile: known(parts.get('profile'), profiles),
    eye: pointFrom(parts.get('eye')),
    choices: Object.fromEntries(exhibits.map(({ id, state }) => [id, state.from(parts)])),
    page: fromAddress(hash, defaults),
  };
}
