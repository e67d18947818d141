// The windows of Warnock's algorithm and of the depth pyramid as paths of SVG, in pixels.
import { polygonOf, type Step, type Window } from './log';

const outlineOf = ([x, y, w, h]: Window): string => `M${x} ${y}h${w}v${h}h${-w}Z`;

export interface DecidedWindows {
  readonly divided: string;
  /** By the polygon that fills them; 0: empty ones. */
  readonly decided: ReadonlyMap<number, string>;
}

export function windowsOf(steps: readonly Step[]): DecidedWindows {
  let divided = '';
  const decided = new Map<number, string>();
  for (const step of steps) {
    if (step.test !== 'window' || !step.window) continue;
    const path = outlineOf(step.window);
    if (step.result === 'divided') divided += path;
    else if (step.kind === 'draw' || step.result === 'empty') {
      const id = step.kind === 'draw' ? polygonOf(step.pieces?.[0] ?? '0') : 0;
      decided.set(id, (decided.get(id) ?? '') + path);
    }
  }
  return { divided, decided };
}

/** Boxes that the depth pyramid rejected. */
export function rejectedOf(steps: readonly Step[]): string {
  return steps
    .map((step) =>
      step.test.startsWith('pyramid') && step.result === 'hidden' && step.window
        ? outlineOf(step.window)
        : '',
    )
    .join('');
}
