// The words of a language for what logs, counters, passes, scenes and figures name in English.
import { languages, type Language, type NameKind } from './language';

/** "name | translated", a line each. */
const readTable = (text = ''): ReadonlyMap<string, string> =>
  new Map(
    text
      .trim()
      .split('\n')
      .map((line) => line.split(' | ') as [string, string]),
  );

const tables = new Map<string, ReadonlyMap<string, string>>();
for (const [language, { names = {} }] of languages)
  for (const [kind, text] of Object.entries(names))
    tables.set(`${language} ${kind}`, readTable(text));

export const tableOf = (kind: NameKind, language: Language): ReadonlyMap<string, string> =>
  tables.get(`${language} ${kind}`) ?? new Map<string, string>();

export const translated = (kind: NameKind, name: string, language: Language): string | undefined =>
  tableOf(kind, language).get(name);

/** A name that the tables lack, such as that of a program's own value, stays as it is. */
export const nameOf = (kind: NameKind, name: string, language: Language): string =>
  translated(kind, name, language) ?? name;

/** The name of a value may depend on its test. */
export const valueName = (test: string, name: string, language: Language): string =>
  translated('value', `${test}.${name}`, language) ?? nameOf('value', name, language);

/** What the pass does; the name of its lamp, or another part that the scene names, stays. */
export function passName(name: string, language: Language): string {
  const begins = [...tableOf('pass', language)];
  const known = begins.find(([word]) => name === word || name.startsWith(`${word} `));
  return known ? known[1] + name.slice(known[0].length) : name;
}

type Rows = readonly (readonly string[])[];

/** The history of a pixel as the machine has it: heads, and in the rows pass and fate. */
export const historyNames = (rows: Rows, language: Language): Rows =>
  rows.map((row, i) =>
    row.map((cell, j) => {
      if (i === 0) return nameOf('history', cell, language);
      return j === 0 ? passName(cell, language) : nameOf('word', cell, language);
    }),
  );

/**
 * The title of an algorithm; the English one comes with the data. A student's own keeps its title.
 * The code of a lecture's row stays away: few readers have that lecture.
 */
export const titleOf = (algorithm: string, title: string, language: Language): string =>
  translated('title', algorithm, language) ?? title.replace(/ \[L\d+\]$/, '');
