// A film as it stands in the page, and the numbers that a text takes from it.
import type { FilmFigure } from './films';
import type { StepName } from './markup';

export type FilmValues = Readonly<Record<string, number>>;

export interface Film {
  readonly frames: readonly {
    /** A PNG in base 64. */
    readonly picture: string;
    readonly values: FilmValues;
  }[];
}

/** Which frame is named; -1: none. */
export const frameOf = (figure: FilmFigure, name: StepName): number =>
  name.test === 'show' ? figure.frames.findIndex(({ id }) => id === name.result) : -1;

/** Numbers below 1 are shares of all: in percent. */
const asText = (value: number): string =>
  Number.isInteger(value) ? String(value) : (value < 1 ? 100 * value : value).toFixed(1);

/** A number of a frame; undefined: there is none. */
export function filmNumber(
  figure: FilmFigure,
  film: Film,
  position: number,
  name: string,
  at?: StepName,
): string | undefined {
  const value = film.frames[at ? frameOf(figure, at) : position]?.values[name];
  return value === undefined ? undefined : asText(value);
}
