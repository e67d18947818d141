// What a step of a frame, and the whole frame, has drawn, in words.
import { filled, timeText } from '../../model/report';
import type { Words } from '../../words/en';
import type { FrameSeen, FrameStep } from './protocol';

/** "3 polygons, 12 lines" */
function things(
  of: Pick<FrameStep, 'polygons' | 'lines' | 'points'>,
  language: string,
  words: Words,
): string {
  const named = [
    [of.polygons, words.program_polygons],
    [of.lines, words.program_lines],
    [of.points, words.program_points],
  ] as const;
  return named
    .filter(([count]) => count > 0)
    .map(([count, word]) => filled(word, count.toLocaleString(language)))
    .join(words.program_and);
}

/** What became of its fragments. */
function fates(count: (name: string) => number, language: string, words: Words): string {
  const number = (name: string) => count(name).toLocaleString(language);
  const parts = [filled(words.program_written, number('written'))];
  if (count('depth_killed') > 0) parts.push(filled(words.program_lost, number('depth_killed')));
  if (count('culled') > 0) parts.push(filled(words.program_culled, number('culled')));
  return parts.join(' ');
}

export function stepText(step: FrameStep, language: string, words: Words): string {
  const count = (name: string) => step.counters[name] ?? 0;
  switch (step.kind) {
    case 'clear':
      return words.program_clear;
    case 'pixels':
      return words.program_pixels;
    case 'shown':
      return words.program_shown;
    case 'other':
      return words.program_other;
    case 'primitives':
      return `${things(step, language, words)}${words.program_stop} ${fates(count, language, words)}`;
  }
}

export function wholeText(seen: FrameSeen, language: string, words: Words): string {
  const sum = (of: (step: FrameStep) => number) => seen.steps.reduce((all, s) => all + of(s), 0);
  const count = (name: string) => sum((step) => step.counters[name] ?? 0);
  const whole = {
    polygons: sum((s) => s.polygons),
    lines: sum((s) => s.lines),
    points: sum((s) => s.points),
  };
  const time = timeText(sum((s) => s.seconds));
  return [
    `${filled(words.program_whole, things(whole, language, words))}`,
    fates(count, language, words),
    filled(words.program_time, time, seen.machine),
  ].join(' ');
}
