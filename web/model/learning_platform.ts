// A page as a package of a learning platform, by SCORM 1.2's run-time environment: score,
// completion and what was answered, so that a later visit goes on. Only pages that scripts/scorm
// has marked look for a platform; without one they work as alone.

/** The calls of SCORM 1.2; they answer with "true", "false" or a value. */
export interface Platform {
  LMSInitialize(nothing: ''): string;
  LMSFinish(nothing: ''): string;
  LMSGetValue(element: string): string;
  LMSSetValue(element: string, value: string): string;
  LMSCommit(nothing: ''): string;
}

type Frame = Window & { readonly API?: Platform };

/** The platform is in a window around this one, or around the one that opened it. */
function platformAround(start: Window): Platform | undefined {
  let at = start as Frame;
  for (let levels = 0; levels < 8; ++levels) {
    if (at.API) return at.API;
    if (at.parent === at) return undefined;
    at = at.parent as Frame;
  }
  return undefined;
}

function platformOf(page: Window): Platform | undefined {
  try {
    const opener = page.opener as Window | null;
    return platformAround(page) ?? (opener ? platformAround(opener) : undefined);
  } catch {
    return undefined; // a window of another site: no platform
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

  /** `address`: how the page opens, as scripts/scorm chose it. */
  constructor(
    readonly address: URLSearchParams,
    private readonly platform: Platform,
  ) {
    platform.LMSInitialize('');
    const status = platform.LMSGetValue('cmi.core.lesson_status');
    this.complete = ['completed', 'passed', 'failed'].includes(status);
    if (!this.complete) platform.LMSSetValue('cmi.core.lesson_status', 'incomplete');
    platform.LMSSetValue('cmi.core.score.min', '0');
    platform.LMSSetValue('cmi.core.score.max', '100');
    platform.LMSCommit('');
  }

  /** What an earlier visit told; undefined: nothing that can be read. */
  remembered(): unknown {
    try {
      return JSON.parse(this.platform.LMSGetValue('cmi.suspend_data')) as unknown;
    } catch {
      return undefined;
    }
  }

  tell(right: number, all: number, isComplete: boolean, remember: unknown): void {
    this.complete ||= isComplete;
    const { platform } = this;
    platform.LMSSetValue('cmi.core.score.raw', String(Math.round((100 * right) / all)));
    platform.LMSSetValue('cmi.core.lesson_status', this.complete ? 'completed' : 'incomplete');
    platform.LMSSetValue('cmi.suspend_data', JSON.stringify(remember));
    platform.LMSCommit('');
  }

  end(): void {
    const { platform } = this;
    platform.LMSSetValue('cmi.core.session_time', timeText(performance.now() - this.begun));
    platform.LMSSetValue('cmi.core.exit', this.complete ? '' : 'suspend');
    platform.LMSCommit('');
    platform.LMSFinish('');
  }
}

/** How a page of a package opens; undefined: the page is in none. */
export const packaged: string | undefined =
  typeof document === 'undefined' ? undefined : document.documentElement.dataset['package'];

/** Called once, when the page starts: opens the package's address, and begins the visit. */
function begin(): Attempt | undefined {
  if (packaged === undefined) return undefined;
  if (!location.hash) history.replaceState(null, '', `#${packaged}`);
  const platform = platformOf(window);
  if (!platform) return undefined;
  const attempt = new Attempt(new URLSearchParams(packaged), platform);
  addEventListener('pagehide', () => attempt.end(), { once: true });
  return attempt;
}
export const attempt = begin();
