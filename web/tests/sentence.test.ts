import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { general, sentence, textOf } from '../model/steps/sentence';
import { header, steps } from './samples/log';

it('writes numbers with six digits, large ones whole', () => {
  const cases: [number, string][] = [
    [0, '0'],
    [1, '1'],
    [-2.5, '-2.5'],
    [123456, '123456'],
    [1234567.25, '1234567'],
    [1.5e20, '1.5e+20'],
    [0.0001, '0.0001'],
    [0.00001234, '1.234e-05'],
    [-16609071.6, '-16609072'],
    [0.1 + 0.2, '0.3'],
    [1e-300, '1e-300'],
    [100000, '100000'],
    [3.14159265, '3.14159'],
  ];
  for (const [value, text] of cases) expect(general(value)).toBe(text);
});

it('makes the sentence of a step in both languages', () => {
  expect(sentence(header, steps[1]!, 'en')).toBe('1 600.5, 600.5 is behind 2.');
  expect(sentence(header, steps[1]!, 'ja')).toBe('1 は 2 の奥です。');
  expect(sentence(header, steps[0]!, 'en')).toBe('1, 2.');
});

it('shows what a step lacks, and steps without words', () => {
  expect(sentence(header, { ...steps[3]!, values: {} }, 'en')).toBe('1a: {pixels} pixels.');
  expect(sentence(header, { ...steps[3]!, test: 'new' }, 'en')).toBe('new: piece');
});

it('writes lists with commas and truth as the command does', () => {
  expect(textOf([1, 2.25])).toBe('1, 2.25');
  expect(textOf(true)).toBe('1');
  expect(textOf(['1a', '2'])).toBe('1a, 2');
  expect(textOf([])).toBe('–');
});

const file = process.env['GW_STEP_WORDS'] ?? '../hiddensurface/run/step_words.json';
type Texts = Record<string, Record<string, Record<'en' | 'ja', string>>>;
const texts = Object.values(JSON.parse(readFileSync(file, 'utf8')) as Texts).flatMap(Object.values);

it('says of a list that may be empty no place, which would be "at –"', () => {
  for (const { en, ja } of texts) {
    expect(en).not.toMatch(/\bat \{(changes|visible)\}/);
    expect(ja).not.toMatch(/\{(changes|visible)\} で(?!す)/);
  }
});

it('says of a distance that may be below 0 which side that is', () => {
  for (const { en, ja } of texts) {
    expect(en).not.toMatch(/(by|up to|plane of \{second\}:) \{(behind|nearest|farthest)\}/);
    expect(ja).not.toMatch(/(手前|奥)[^。]*（[^）]*\{(behind|nearest)\}）|\{\w+\} だけ奥/);
  }
});
