// Answers to questions, as the page grades them.
import { describe, expect, it } from 'vitest';
import { isRight, letter, numbersOf, pictureOf } from '../model/quiz';
import { fromQuizAddress, toQuizAddress } from '../model/quiz_address';
import { defaultSettings } from '../model/settings';
import { question } from './samples/question';

describe('an answer', () => {
  it('is right as the key has it, in digits of any width', () => {
    const number = { ...question, answer: '12' };
    for (const given of ['12', ' 12 ', '１２']) expect(isRight(number, given)).toBe(true);
    for (const given of ['', '1', '2', '1 2', '12.5', 'twelve'])
      expect(isRight(number, given)).toBe(false);
  });

  it('of several numbers has all of them and no others', () => {
    const several = { ...question, among: 4, answer: '1 3' };
    expect(isRight(several, numbersOf([true, false, true]))).toBe(true);
    expect(isRight(several, numbersOf([true, true, true]))).toBe(false);
    expect(isRight(several, numbersOf([true]))).toBe(false);
    expect(numbersOf([])).toBe('');
  });

  it('of a choice is its letter', () => {
    expect([0, 1, 5].map(letter)).toEqual(['a', 'b', 'f']);
  });
});

it('keeps signs of a drawing that addresses do not have', () => {
  expect(decodeURIComponent(pictureOf({ ...question, drawing: '<svg fill="#fff">%</svg>' }))).toBe(
    'data:image/svg+xml,<svg fill="#fff">%</svg>',
  );
});

it('has its question in the address, one that exists', () => {
  const defaults = defaultSettings('en', false);
  const numberOf = (hash: string): number => fromQuizAddress(hash, defaults, 7).number;
  expect(['', '#question=3', '#question=99', '#question=-1', '#question=x'].map(numberOf)).toEqual([
    1, 3, 7, 1, 1,
  ]);
  const state = fromQuizAddress('#question=5&lang=ja', defaults, 7);
  expect(toQuizAddress(state, defaults)).toBe('#question=5&lang=ja');
});
