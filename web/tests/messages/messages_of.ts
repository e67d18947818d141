// The texts that C++ sources make, as templates: "has no " + key + "; expected one" is "has no {};
// expected one". Both sides of a condition are texts of their own. Does not look through variables.

const token =
  /\/\/[^\n]*|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)'|[A-Za-z_][\w:]*|[=!<>+]=|&&|\|\||->|::|[^\s]/g;
const opening = '({[';
const closing = ')}]';
const isText = (word: string | undefined): boolean => word?.startsWith('"') ?? false;

/** The places of a word outside of all brackets. */
function* placesOf(tokens: readonly string[], wanted: readonly string[]): Generator<number> {
  let depth = 0;
  for (const [i, word] of tokens.entries()) {
    if (closing.includes(word)) --depth;
    if (depth === 0 && wanted.includes(word)) yield i;
    if (opening.includes(word)) ++depth;
  }
}

function split(tokens: readonly string[], by: readonly string[]): string[][] {
  const places = [-1, ...placesOf(tokens, by), tokens.length];
  return places.slice(1).map((place, i) => tokens.slice(places[i]! + 1, place));
}

/** What stands between the brackets that open at a place. */
function inner(tokens: readonly string[], open: number): string[] {
  let depth = 0;
  for (let i = open; i < tokens.length; ++i) {
    if (opening.includes(tokens[i]!)) ++depth;
    if (closing.includes(tokens[i]!) && --depth === 0) return tokens.slice(open + 1, i);
  }
  return tokens.slice(open + 1);
}

/** The texts of one expression. */
function textsOf(tokens: readonly string[]): string[] {
  const [question] = placesOf(tokens, ['?']);
  if (question !== undefined) {
    const rest = tokens.slice(question + 1);
    let open = 1;
    const colon = [...placesOf(rest, ['?', ':'])].find(
      (i) => (open += rest[i] === '?' ? 1 : -1) === 0,
    );
    return [...textsOf(rest.slice(0, colon)), ...textsOf(rest.slice(colon! + 1))];
  }
  return split(tokens, ['+']).reduce<string[]>(
    (made, part) => made.flatMap((before) => textsOfPart(part).map((text) => before + text)),
    [''],
  );
}

function textsOfPart(part: readonly string[]): string[] {
  if (part.every(isText))
    return [part.map((word) => word.slice(1, -1).replace(/\\(.)/g, '$1')).join('')];
  const isGroup = part[0] === '(' || (/^std::string/.test(part[0] ?? '') && part[1] === '(');
  const group = isGroup ? inner(part, part[0] === '(' ? 0 : 1) : [];
  return group.some(isText) ? textsOf(group) : ['{}'];
}

/** All texts of a source. */
export function messagesOf(source: string): string[] {
  const tokens = [...source.replace(/^\s*#.*$/gm, '').matchAll(token)]
    .map(([word]) => word)
    .filter((word) => !word.startsWith('//'));
  return visited(tokens);
}

function visited(tokens: readonly string[]): string[] {
  return split(tokens, [',', ';', 'return', '=', '+=', '{', '}']).flatMap((part) => {
    const made = part.some(isText) ? textsOf(part) : [];
    const deeper = part.flatMap((word, i) =>
      opening.includes(word) ? visited(inner(part, i)) : [],
    );
    return [...made, ...deeper];
  });
}
