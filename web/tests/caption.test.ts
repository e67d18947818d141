import { expect, it } from 'vitest';
import { linesOfText } from '../model/caption';

const widthOf = (text: string): number => text.length;

it('breaks a sentence at blanks', () => {
  expect(linesOfText('2b and 2a overlap in x', 10, widthOf)).toEqual([
    '2b and 2a',
    'overlap in',
    'x',
  ]);
});

it('breaks a text without blanks anywhere, and loses no letter', () => {
  expect(linesOfText('画素を描きます。', 3, widthOf)).toEqual(['画素を', '描きま', 'す。']);
  expect(linesOfText('a 12345678', 4, widthOf).join('').replace(/ /g, '')).toBe('a12345678');
});

it('breaks Japanese between letters, not before a mark or within a number', () => {
  expect(linesOfText('4 の頂点は 0.77 です。', 8, widthOf)).toEqual(['4 の頂点は', '0.77 です。']);
  expect(linesOfText('描きます。', 4, widthOf)).toEqual(['描きま', 'す。']);
});

it('makes no line of nothing', () => {
  expect(linesOfText('  ', 5, widthOf)).toEqual([]);
});
