// A range of steps stays within the log, whatever is typed.
import { expect, test } from 'vitest';
import { rangeOf } from '../model/export';

test('a range within the log stays', () => {
  expect(rangeOf(3, 7, 22)).toEqual([3, 7]);
  expect(rangeOf(5, 5, 22)).toEqual([5, 5]);
});

test('a range beyond the log, backwards or empty becomes one of the log', () => {
  expect(rangeOf(10, 5, 22)).toEqual([5, 10]);
  expect(rangeOf(-3, 9999, 22)).toEqual([0, 22]);
  expect(rangeOf(null, 7, 22)).toEqual([0, 7]);
  expect(rangeOf(4, null, 22)).toEqual([4, 22]);
  expect(rangeOf(2.5, 3.5, 22)).toEqual([2, 3]);
});
