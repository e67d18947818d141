// The input of the views: a replay at a position, with the settings of the page. Views do not
// change it.
import type { Step, Window } from './log';
import type { Language } from '../../words/language';
import type { Replay } from './replay';
import type { Words } from '../../words/en';

export interface Frame {
  readonly replay: Replay;
  /** Steps done. */
  readonly position: number;
  readonly step: Step | undefined;
  readonly colors: ReadonlyMap<number, string>;
  readonly words: Words;
  readonly language: Language;
  /** The pixel that is followed. */
  readonly pixel: readonly [number, number] | undefined;
  readonly labels: boolean;
  readonly outlines: boolean;
  /** Pixels of the screen: width of lines, size of letters. */
  readonly stroke: number;
  readonly letters: number;
  /** Width and height of the second view. */
  readonly room: readonly [number, number];
}

/** The row that the row views show: the step's, the followed pixel's, or the middle one. */
export function rowOf(frame: Frame): number {
  if (frame.step?.window) return frame.step.window[1];
  if (frame.pixel) return frame.pixel[1];
  return Math.floor(frame.replay.height / 2);
}

export function centerOf(window: Window): [number, number] {
  return [Math.floor(window[0] + (window[2] - 1) / 2), Math.floor(window[1] + (window[3] - 1) / 2)];
}

/** The pixel that the magnifier shows. */
export function pixelOf(frame: Frame): [number, number] {
  const painted = frame.step?.painted?.[0];
  if (frame.pixel) return [...frame.pixel];
  if (frame.step?.window) return centerOf(frame.step.window);
  if (painted) return [painted[1], painted[0]];
  return [Math.floor(frame.replay.width / 2), Math.floor(frame.replay.height / 2)];
}
