// What a text names in a run: a step by its question and answer, a number by its name, a piece.
import type { Step } from '../model/steps/log';
import type { Replay } from '../model/steps/replay';
import { textOf } from '../model/steps/sentence';
import type { StepName } from './markup';

const isPart = (wanted: readonly string[], pieces: readonly string[] = []): boolean =>
  wanted.length === 0 || wanted.join() === pieces.slice(0, wanted.length).join();

/** How many steps are done after the step that is named; 0: there is none. */
export function placeOf(steps: readonly Step[], name: StepName): number {
  let left = name.nth;
  for (const [i, step] of steps.entries())
    if (step.test === name.test && step.result === name.result && isPart(name.pieces, step.pieces))
      if (--left === 0) return i + 1;
  return 0;
}

/** "corner.2": the third of a list. */
function valueOf(values: Step['values'], name: string): string | undefined {
  const [key, place] = name.split('.') as [string, string | undefined];
  const value = values?.[key];
  if (value === undefined) return undefined;
  if (place === undefined) return textOf(value);
  const item = typeof value === 'object' ? value[Number(place)] : undefined;
  return item === undefined ? undefined : textOf(item);
}

/** A number of the step that is named, or after `position` steps; undefined: there is none. */
export function runNumber(
  replay: Replay,
  position: number,
  name: string,
  at?: StepName,
): string | undefined {
  const { header, steps, totals } = replay.log;
  const done = at ? placeOf(steps, at) : position;
  if (at && done === 0) return undefined;
  const rest = name.slice(name.indexOf('.') + 1);
  switch (name.split('.')[0]) {
    case 'step':
      return String(done);
    case 'steps':
      return String(steps.length);
    case 'polygons':
      return String(header.polygons.length);
    case 'end':
      return valueOf(totals, rest);
    case 'count':
      replay.seek(done);
      return String(replay.count(rest));
  }
  return valueOf(steps[done - 1]?.values, name);
}

/** Whether a piece of this name has an outline, at the end at the latest. */
export function knowsPiece(replay: Replay, name: string): boolean {
  const { header, steps } = replay.log;
  const made = steps.flatMap((step) => step.made ?? []);
  const pieces = header.polygons.flatMap((polygon) => polygon.pieces);
  return (
    header.polygons.some(({ id }) => String(id) === name) ||
    [...pieces, ...made].some((piece) => piece.name === name)
  );
}
