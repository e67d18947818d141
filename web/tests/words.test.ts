import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { everyWord, namesIn, stepWords } from '../every_word';
import { en } from '../words/en';
import {
  inLanguage,
  languageFor,
  languages,
  nextLanguage,
  quizWordsOf,
  storyIn,
  wordsOf,
  type Begun,
  type Translation,
} from '../words/language';
import { nameOf, passName, titleOf } from '../words/names';
import { quiz } from '../words/quiz_en';

const folders = ['articles', 'components', 'compare', 'lab', 'model', 'player', 'quiz', 'report'];
const sources = folders
  .flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((name) => /\.(ts|svelte)$/.test(name))
      .map((name) => `${folder}/${name}`),
  )
  .map((path) => readFileSync(path, 'utf8'))
  .join('\n');

/** "words.next": what the file does not say. Sentences of steps may come with the logs. */
function lacking(wanted: unknown, given: unknown, at: string): string[] {
  if (typeof wanted === 'string') return typeof given === 'string' && given !== '' ? [] : [at];
  return Object.entries(wanted as object).flatMap(([name, part]) =>
    lacking(part, (given as Record<string, unknown> | undefined)?.[name], `${at}.${name}`),
  );
}

const files = [...languages].filter(([code]) => code !== 'en');
describe.each(files)('%s', (code, file) => {
  it('has every word', () => {
    const { steps, ...rest } = everyWord;
    const missing = Object.entries(rest).flatMap(([part, wanted]) =>
      lacking(wanted, file[part as keyof Begun], part),
    );
    for (const [test, results] of Object.entries(steps))
      for (const result of Object.keys(results))
        if (!stepWords[test]![result]![code] && !file.steps?.[test]?.[result])
          missing.push(`steps.${test}.${result}`);
    expect(missing).toEqual([]);
  });

  it('speaks of the page in the same stages of the stories', () => {
    for (const [id, stages] of Object.entries(everyWord.stories))
      for (const [name, text] of Object.entries(stages)) {
        const told = (file.stories as Record<string, Record<string, string>>)[id]![name]!;
        expect(told.split('|').length, `${id}.${name}`).toBe(text.split('|').length);
      }
  });

  it('has every line of its tables once, and none that nobody shows', () => {
    for (const [kind, wanted] of Object.entries(everyWord.names)) {
      const text = file.names?.[kind as keyof Translation['names']];
      expect(namesIn(text).sort(), kind).toEqual(namesIn(wanted).sort());
      for (const line of text!.trim().split('\n')) expect(line.split(' | '), line).toHaveLength(2);
    }
  });
});

it('finds the languages by their files', () => {
  expect([...languages.keys()].sort()).toEqual(
    ['en', ...readdirSync('words/languages').flatMap((name) => name.split('.ts', 1))]
      .filter((name, i, all) => all.indexOf(name) === i)
      .sort(),
  );
  expect(languageFor('ja-JP')).toBe('ja');
  expect(languageFor('xx')).toBe('en');
  let language = 'en';
  for (const [code] of files) expect((language = nextLanguage(language))).toBe(code);
  expect(nextLanguage(language)).toBe('en');
});

it('says in English what a language lacks', () => {
  expect(wordsOf('xx')).toEqual(en);
  expect(quizWordsOf('xx')).toEqual(quiz);
  expect(storyIn('pinwheel', 'xx')).toEqual(storyIn('pinwheel', 'en'));
  expect(nameOf('count', 'keys', 'xx')).toBe('keys');
  expect(passName('light key', 'xx')).toBe('light key');
  expect(inLanguage({ en: 'Next', ja: '次へ' }, 'xx')).toBe('Next');
});

it('leaves out of slides what a story says of the page', () => {
  expect(storyIn('pinwheel', 'en')['split']).toMatch(/^One cut opens the ring\. Positive/);
  expect(storyIn('pinwheel', 'en', true)['split']).toBe('One cut opens the ring.');
});

it('knows a file that is not whole by its type', () => {
  const begun = { name: 'X', words: { next: 'x' } } satisfies Begun;
  // @ts-expect-error: all other words are missing
  const whole: Translation = begun;
  // @ts-expect-error: no page has this word
  const unknown = { name: 'X', words: { nxt: 'x' } } satisfies Begun;
  expect(whole.name).toBe(unknown.name);
});

/** Names and formats, which are the same in both languages. */
const international = /^(GIF|PNG|SVG|RGBA?|Z|ID|VGX|[\d{}\W_])*$/;
it('has Japanese letters in every Japanese word', () => {
  for (const [name, word] of Object.entries({ ...wordsOf('ja'), ...quizWordsOf('ja') }))
    if (!international.test(word)) expect(word, name).toMatch(/[\u3041-\u30fa\u4e00-\u9fff]/);
});

it('uses every word', () => {
  for (const name of Object.keys(en)) expect(sources.includes(`words.${name}`), name).toBe(true);
});

it('uses every word of a quiz', () => {
  for (const name of Object.keys(quiz))
    expect(new RegExp(`(quiz|words|\\))\\.${name}\\b`).test(sources), name).toBe(true);
});

it('shows titles without the codes of a lecture, and a title of a student as it is', () => {
  const title = 'Newell, Newell and Sancha: five tests and splitting [L5]';
  expect(titleOf('newell', title, 'en')).toBe(
    'Newell, Newell and Sancha: five tests and splitting',
  );
  for (const name of namesIn(everyWord.names.title))
    for (const language of ['en', 'ja'])
      expect(titleOf(name, title, language), name).not.toMatch(/\[L\d/);
  expect(titleOf('mine', 'Mine [1] of L5', 'ja')).toBe('Mine [1] of L5');
});
