import { expect, it } from 'vitest';
import { fromAddress, toAddress } from '../model/compare_address';
import {
  countersOf,
  differenceIds,
  differencePalette,
  planesOf,
  sorted,
  spreadRuns,
  tellingRuns,
  timesPalette,
} from '../model/comparison';
import { defaultSettings } from '../model/settings';
import { comparison } from './samples/comparison';

const names = (runs: readonly { name: string }[]) => runs.map((run) => run.name);

it('spreads runs over pixels', () => {
  expect([...spreadRuns([2, 7, 1, 0, 3, 5], 6)]).toEqual([7, 7, 0, 5, 5, 5]);
});

it('leaves out counters that are 0 everywhere', () => {
  expect(countersOf(comparison)).toEqual(['wrong', 'polygons', 'keys']);
});

it('sorts by any counter, stably', () => {
  const runs = comparison.algorithms;
  expect(names(sorted(runs, undefined, true))).toEqual(names(runs));
  expect(names(sorted(runs, 'wrong', true))).toEqual(['painter', 'z-buffer', 'newell']);
  expect(names(sorted(runs, 'keys', false))).toEqual(['z-buffer', 'newell', 'painter']);
});

it('begins with what is wrong most and with the Z-buffer', () => {
  expect(tellingRuns(comparison, 2)).toEqual(['painter', 'z-buffer']);
});

it('marks where pixels differ, and only there', () => {
  const planes = planesOf(comparison.algorithms[0]!, comparison.size);
  const ids = differenceIds(planes);
  const colors = differencePalette(new Map([[1, '#ff0000']]), 'scene');
  expect(ids[0]).toBe(0);
  expect(colors.get(ids[3]!)).toBe('#e61414');
  expect(colors.get(1)).toBe('#904343');
});

it('paints more than 5 writes ever paler', () => {
  const colors = timesPalette();
  expect(colors.get(5)).toBe('#e61414');
  expect(colors.get(6)).toBe('#fa2828');
  expect(colors.get(255)).toBe('#fff5f5');
});

it('keeps the page in the address', () => {
  const defaults = defaultSettings('ja', true);
  const state = fromAddress('#show=a,b&plane=writes&sort=-keys&large=b&pixel=1,2', defaults);
  expect(state).toMatchObject({
    show: ['a', 'b'],
    plane: 'writes',
    sort: 'keys',
    descending: true,
    large: 'b',
    pixel: [1, 2],
    language: 'ja',
    dark: true,
  });
  expect(fromAddress(toAddress(state, defaults), defaults)).toEqual(state);
});
