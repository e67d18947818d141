// The lines that a hidden-line algorithm has drawn, as paths of SVG. Does not decide what is hidden.
import type { DrawnLine } from './log';
import type { Replay } from './replay';

export interface DrawnPaths {
  readonly visible: string;
  readonly hidden: string;
  /** The whole line of the last step. */
  readonly last: string;
}

function part(line: DrawnLine, from: number, to: number): string {
  const at = (t: number) =>
    `${line.from[0] + t * (line.to[0] - line.from[0])} ${line.from[1] + t * (line.to[1] - line.from[1])}`;
  return `M${at(from)}L${at(to)}`;
}

/** The visible parts, and what lies between them. */
export function pathsOf(line: DrawnLine): { visible: string; hidden: string } {
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

export function linesUntil(replay: Replay, position: number): DrawnPaths {
  if (replay.log.header.draws !== 'lines') return { visible: '', hidden: '', last: '' };
  let visible = '';
  let hidden = '';
  for (let i = 0; i < position; ++i) {
    const line = replay.log.steps[i]!.line;
    if (!line) continue;
    const paths = pathsOf(line);
    visible += paths.visible;
    hidden += paths.hidden;
  }
  const line = replay.log.steps[position - 1]?.line;
  return { visible, hidden, last: line ? part(line, 0, 1) : '' };
}
