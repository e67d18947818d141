import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { en } from '../words/en';
import { ja } from '../words/ja';
import { articleWords } from '../words/articles';
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
