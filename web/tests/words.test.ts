import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { en } from '../words/en';
import { ja } from '../words/ja';
import { quizWords } from '../words/quiz';

const sources = ['articles', 'components', 'compare', 'lab', 'model', 'player', 'quiz', 'report']
  .flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((name) => /\.(ts|svelte)$/.test(name))
      .map((name) => `${folder}/${name}`),
  )
  .map((path) => readFileSync(path, 'utf8'))
  .join('\n');

it('has every word in both languages', () => {
  expect(Object.keys(ja).sort()).toEqual(Object.keys(en).sort());
  for (const [name, word] of Object.entries({ ...en, ...ja })) expect(word, name).not.toBe('');
});

it('uses every word', () => {
  for (const name of Object.keys(en)) expect(sources.includes(`words.${name}`), name).toBe(true);
});

it('uses every word of a quiz', () => {
  expect(Object.keys(quizWords.ja)).toEqual(Object.keys(quizWords.en));
  for (const name of Object.keys(quizWords.en))
    expect(new RegExp(`(quiz|words|\\])\\.${name}\\b`).test(sources), name).toBe(true);
});
