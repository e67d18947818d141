import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { en } from '../words/en';
import { ja } from '../words/ja';
import { articleWords } from '../words/articles';
import { quizWords } from '../words/quiz';
import { titledAlgorithms, titleOf } from '../words/titles';

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

/** Names and formats, which are the same in both languages. */
const international = /^(GIF|PNG|SVG|RGBA?|Z|ID|VGX|[\d{}\W_])*$/;
it('has Japanese letters in every Japanese word', () => {
  const all = { ...ja, ...quizWords.ja, ...articleWords.ja };
  for (const [name, word] of Object.entries(all))
    // The button names the other language in its own.
    if (name !== 'language' && !international.test(word))
      expect(word, name).toMatch(/[\u3041-\u30fa\u4e00-\u9fff]/);
});

it('uses every word', () => {
  for (const name of Object.keys(en)) expect(sources.includes(`words.${name}`), name).toBe(true);
});

it('uses every word of a quiz', () => {
  expect(Object.keys(quizWords.ja)).toEqual(Object.keys(quizWords.en));
  for (const name of Object.keys(quizWords.en))
    expect(new RegExp(`(quiz|words|\\])\\.${name}\\b`).test(sources), name).toBe(true);
});

it('shows titles without the codes of a lecture, and a title of a student as it is', () => {
  const title = 'Newell, Newell and Sancha: five tests and splitting [L5]';
  expect(titleOf('newell', title, 'en')).toBe(
    'Newell, Newell and Sancha: five tests and splitting',
  );
  for (const name of titledAlgorithms)
    for (const language of ['en', 'ja'] as const)
      expect(titleOf(name, title, language), name).not.toMatch(/\[L\d/);
  expect(titleOf('mine', 'Mine [1] of L5', 'ja')).toBe('Mine [1] of L5');
});
