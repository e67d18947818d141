// The page's state in the address, "#step=12&view=top": a link opens the same page.
import type { Language } from './log';
import type { Palette } from './palette';

export interface PageState {
  /** Steps done, one for each log. */
  steps: number[];
  views: string[];
  pixel: [number, number] | undefined;
  language: Language;
  dark: boolean;
  projector: boolean;
  labels: boolean;
  outlines: boolean;
  palette: Palette;
}

const numbers = (text: string | null): number[] =>
  (text ?? '').split(',').map(Number).filter(Number.isFinite);

export function toAddress(state: PageState): string {
  const parts = new URLSearchParams();
  parts.set('step', state.steps.join(','));
  parts.set('view', state.views.join(','));
  if (state.pixel) parts.set('pixel', state.pixel.join(','));
  parts.set('lang', state.language);
  if (state.dark) parts.set('theme', 'dark');
  if (state.projector) parts.set('projector', '1');
  if (!state.labels) parts.set('names', '0');
  if (!state.outlines) parts.set('outlines', '0');
  if (state.palette !== 'scene') parts.set('colors', state.palette);
  return `#${parts.toString().replaceAll('%2C', ',')}`;
}

export function fromAddress(hash: string, language: Language): PageState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const pixel = parts.has('pixel') ? numbers(parts.get('pixel')) : [];
  const lang = parts.get('lang');
  return {
    steps: parts.get('step') ? numbers(parts.get('step')) : [],
    views: (parts.get('view') ?? '').split(',').filter((view) => view !== ''),
    pixel: pixel.length === 2 ? [pixel[0]!, pixel[1]!] : undefined,
    language: lang === 'ja' || lang === 'en' ? lang : language,
    dark: parts.get('theme') === 'dark',
    projector: parts.get('projector') === '1',
    labels: parts.get('names') !== '0',
    outlines: parts.get('outlines') !== '0',
    palette: parts.get('colors') === 'distinct' ? 'distinct' : 'scene',
  };
}
