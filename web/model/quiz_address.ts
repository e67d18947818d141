// The state of a quiz's page in its address: the question that is shown, and the settings.
import type { PageState } from './address';
import { clamped } from './numbers';
import { addressOf, putSettings, settingsFrom, type Settings } from './settings';

export interface QuizState {
  /** 1 first. */
  number: number;
  page: PageState;
}

export function toQuizAddress({ number, page }: QuizState, defaults: Settings): string {
  const parts = new URLSearchParams({ question: String(number) });
  putSettings(parts, page, defaults);
  return addressOf(parts);
}

export function fromQuizAddress(hash: string, defaults: Settings, count: number): QuizState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const number = Math.trunc(Number(parts.get('question'))) || 1;
  return {
    number: clamped(number, 1, count),
    page: {
      ...settingsFrom(parts, defaults),
      steps: [],
      views: [],
      pixel: undefined,
      labels: true,
      outlines: true,
    },
  };
}
