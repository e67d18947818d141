import { expect, it } from 'vitest';
import { titledAlgorithms } from '../words/titles';
import { codeNames, litLine, pseudoCode } from '../words/pseudo_code';

it('is there for every algorithm with a title, in ten to twenty lines', () => {
  expect([...codeNames].sort()).toEqual(
    titledAlgorithms.filter((name) => name !== 'played').sort(),
  );
  for (const name of codeNames) {
    const lines = pseudoCode(name);
    expect(lines.length, name).toBeGreaterThanOrEqual(10);
    expect(lines.length, name).toBeLessThanOrEqual(20);
    for (const line of lines) {
      expect(line.en, name).not.toBe('');
      expect(line.ja, `${name}: ${line.en}`).not.toBe('');
      expect(line.ja, `${name}: ${line.en}`).not.toContain('標本区間');
    }
    expect(
      lines.some((line) => line.lit.includes('draw')),
      name,
    ).toBe(true);
  }
});

it('lights the line of the answer before that of the question', () => {
  const code = pseudoCode('newell');
  const line = (test: string, result: string) => code[litLine(code, { test, result })]?.en ?? '';
  expect(line('farthest-corner', 'moved')).toContain('move Q');
  expect(line('farthest-corner', 'sorted')).toContain('sort all');
  expect(line('split', 'none')).toContain('cut one');
  expect(litLine(code, { test: 'unknown', result: 'yes' })).toBe(-1);
  expect(litLine(code, undefined)).toBe(-1);
});
