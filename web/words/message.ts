// What is wrong, in the reader's language: by its table of errors and, in the lab, by the patterns
// of the command, hiddensurface/run/messages.LANGUAGE.json. Messages are made in English.
import type { Language } from './language';
import { tableOf } from './names';

type Pattern = readonly [RegExp, string];

const literal = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
const regular = (pattern: string): RegExp =>
  new RegExp(
    `^${pattern
      .split(/\{\d\}/)
      .map(literal)
      .join('(.+?)')}$`,
  );

const commands = typeof __GW_MESSAGES__ === 'undefined' ? {} : __GW_MESSAGES__;
const known = new Map<Language, readonly Pattern[]>();
function patternsOf(language: Language): readonly Pattern[] {
  const made =
    known.get(language) ??
    [...Object.entries(commands[language] ?? {}), ...tableOf('error', language)].map(
      ([pattern, words]) => [regular(pattern), words] as const,
    );
  known.set(language, made);
  return made;
}

/** Longer lines are not ours. */
const longest = 400;

function said(line: string, patterns: readonly Pattern[]): string {
  const found = patterns.find(([pattern]) => pattern.test(line));
  if (!found) return line;
  const values = found[0].exec(line)!.slice(1);
  return found[1].replace(/('?)\{(\d)\}/g, (_, quote: string, place: string) => {
    const value = values[Number(place)]!;
    return quote + (quote ? value : said(value, patterns));
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
