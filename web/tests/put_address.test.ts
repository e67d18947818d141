import { afterEach, beforeEach, expect, it, vi } from 'vitest';

let putAddress: (address: string) => void;
let changes: string[] = [];
beforeEach(async () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'performance'] });
  vi.resetModules(); // each test begins with a page that has put nothing yet
  ({ putAddress } = await import('../model/put_address'));
  vi.stubGlobal('location', { hash: '' });
  changes = [];
  vi.stubGlobal('history', {
    replaceState: (_state: unknown, _title: string, address: string) => {
      location.hash = address;
      changes.push(address);
    },
  });
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

it('of 600 steps in ten seconds the browser sees few, and the last', () => {
  for (let step = 0; step < 600; ++step) {
    putAddress(`#step=${step}`);
    vi.advanceTimersByTime(1000 / 60);
  }
  vi.advanceTimersByTime(1000);
  expect(changes.length).toBeLessThan(60);
  expect(changes.length).toBeGreaterThan(40);
  expect(changes.at(-1)).toBe('#step=599');
});

it('after a rest a few steps are seen soon', () => {
  for (let step = 0; step < 600; ++step) {
    putAddress(`#step=${step}`);
    vi.advanceTimersByTime(1000 / 60);
  }
  vi.advanceTimersByTime(1000);
  for (const step of [1, 2, 3]) {
    putAddress(`#step=${step}`);
    vi.advanceTimersByTime(100);
    expect(changes.at(-1)).toBe(`#step=${step}`);
  }
});

it('a single step is seen at once', () => {
  putAddress('#step=7');
  expect(changes).toEqual(['#step=7']);
});
