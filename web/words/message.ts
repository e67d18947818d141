// What is wrong, in the reader's language: by its table of errors and, in the lab, by the patterns
// of the command, hiddensurface/run/messages.LANGUAGE.json. Messages are made in English.
import type { Language } from './language';
import { tableOf } from './names';

interface Pattern {
  readonly fits: RegExp;
  readonly words: string;
  readonly rank: number;
  /** No program of a student says it so. */
  readonly isOurs: boolean;
  /** It fits much that a program may say, so it stands for parts of the above only. */
  readonly isPart: boolean;
}

const literal = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
function patternOf(english: string, words: string): Pattern {
  const parts = english.split(/\{\d\}/);
  const letters = parts.join('').length;
  const isPlace = /^(\{0\}\.\w+|steps\.jsonl|step|line)\b.*: \{\d\}$/.test(english);
  const isWhole = english.includes('; expected ');
  return {
    fits: new RegExp(`^${parts.map(literal).join('(.+?)')}$`),
    words,
    rank: isPlace ? 1000 - letters : letters + (isWhole ? 2000 : 0),
    isOurs: isWhole || letters > 20,
    isPart: /^'?\{0\}/.test(english) && letters < 10 && !isPlace,
  };
}

const commands = typeof __GW_MESSAGES__ === 'undefined' ? {} : __GW_MESSAGES__;
const known = new Map<Language, readonly Pattern[]>();
function patternsOf(language: Language): readonly Pattern[] {
  const made =
    known.get(language) ??
    [...Object.entries(commands[language] ?? {}), ...tableOf('error', language)]
      .map(([english, words]) => patternOf(english, words))
      .sort((a, b) => b.rank - a.rank);
  known.set(language, made);
  return made;
}

/** Longer lines are not ours. */
const longest = 400;

/** The first pattern that fits: a whole, then a place in a file, then that with most letters. */
function said(line: string, patterns: readonly Pattern[], isPart = false): string {
  const found = patterns.find((pattern) => (isPart || !pattern.isPart) && pattern.fits.test(line));
  if (!found) return line;
  const values = found.fits.exec(line)!.slice(1);
  return found.words.replace(/('?)\{(\d)\}/g, (_, quote: string, place: string) => {
    const value = values[Number(place)]!;
    return quote + (quote ? value : said(value, patterns, isPart || found.isOurs));
  });
}

/**
 * Line by line. A line that fits no pattern, such as a program's own, stays; so does what stands
 * between quotation marks.
 */
export const messageIn = (text: string, language: Language): string =>
  text
    .split('\n')
    .map((line) => (line.length > longest ? line : said(line, patternsOf(language))))
    .join('\n');
