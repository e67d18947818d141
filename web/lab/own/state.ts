// The state of the exhibit of the visitor's algorithm in the address, and what it asks the engine.
import type { ExhibitState } from '../exhibit/exhibit';
import type { Graded } from '../hidden/state';
import type { Language } from './program';

declare module '../machine/protocol' {
  interface Methods {
    polygons(options: View): { readonly text: string };
    play(options: View & { readonly steps: string }): Graded;
  }
}

export interface OwnState {
  /** The visitor's program, packed; '': the example. */
  code: string;
  language: Language;
}

export const ownState: ExhibitState<OwnState> = {
  from: (parts) => ({
    code: parts.get('code') ?? '',
    language: parts.get('language') === 'python' ? 'python' : 'javascript',
  }),
  put(parts, { code, language }) {
    if (language !== 'javascript') parts.set('language', language);
    if (code) parts.set('code', code);
  },
};
