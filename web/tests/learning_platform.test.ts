// Where the page of a package finds its platform, and what it tells it.
import { afterEach, beforeEach, expect, it, vi } from 'vitest';

/** A platform that takes all and keeps the calls. */
function platform() {
  const calls: string[] = [];
  const call =
    (name: string, answer: string) =>
    (...args: string[]) => {
      calls.push([name, ...args].join(' ').trim());
      return answer;
    };
  return {
    calls,
    API: {
      LMSInitialize: call('Initialize', 'true'),
      LMSFinish: call('Finish', 'true'),
      LMSGetValue: call('GetValue', ''),
      LMSSetValue: call('SetValue', 'true'),
      LMSCommit: call('Commit', 'true'),
      LMSGetLastError: () => '0',
    },
  };
}
type Frame = Record<string, unknown>;
/** A window that is in none, or in another one. */
function frame(members: Frame = {}, parent?: Frame): Frame {
  const made: Frame = { ...members };
  made.parent = parent ?? made;
  made.top = parent?.top ?? made;
  return made;
}

let leave: () => void;
async function attemptIn(page: Frame) {
  vi.stubGlobal('window', page);
  return (await import('../model/learning_platform')).attempt;
}
beforeEach(() => {
  vi.resetModules();
  vi.stubGlobal('document', { documentElement: { dataset: { package: 'article=visibility' } } });
  vi.stubGlobal('location', { hash: '' });
  vi.stubGlobal('history', { replaceState: () => undefined });
  vi.stubGlobal('addEventListener', (_: string, called: () => void) => (leave = called));
});
afterEach(() => vi.unstubAllGlobals());

it.each([
  ['the window around the page', (API: object) => frame({}, frame({ API }))],
  ['a window further out', (API: object) => frame({}, frame({}, frame({}, frame({ API }))))],
  ['the window that opened the page', (API: object) => frame({ opener: frame({ API }) })],
  [
    'the window that opened the frames around the page',
    (API: object) => frame({}, frame({ opener: frame({}, frame({ API })) })),
  ],
])('the platform is in %s', async (_, windows) => {
  const { API, calls } = platform();
  const attempt = (await attemptIn(windows(API)))!;
  expect(attempt.address.get('article')).toBe('visibility');
  attempt.tell(1, 3, false, [0]);
  attempt.tell(3, 3, true, [0, 1, 2]);
  leave();
  expect(calls.filter((call) => !call.includes('session_time'))).toEqual([
    'Initialize',
    'GetValue cmi.core.lesson_status',
    'SetValue cmi.core.lesson_status incomplete',
    'SetValue cmi.core.score.min 0',
    'SetValue cmi.core.score.max 100',
    'Commit',
    'SetValue cmi.core.score.raw 33',
    'SetValue cmi.core.lesson_status incomplete',
    'SetValue cmi.suspend_data [0]',
    'Commit',
    'SetValue cmi.core.score.raw 100',
    'SetValue cmi.core.lesson_status completed',
    'SetValue cmi.suspend_data [0,1,2]',
    'Commit',
    'SetValue cmi.core.exit',
    'Commit',
    'Finish',
  ]);
});

it('works as alone without a platform', async () => {
  expect(await attemptIn(frame({}, frame()))).toBeUndefined();
});

it('works as alone in a window of another site', async () => {
  const other = frame();
  Object.defineProperty(other, 'API', {
    get() {
      throw new Error('SecurityError');
    },
  });
  expect(await attemptIn(frame({}, other))).toBeUndefined();
});
