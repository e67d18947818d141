// Questions as the command and the engine write them (hiddensurface/quiz/quiz_data.h), and what an
// answer is worth.
import type { Text } from '../words/language';

export interface Question {
  readonly kind: string;
  readonly title: Text;
  readonly text: Text;
  /** a, b, c, ...; none: the answer is a number or numbers. */
  readonly choices: readonly Text[];
  /** The answer is some of the numbers 1 to this; 0: it is not. */
  readonly among: number;
  /** "b", "3", "1 4 6". */
  readonly answer: string;
  readonly why: Text;
  /** SVG. */
  readonly drawing: string;
  /** What the drawing says. */
  readonly spoken: Text;
  /** Name, x, y, Z. */
  readonly corners: readonly (readonly [string, number, number, number])[];
  readonly algorithm: string;
  /** The one that decides. */
  readonly step: number;
  readonly pixel?: readonly [number, number];
}

export const readQuestions = (json: string): Question[] => JSON.parse(json) as Question[];

/** Names of the choices. */
export const letter = (place: number): string => String.fromCharCode(97 + place);

/** The numbers that are ticked, as an answer. */
export const numbersOf = (ticked: readonly boolean[]): string =>
  ticked.flatMap((is, place) => (is ? [place + 1] : [])).join(' ');

/** Full-width digits are digits too. */
export const isRight = (question: Question, given: string): boolean =>
  given.normalize('NFKC').trim().toLowerCase() === question.answer;

export const pictureOf = (question: Question): string =>
  `data:image/svg+xml,${encodeURIComponent(question.drawing)}`;
