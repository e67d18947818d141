// A step's sentence, made from the words of the log and the step's values.
import type { Header, Step, Value } from './log';
import { inLanguage, languages, type Language } from '../../words/language';

/** Six digits as C's %.6g; all whole digits of large numbers. */
export function general(value: number): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf';
  if (value === 0) return Object.is(value, -0) ? '-0' : '0';
  if (Math.abs(value) >= 1e5 && Math.abs(value) < 1e15) return value.toFixed(0);
  const [digits, power] = value.toExponential(5).split('e') as [string, string];
  const exponent = Number(power);
  const trimmed = (text: string) => (text.includes('.') ? text.replace(/\.?0+$/, '') : text);
  if (exponent >= -4 && exponent < 6) return trimmed(value.toFixed(5 - exponent));
  const sign = exponent < 0 ? '-' : '+';
  return `${trimmed(digits)}e${sign}${String(Math.abs(exponent)).padStart(2, '0')}`;
}

export function textOf(value: Value): string {
  if (typeof value === 'boolean') return value ? '1' : '0';
  if (typeof value === 'number') return Number.isInteger(value) ? String(value) : general(value);
  if (typeof value === 'string') return value;
  return value.length === 0 ? '–' : value.map((part) => textOf(part)).join(', ');
}

function wordOf(step: Step, name: string): string | undefined {
  const pieces = step.pieces ?? [];
  switch (name) {
    case 'pieces':
      return textOf(pieces);
    case 'first':
      return pieces[0];
    case 'second':
      return pieces[1];
  }
  if (step.window) {
    const [x, y, width, height] = step.window;
    const places: Record<string, number> = { row: y, left: x, right: x + width - 1, width, height };
    if (name in places) return String(places[name]);
  }
  const value = step.values?.[name];
  return value === undefined ? undefined : textOf(value);
}

/** What a step lacks stays in braces. */
export function sentence(header: Header, step: Step, language: Language): string {
  const { test, result } = step;
  const known = header.words[test]?.[result];
  const pattern =
    languages.get(language)?.steps?.[test]?.[result] ?? (known && inLanguage(known, language));
  if (pattern === undefined) return `${step.test}: ${step.result}`;
  return pattern.replace(/\{(\w+)\}/g, (braces, name: string) => wordOf(step, name) ?? braces);
}
