// What is wrong with a program, in the reader's language: by the patterns of the command,
// hiddensurface/run/messages.LANGUAGE.json. Messages are made in English.
import type { Language } from '../../words/language';

type Pattern = readonly [RegExp, string];

const literal = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
const regular = (pattern: string): RegExp =>
  new RegExp(
    `^${pattern
      .split(/\{\d\}/)
      .map(literal)
      .join('(.+?)')}$`,
    's',
  );

const patterns = new Map<Language, readonly Pattern[]>(
  Object.entries(__GW_MESSAGES__).map(([language, messages]) => [
    language,
    Object.entries(messages).map(([pattern, words]) => [regular(pattern), words] as const),
  ]),
);

/** A message that fits no pattern, such as one of the browser or of Python, stays. */
export function messageIn(text: string, language: Language): string {
  const known = patterns.get(language) ?? [];
  const found = known.find(([pattern]) => pattern.test(text));
  if (!found) return text;
  const values = found[0].exec(text)!.slice(1);
  return found[1].replace(/\{(\d)\}/g, (_, place: string) =>
    messageIn(values[Number(place)]!, language),
  );
}
