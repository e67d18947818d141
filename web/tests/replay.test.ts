import { describe, expect, it } from 'vitest';
import { parseLog, type Log, type Step } from '../model/steps/log';
import { nextWhere, Replay, touches } from '../model/steps/replay';
import { header, text } from './samples/log';

/** Many steps that paint runs, by a fixed sequence. */
function longLog(steps: number): Log {
  let seed = 7;
  const random = (below: number) => (seed = (seed * 48271) % 2147483647) % below;
  const all: Step[] = Array.from({ length: steps }, (_, i) => {
    const x0 = random(15);
    const x1 = x0 + 1 + random(16 - x0);
    return {
      step: i + 1,
      level: 'polygon',
      kind: 'draw',
      test: 'draw',
      result: 'piece',
      painted: [[random(8), x0, x1, random(9)]],
      counts: { pixels: i },
    };
  });
  return { header, steps: all, totals: {}, blame: [], whole: true };
}

function paintedUntil(log: Log, position: number): number[] {
  const ids = new Array<number>(16 * 8).fill(0);
  for (const step of log.steps.slice(0, position))
    for (const [y, x0, x1, id] of step.painted ?? []) ids.fill(id, y * 16 + x0, y * 16 + x1);
  return ids;
}

describe('Replay', () => {
  it('has the same picture after a jump as after all steps before', () => {
    const log = longLog(1000);
    const replay = new Replay(log);
    for (const position of [1000, 0, 999, 500, 501, 17, 16, 15, 640, 1, 0, 333]) {
      replay.seek(position);
      expect(replay.position).toBe(position);
      expect([...replay.ids]).toEqual(paintedUntil(log, position));
      expect(replay.count('pixels')).toBe(Math.max(0, position - 1));
    }
  });
  it('stays inside the log', () => {
    const replay = new Replay(parseLog(text()));
    replay.seek(-5);
    expect(replay.position).toBe(0);
    replay.seek(1e9);
    expect(replay.position).toBe(5);
  });
  it('knows the order, the pieces and the counters of each moment', () => {
    const replay = new Replay(parseLog(text()));
    replay.seek(0);
    expect(replay.order()).toBeUndefined();
    expect(replay.outline('1a')).toHaveLength(1);
    replay.seek(4);
    expect(replay.order()?.pieces).toEqual(['1', '2']);
    expect(replay.outline('1a')[0]![1]).toEqual([40, 0, 600]);
    expect(replay.count('pixels')).toBe(80);
    expect(replay.outline('unknown')).toEqual([]);
  });
});

it('finds the next decisive step in both directions', () => {
  const { steps } = parseLog(text());
  const decisive = (step: Step) => step.decisive === true;
  expect(nextWhere(steps, 0, 1, decisive)).toBe(2);
  expect(nextWhere(steps, 2, 1, decisive)).toBe(3);
  expect(nextWhere(steps, 3, 1, decisive)).toBe(-1);
  expect(nextWhere(steps, 5, -1, decisive)).toBe(3);
});

it('follows a pixel', () => {
  const { steps } = parseLog(text());
  const at = (x: number, y: number) =>
    steps.filter((step) => touches(step, x, y)).map((step) => step.step);
  expect(at(2, 3)).toEqual([4]);
  expect(at(8, 7)).toEqual([4, 5]);
  expect(at(15, 0)).toEqual([5]);
});
