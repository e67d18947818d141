import { expect, it } from 'vitest';
import { Chunks } from '../model/steps/chunks';
import type { Step } from '../model/steps/log';
import { countBelow } from '../model/numbers';
import { sideAt, sidesOf } from '../model/steps/tree';
import { rejectedOf, windowsOf } from '../model/steps/windows';

const step = (i: number, more: Partial<Step>): Step => ({
  step: i + 1,
  level: 'polygon',
  kind: 'compare',
  test: 'window',
  result: 'divided',
  ...more,
});
const steps = Array.from({ length: 25 }, (_, i) => step(i, { window: [i, 0, 1, 1] }));

it('makes the same drawing in chunks as at once, forwards and back', () => {
  let made = 0;
  const numbers = (some: readonly Step[]) => {
    made += some.length;
    return some.map((s) => s.step);
  };
  const chunks = new Chunks(steps, numbers, 10);
  for (const position of [3, 25, 24, 10, 9, 0, 20])
    expect(chunks.upTo(position).flat()).toEqual(steps.slice(0, position).map((s) => s.step));
  made = 0;
  chunks.upTo(25);
  expect(made).toBe(5);
});

it('draws windows that are divided, filled and empty', () => {
  const { divided, decided } = windowsOf([
    steps[0]!,
    step(1, { result: 'empty', window: [0, 0, 2, 2] }),
    step(2, { kind: 'draw', result: 'one', pieces: ['7a'], window: [2, 0, 2, 1] }),
    step(3, { test: 'other', window: [9, 9, 9, 9] }),
  ]);
  expect(divided).toBe('M0 0h1v1h-1Z');
  expect([...decided]).toEqual([
    [0, 'M0 0h2v2h-2Z'],
    [7, 'M2 0h2v1h-2Z'],
  ]);
});

it('draws the boxes that the pyramid rejected', () => {
  const box = { test: 'pyramid-cube', window: [1, 2, 3, 4] as const };
  expect(
    rejectedOf([step(0, { ...box, result: 'hidden' }), step(1, { ...box, result: 'seen' })]),
  ).toBe('M1 2h3v4h-3Z');
});

it("knows the eye's side of a node from the step on that asked", () => {
  const sides = sidesOf([
    steps[0]!,
    step(1, { test: 'eye-side', result: 'front', values: { node: 3 } }),
    step(2, { test: 'eye-side', result: 'back', values: { node: 3 } }),
  ]);
  expect([1, 2, 3].map((done) => sideAt(sides, 3, done))).toEqual([undefined, 'front', 'back']);
});

it('counts numbers below a value', () => {
  expect([0, 2, 3, 9].map((value) => countBelow([2, 2, 5], value))).toEqual([0, 0, 2, 3]);
});
