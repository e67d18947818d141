// Every word that one language needs, in English: what a new language starts from
// (new_language.ts), and what the tests look for in each. Articles are texts of their own.
import { readFileSync } from 'node:fs';
import { runs } from './articles/figures';
import { films } from './articles/films';
import { models } from './articles/topics';
import type { SentenceWords } from './model/steps/log';
import { en } from './words/en';
import { languages, type NameKind, type Translation } from './words/language';
import { codeNames, pseudoCode } from './words/pseudo_code';
import { quiz } from './words/quiz_en';
import { sceneLines } from './words/scenes';
import { stories } from './words/stories';

const file = process.env['GW_STEP_WORDS'] ?? '../hiddensurface/run/step_words.json';
export const stepWords = JSON.parse(readFileSync(file, 'utf8')) as SentenceWords;

const table = (names: readonly string[]): string =>
  `\n${[...new Set(names)].map((name) => `${name} | ${name}`).join('\n')}`;

/** The names that a table has: those of the machine are in no list but the Japanese. */
export const namesIn = (text = ''): string[] =>
  text
    .trim()
    .split('\n')
    .map((line) => line.split(' | ')[0]!);

const code = codeNames.flatMap((name) => pseudoCode(name).map((line) => line.text));
const labels = [
  ...Object.values(models).flatMap((model) => Object.values(model.names)),
  ...Object.values(films).flatMap((film) => film.frames.map((frame) => frame.title)),
  ...Object.values(runs).flatMap((run) => run.title ?? []),
];
const known = Object.entries(languages.get('ja')!.names!).map(([kind, text]) => [
  kind,
  table(namesIn(text)),
]);

export const everyWord: Translation = {
  name: 'English',
  words: en,
  quiz,
  stories,
  names: {
    ...(Object.fromEntries(known) as Record<NameKind, string>),
    scene: table(sceneLines),
    code: table(code),
    label: table(labels),
  },
  steps: Object.fromEntries(
    Object.entries(stepWords).map(([test, results]) => [
      test,
      Object.fromEntries(Object.entries(results).map(([result, text]) => [result, text.en])),
    ]),
  ),
};
