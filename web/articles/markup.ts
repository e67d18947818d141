// Reads the text of an article. README.md describes the marks. Does not know which figures exist.

/** A step by what it asks, by its answer, by the pieces in question, and the how-manieth it is. */
export interface StepName {
  readonly test: string;
  readonly result: string;
  readonly pieces: readonly string[];
  readonly nth: number;
}

export type Part =
  | { readonly kind: 'text' | 'strong'; readonly text: string }
  | {
      readonly kind: 'piece';
      readonly text: string;
      readonly figure: string;
      readonly name: string;
    }
  | {
      readonly kind: 'step';
      readonly text: string;
      readonly figure: string;
      readonly step: StepName;
    }
  | {
      readonly kind: 'number';
      readonly figure: string;
      readonly step: StepName | undefined;
      readonly name: string;
    };
export type Line = readonly Part[];

export interface Answer {
  readonly right: boolean;
  readonly text: Line;
  readonly feedback: Line;
}

export interface Exercise {
  readonly question: Line;
  /** To choose from; none: a number is asked. */
  readonly answers: readonly Answer[];
  readonly number?: { readonly wanted: Part & { kind: 'number' }; readonly feedback: Line };
}

export interface Section {
  readonly heading: string;
  readonly figure: string | undefined;
  readonly caption: Line;
  readonly paragraphs: readonly Line[];
}

export interface ArticleText {
  readonly title: string;
  readonly lead: Line;
  readonly sections: readonly Section[];
  readonly exercises: readonly Exercise[];
}

export class MarkupError extends Error {}

/** "test/result", "test/result:3,1", "test/result~2". */
export function stepNameOf(text: string): StepName {
  const found = /^([\w'-]+)\/([\w'-]+)(?::([\w.,]+))?(?:~(\d+))?$/.exec(text);
  if (!found) throw new MarkupError(`step '${text}'; expected test/result:pieces~number`);
  const [, test, result, pieces, nth] = found;
  return { test: test!, result: result!, pieces: pieces?.split(',') ?? [], nth: Number(nth ?? 1) };
}

const bound = /\[(?<words>[^\]]+)\]\((?<figure>[\w-]+)(?<how>[#@])(?<what>[^)]+)\)/;
const numbered = /\{(?<of>[\w-]+)(?:@(?<at>[^{}|]+)\||:)(?<name>[\w.-]+)\}/;
const strongly = /\*(?<strong>[^*]+)\*/;
const marks = new RegExp([bound, numbered, strongly].map(({ source }) => source).join('|'), 'gu');

export function lineOf(text: string): Line {
  const parts: Part[] = [];
  let end = 0;
  for (const found of text.matchAll(marks)) {
    if (found.index > end) parts.push({ kind: 'text', text: text.slice(end, found.index) });
    end = found.index + found[0].length;
    const { words, figure, how, what, of, at, name, strong } = found.groups!;
    if (strong) parts.push({ kind: 'strong', text: strong });
    else if (words && how === '#')
      parts.push({ kind: 'piece', text: words, figure: figure!, name: what! });
    else if (words)
      parts.push({ kind: 'step', text: words, figure: figure!, step: stepNameOf(what!) });
    else
      parts.push({
        kind: 'number',
        figure: of!,
        step: at ? stepNameOf(at) : undefined,
        name: name!,
      });
  }
  if (end < text.length) parts.push({ kind: 'text', text: text.slice(end) });
  const left = parts.find((part) => 'text' in part && /[[\]{}]/.test(part.text));
  if (left) throw new MarkupError(`a mark that is none in '${text}'`);
  return parts;
}

/** Feedback follows "::". */
function withFeedback(text: string): [Line, Line] {
  const [before, after, ...rest] = text.split('::');
  if (after === undefined || rest.length > 0)
    throw new MarkupError(`'${text}'; expected an answer, ::, and feedback`);
  return [lineOf(before!.trim()), lineOf(after.trim())];
}

/** A line that begins with no sign goes on with the one before. */
const folded = (lines: readonly string[]): string[] =>
  joined(lines.join('\n').replace(/\n(?=[-+=] )/g, '\v')).split('\v');

function exerciseOf(block: readonly string[]): Exercise {
  const lines = folded(block);
  const question = lineOf(lines[0]!.slice(2));
  const answers: Answer[] = [];
  for (const line of lines.slice(1)) {
    const [answer, feedback] = withFeedback(line.slice(2));
    if (line.startsWith('= ')) {
      const wanted = answer[0];
      if (wanted?.kind !== 'number' || answer.length > 1)
        throw new MarkupError(`'${line}'; expected = {figure:name} :: feedback`);
      return { question, answers: [], number: { wanted, feedback } };
    }
    if (!/^[+-] /.test(line)) throw new MarkupError(`'${line}'; expected + or - and an answer`);
    answers.push({ right: line.startsWith('+'), text: answer, feedback });
  }
  if (answers.length < 2 || answers.filter(({ right }) => right).length !== 1)
    throw new MarkupError(`'${lines[0]}'; expected one right answer and wrong ones`);
  return { question, answers };
}

export function readArticle(source: string): ArticleText {
  const blocks = source
    .split(/\n\s*\n/)
    .map((block) => block.trim().split('\n'))
    .filter((block) => block[0] !== '');
  let title = '';
  let lead: Line = [];
  const sections: { -readonly [Key in keyof Section]: Section[Key] }[] = [];
  const exercises: Exercise[] = [];
  for (const lines of blocks) {
    const first = lines[0]!;
    const text = lines.join('\n');
    if (first.startsWith('# ')) title = first.slice(2);
    else if (first.startsWith('> ')) lead = lineOf(joined(text.replaceAll(/^> /gm, '')));
    else if (first.startsWith('## '))
      sections.push({ heading: first.slice(3), figure: undefined, caption: [], paragraphs: [] });
    else if (first.startsWith('? ')) exercises.push(exerciseOf(lines));
    else {
      const section = sections.at(-1);
      if (!section) throw new MarkupError(`'${first}'; expected ## and a heading before it`);
      const figure = /^@([\w-]+) ([^]+)$/.exec(text);
      if (figure) {
        section.figure = figure[1];
        section.caption = lineOf(joined(figure[2]!));
      } else section.paragraphs = [...section.paragraphs, lineOf(joined(text))];
    }
  }
  if (title === '' || lead.length === 0) throw new MarkupError('expected # title and > lead');
  return { title, lead, sections, exercises };
}

/** Lines of one paragraph: Japanese ones without a blank between them. */
const joined = (text: string): string =>
  text
    .replace(/(?<=[\u3000-\u9fff）])\n(?=[\u3000-\u9fff（])/gu, '')
    .replace(/(?<=[、。」）])\n|\n(?=[「（])/gu, '')
    .replaceAll('\n', ' ');

/** All lines of an article. */
export function linesOf(text: ArticleText): Line[] {
  return [
    text.lead,
    ...text.sections.flatMap((section) => [section.caption, ...section.paragraphs]),
    ...text.exercises.flatMap(({ question, answers, number }) => [
      question,
      ...answers.flatMap((answer) => [answer.text, answer.feedback]),
      ...(number ? [[number.wanted], number.feedback] : []),
    ]),
  ];
}
