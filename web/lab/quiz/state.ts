// The state of the exhibit of exercises in the address, and what it asks the engine.
import { attempt } from '../../model/learning_platform';
import type { ExhibitState } from '../exhibit/exhibit';

export interface AskedQuestion {
  readonly seed: number;
  /** 1 first. */
  readonly number: number;
  /** '': all kinds in turn. */
  readonly kind: string;
}

declare module '../machine/protocol' {
  interface Methods {
    quiz(question: AskedQuestion): { readonly text: string };
    quiz_steps(question: AskedQuestion): { readonly text: string };
  }
}

export interface QuizChoices {
  seed: number;
  number: number;
  kind: string;
}

export const questionCount = 7;
/** Of the quiz that a learning platform hears of. */
export const countedSeed = attempt?.address.get('seed') ?? null;
const mostSeed = 2147483647;
const whole = (text: string | null, most: number): number => {
  const value = Number(text);
  return Number.isInteger(value) && value >= 1 && value <= most ? value : 1;
};

export const quizState: ExhibitState<QuizChoices> = {
  from: (parts) => ({
    seed: whole(parts.get('seed') ?? countedSeed, mostSeed),
    number: whole(parts.get('question'), questionCount),
    kind: parts.get('kind') ?? '',
  }),
  put(parts, { seed, number, kind }) {
    parts.set('seed', String(seed));
    parts.set('question', String(number));
    if (kind) parts.set('kind', kind);
  },
};
