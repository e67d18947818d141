// A page as a package of a learning platform, by SCORM 1.2's run-time environment: score,
// completion and what was answered, so that a later visit goes on. Only pages that scripts/scorm
// has marked look for a platform; without one they work as alone.

import { scorm } from '@gamestdio/scorm';

/** The platform is in a window around this one, or around one that opened them. */
function isConnected(): boolean {
  // Not by configure(), which takes false for true.
  Object.assign(scorm, {
    version: '1.2',
    isDebugActive: false,
    handleCompletionStatus: false,
    handleExitMode: false,
  });
  try {
    return scorm.initialize();
  } catch {
    return false; // a window of another site: no platform
  }
}

/** SCORM's HHHH:MM:SS.SS. */
export function timeText(milliseconds: number): string {
  const hundredths = Math.round(milliseconds / 10);
  const [hours, minutes] = [Math.floor(hundredths / 360_000), Math.floor(hundredths / 6000) % 60];
  const seconds = (hundredths % 6000) / 100;
  const two = (value: number): string => String(value).padStart(2, '0');
  return `${two(hours)}:${two(minutes)}:${seconds.toFixed(2).padStart(5, '0')}`;
}

/** One visit of one learner. */
export class Attempt {
  private complete: boolean;
  private readonly begun = performance.now();

  /** `address`: how the page opens, as scripts/scorm chose it. The platform is connected. */
  constructor(readonly address: URLSearchParams) {
    const status = scorm.get('cmi.core.lesson_status');
    this.complete = ['completed', 'passed', 'failed'].includes(status);
    if (!this.complete) scorm.set('cmi.core.lesson_status', 'incomplete');
    scorm.set('cmi.core.score.min', '0');
    scorm.set('cmi.core.score.max', '100');
    scorm.commit();
  }

  /** What an earlier visit told; undefined: nothing that can be read. */
  remembered(): unknown {
    try {
      return JSON.parse(scorm.get('cmi.suspend_data')) as unknown;
    } catch {
      return undefined;
    }
  }

  tell(right: number, all: number, isComplete: boolean, remember: unknown): void {
    this.complete ||= isComplete;
    scorm.set('cmi.core.score.raw', String(Math.round((100 * right) / all)));
    scorm.set('cmi.core.lesson_status', this.complete ? 'completed' : 'incomplete');
    scorm.set('cmi.suspend_data', JSON.stringify(remember));
    scorm.commit();
  }

  end(): void {
    scorm.set('cmi.core.session_time', timeText(performance.now() - this.begun));
    scorm.set('cmi.core.exit', this.complete ? '' : 'suspend');
    scorm.terminate();
  }
}

/** How a page of a package opens; undefined: the page is in none. */
export const packaged: string | undefined =
  typeof document === 'undefined' ? undefined : document.documentElement.dataset['package'];

/** Called once, when the page starts: opens the package's address, and begins the visit. */
function begin(): Attempt | undefined {
  if (packaged === undefined) return undefined;
  if (!location.hash) history.replaceState(null, '', `#${packaged}`);
  if (!isConnected()) return undefined;
  const attempt = new Attempt(new URLSearchParams(packaged));
  addEventListener('pagehide', () => attempt.end(), { once: true });
  return attempt;
}
export const attempt = begin();
