// The lines that a hidden-line algorithm has drawn, as paths of SVG. Does not decide visibility.
import type { DrawnLine, Step } from './log';

export interface DrawnPaths {
  readonly visible: string;
  readonly hidden: string;
}

function part(line: DrawnLine, from: number, to: number): string {
  const at = (t: number) =>
    `${line.from[0] + t * (line.to[0] - line.from[0])} ${line.from[1] + t * (line.to[1] - line.from[1])}`;
  return `M${at(from)}L${at(to)}`;
}

export const wholeLine = (line: DrawnLine): string => part(line, 0, 1);

/**
 * The side that the last of `position` steps asks about: its own line, or that of the next step
 * that has one, to which its crossings belong.
 */
export function sideInQuestion(steps: readonly Step[], position: number): DrawnLine | undefined {
  if (position === 0) return undefined;
  return steps.slice(position - 1, position + 1000).find((step) => step.line)?.line;
}

/** The visible parts, and what lies between them. */
export function pathsOf(line: DrawnLine): DrawnPaths {
  let visible = '';
  let hidden = '';
  let end = 0;
  for (const [from, to] of line.visible) {
    if (from > end) hidden += part(line, end, from);
    visible += part(line, from, to);
    end = to;
  }
  if (end < 1) hidden += part(line, end, 1);
  return { visible, hidden };
}

export function linesOf(steps: readonly Step[]): DrawnPaths {
  const all = steps.flatMap((step) => (step.line ? [pathsOf(step.line)] : []));
  return {
    visible: all.map((paths) => paths.visible).join(''),
    hidden: all.map((paths) => paths.hidden).join(''),
  };
}
