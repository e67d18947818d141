// The settings of all pages, and their place in the address. Does not touch the page:
// PageHeader.svelte does.
import { languageFor, languages, type Language } from '../words/language';
import type { Palette } from './palette';

export interface Settings {
  language: Language;
  dark: boolean;
  projector: boolean;
  palette: Palette;
}

/** The settings of a page that was opened without any, by a reader with these preferences. */
export function defaultSettings(language: string, dark: boolean): Settings {
  return {
    language: languageFor(language),
    dark,
    projector: false,
    palette: 'scene',
  };
}

export function putSettings(parts: URLSearchParams, settings: Settings, defaults: Settings): void {
  parts.set('lang', settings.language);
  if (settings.dark !== defaults.dark) parts.set('theme', settings.dark ? 'dark' : 'light');
  if (settings.projector) parts.set('projector', '1');
  if (settings.palette !== 'scene') parts.set('colors', settings.palette);
}

export function settingsFrom(parts: URLSearchParams, defaults: Settings): Settings {
  const lang = parts.get('lang');
  return {
    language: lang && languages.has(lang) ? lang : defaults.language,
    dark: parts.has('theme') ? parts.get('theme') === 'dark' : defaults.dark,
    projector: parts.get('projector') === '1',
    palette: parts.get('colors') === 'distinct' ? 'distinct' : 'scene',
  };
}

/** "12,7" as numbers; others are left out. */
export const numbersFrom = (text: string | null): number[] =>
  (text ?? '')
    .split(',')
    .filter((part) => part !== '')
    .map(Number)
    .filter(Number.isFinite);

export function pixelFrom(parts: URLSearchParams): [number, number] | undefined {
  const [x, y, ...rest] = numbersFrom(parts.get('pixel'));
  return x !== undefined && y !== undefined && rest.length === 0 ? [x, y] : undefined;
}

/** As people read it: commas stay commas. */
export const addressOf = (parts: URLSearchParams): string =>
  `#${parts.toString().replaceAll('%2C', ',')}`;

/** The word if it is one of these, else the first of them or `otherwise`. */
export const known = <Word extends string>(
  word: string | null,
  words: readonly Word[],
  otherwise: Word = words[0]!,
): Word => words.find((one) => one === word) ?? otherwise;

/** "1,2,3" as a point in space. */
export function pointFrom(text: string | null): [number, number, number] | undefined {
  const [x, y, z, ...rest] = (text ?? '').split(',').map(Number);
  const all = [x, y, z] as [number, number, number];
  return rest.length === 0 && all.every(Number.isFinite) ? all : undefined;
}
