// Writes words/languages/CODE.ts, all of it still in English: npm run language CODE.
import { existsSync, writeFileSync } from 'node:fs';
import { everyWord } from './every_word';

/** Tables keep their lines. */
function written(value: unknown, indent = ''): string {
  if (typeof value === 'string')
    return value.includes('\n') ? `\`${value}\`` : JSON.stringify(value);
  const inner = `${indent}  `;
  const lines = Object.entries(value as Record<string, unknown>).map(
    ([name, part]) => `${inner}${JSON.stringify(name)}: ${written(part, inner)},\n`,
  );
  return `{\n${lines.join('')}${indent}}`;
}

function refuse(why: string): never {
  console.error(`npm run language CODE: ${why}`);
  process.exit(2);
}

const code = process.argv[2] ?? '';
if (!/^[a-z]{2,3}(-[A-Z]\w+)?$/.test(code))
  refuse(`'${code}' is no code; expected one as fr or pt-BR`);
const file = `words/languages/${code}.ts`;
if (existsSync(file)) refuse(`${file} is there already`);
writeFileSync(
  file,
  `// A language of the pages: its name as its readers say it, and all its words.
// Translate names to the right of a bar, and the sentences of steps outside of braces.
import type { Translation } from "../language";

export default ${written(everyWord)} satisfies Translation;
`,
);
console.log(file);
