// The languages of the pages. The build finds them: each file of languages/ is one, and its name is
// the language's code. What a language lacks is said in English.
import { en, type Words } from './en';
import { quiz, type QuizWords } from './quiz_en';
import { stories, type Stories } from './stories';

/** The code: en, ja, or the name of another file. */
export type Language = string;

/** Words that come with data; those of the commands have English and Japanese. */
export type Text = Readonly<{ en: string }> & Readonly<Record<Language, string>>;

/** What English is translated by tables of lines, "English | translated". */
export type NameKind =
  | 'count' // counters of algorithms
  | 'machine' // counters of the machine
  | 'value' // of a step
  | 'pass' // how names of passes begin
  | 'history' // heads of the history of a pixel
  | 'key' // of a parameter set
  | 'word' // single words of the machine
  | 'title' // of algorithms, by name: "newell | ..."
  | 'scene' // lines and groups of scenes
  | 'code' // lines of algorithms
  | 'label' // of the articles' figures
  | 'error'; // how messages read, with {0}, {1}, ...: of JavaScript, Python, and files of scenes

/** All that one file says. */
export interface Translation {
  /** As its readers call it. */
  readonly name: string;
  readonly words: Words;
  readonly quiz: QuizWords;
  readonly stories: { readonly [Id in keyof Stories]: Readonly<Record<keyof Stories[Id], string>> };
  readonly names: Readonly<Record<NameKind, string>>;
  /** Sentences of steps by test and result; those that the logs have need not be here. */
  readonly steps: Readonly<Record<string, Readonly<Record<string, string>>>>;
}

type Partly<T> = T extends string ? string : { readonly [Key in keyof T]?: Partly<T[Key]> };
/** A file of which parts are still missing. */
export type Begun = Partly<Translation> & Pick<Translation, 'name'>;

const files = import.meta.glob<Begun>('./languages/*.ts', { import: 'default', eager: true });
const english: Begun = { name: 'English', words: en, quiz, stories };

export const languages: ReadonlyMap<Language, Begun> = new Map([
  ['en', english],
  ...Object.entries(files).map(([path, file]) => [/([\w-]+)\.ts$/.exec(path)![1]!, file] as const),
]);

/** The language of a reader who prefers `wanted` ("ja-JP"). */
export const languageFor = (wanted: string): Language =>
  [...languages.keys()].find((code) => new RegExp(`^${code}\\b`, 'i').test(wanted)) ?? 'en';

export function nextLanguage(language: Language): Language {
  const codes = [...languages.keys()];
  return codes[(codes.indexOf(language) + 1) % codes.length]!;
}

/** Once for each language: an object that stays the same. */
function kept<Value>(make: (file: Begun) => Value): (language: Language) => Value {
  const made = new Map<Language, Value>();
  return (language) => {
    const value = made.get(language) ?? make(languages.get(language) ?? english);
    made.set(language, value);
    return value;
  };
}

export const wordsOf = kept((file): Words => ({ ...en, ...file.words }));
export const quizWordsOf = kept((file): QuizWords => ({ ...quiz, ...file.quiz }));

/** A slide has no page to speak of. */
export function storyIn(
  id: keyof Stories,
  language: Language,
  isSlide = false,
): Readonly<Record<string, string>> {
  const told = { ...stories[id], ...languages.get(language)?.stories?.[id] };
  const said = (text: string): string =>
    isSlide ? text.split('|', 1)[0]!.trim() : text.replace('|', '');
  return Object.fromEntries(Object.entries(told).map(([name, text]) => [name, said(text)]));
}

export const inLanguage = (text: Text, language: Language): string => text[language] ?? text.en;
