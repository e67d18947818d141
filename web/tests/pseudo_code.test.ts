import { expect, it } from 'vitest';
import { everyWord, namesIn, stepWords } from '../every_word';
import { nameOf } from '../words/names';
import { codeNames, litLine, pseudoCode, type CodeLine } from '../words/pseudo_code';

const japanese = (line: CodeLine): string => nameOf('code', line.text, 'ja');

it('is there for every algorithm with a title, in ten to twenty lines', () => {
  expect([...codeNames].sort()).toEqual(
    namesIn(everyWord.names.title)
      .filter((name) => name !== 'played')
      .sort(),
  );
  for (const name of codeNames) {
    const lines = pseudoCode(name);
    expect(lines.length, name).toBeGreaterThanOrEqual(10);
    expect(lines.length, name).toBeLessThanOrEqual(20);
    for (const line of lines) {
      expect(line.text, name).not.toBe('');
      expect(japanese(line), `${name}: ${line.text}`).not.toContain('標本区間');
    }
    expect(
      lines.some((line) => line.lit.includes('draw')),
      name,
    ).toBe(true);
  }
});

it('lights the line of the answer before that of the question', () => {
  const code = pseudoCode('newell');
  const line = (test: string, result: string) => code[litLine(code, { test, result })]?.text ?? '';
  expect(line('farthest-corner', 'moved')).toContain('move Q');
  expect(line('farthest-corner', 'sorted')).toContain('sort all');
  expect(line('split', 'seen-plane')).toContain('cut one');
  expect(line('split', 'none')).toContain('neither can be cut');
  expect(litLine(code, { test: 'unknown', result: 'yes' })).toBe(-1);
  expect(litLine(code, undefined)).toBe(-1);
});

/** Answers that one line says truly: they do not contradict each other. */
const agreeing = [
  ['draw.piece', 'draw.line', 'draw.nearer', 'draw.unhidden'],
  ['tree-node.root', 'tree-node.front', 'tree-node.back'],
  ['eye-side.front', 'eye-side.front-parallel'],
  ['eye-side.back', 'eye-side.back-parallel'],
  ['active-edges.segments', 'active-edges.sorted'],
  ['priority.front', 'priority.back'],
  ['points.one', 'points.shared'],
  ['pyramid-cube.hidden', 'pyramid-cube.hidden-by-cells'],
  ['pyramid-polygon.hidden', 'pyramid-polygon.hidden-by-cells'],
];

it('lights different lines for answers of opposite meaning, in every algorithm', () => {
  const complaints: string[] = [];
  for (const name of codeNames)
    for (const [test, answers] of Object.entries(stepWords)) {
      const code = pseudoCode(name);
      const results = Object.keys(answers);
      for (const [i, one] of results.entries())
        for (const other of results.slice(i + 1)) {
          const at = litLine(code, { test, result: one });
          if (at < 0 || at !== litLine(code, { test, result: other })) continue;
          const pair = [`${test}.${one}`, `${test}.${other}`];
          const isAsked = code[at]!.isQuestion && [one, other].sort().join() === 'no,yes';
          const agrees = agreeing.some((set) => pair.every((answer) => set.includes(answer)));
          if (!isAsked && !agrees)
            complaints.push(`${name}: "${code[at]!.text}" for ${pair.join(' and ')}`);
        }
    }
  expect(complaints).toEqual([]);
});

it('asks in both languages', () => {
  for (const name of codeNames)
    for (const line of pseudoCode(name))
      if (line.isQuestion) expect(japanese(line), `${name}: ${line.text}`).toMatch(/か$/);
});
