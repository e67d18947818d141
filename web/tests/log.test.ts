import { describe, expect, it } from 'vitest';
import { LogError, parseLog, polygonOf } from '../model/steps/log';
import { text } from './samples/log';

describe('parseLog', () => {
  it('reads the header, all steps and the totals', () => {
    const log = parseLog(text());
    expect(log.header.algorithm).toBe('newell');
    expect(log.steps.map((step) => step.step)).toEqual([1, 2, 3, 4, 5]);
    expect(log.totals['pixels']).toBe(160);
    expect(log.whole).toBe(true);
  });
  it('keeps the steps of a log that ends early', () => {
    const lines = text().split('\n').slice(0, 4).join('\n');
    const log = parseLog(lines);
    expect(log.steps.length).toBe(3);
    expect(log.whole).toBe(false);
  });
  it.each([
    ['', 'line 1'],
    ['{"log":"other"}\n', 'line 1: not a header'],
    [text().replace('"version":1', '"version":7'), 'line 1: version 7'],
    [text().replace('"kind":"compare"', '"kind":3'), 'line 3: not a step'],
    [text().slice(0, text().indexOf('"step":2') + 3), 'line 3'],
  ])('refuses what is no log, by its line', (bad, message) => {
    expect(() => parseLog(bad)).toThrow(LogError);
    expect(() => parseLog(bad)).toThrow(message);
  });
});

it('finds the polygon of a piece', () => {
  expect(['3', '12ab', '7.2a'].map(polygonOf)).toEqual([3, 12, 7]);
});
