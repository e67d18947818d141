// Runs a program of the visitor in a worker of its own, with a time limit and without the network.
// It gets the polygons as `scene` and says its steps: by step({...}), in Python also by step(...).
import { scriptAddress, textOf } from '../machine/data';
import { mostSteps, network } from './limits';

export type Language = 'javascript' | 'python';
export const languages: Readonly<Record<Language, string>> = {
  javascript: 'JavaScript',
  python: 'Python',
};

export interface Program {
  /** The steps, one line of JSON each. */
  readonly steps: string[];
}
/** What a worker says at the end. */
export type Said = Program | { readonly wrong: string; readonly line: number };

/** What the worker of a program in Python is told. */
export interface PythonTask {
  readonly text: string;
  readonly polygons: string;
  /** MicroPython's WebAssembly, packed. */
  readonly module: string;
}

export class ProgramError extends Error {
  constructor(
    message: string,
    /** 1, 2, ...; 0: unknown. */
    readonly line: number,
  ) {
    super(message);
  }
}

/** How long a program may run, and what ends it earlier. */
export interface Limits {
  readonly seconds: number;
  readonly ended: AbortSignal;
}

/** Ends the worker of a script when it has said its steps or an error, or at its limits. */
function said(address: string, task: unknown, { seconds, ended }: Limits): Promise<Program> {
  const worker = new Worker(address);
  return new Promise<Program>((done, failed) => {
    const end = (): void => failed(ended.reason as Error);
    if (ended.aborted) end();
    ended.addEventListener('abort', end);
    const timer = setTimeout(
      () => failed(new ProgramError(`no end after ${seconds} s`, 0)),
      seconds * 1000,
    );
    worker.onmessage = ({ data }: MessageEvent<Said>) => {
      clearTimeout(timer);
      if ('steps' in data) done(data);
      else failed(new ProgramError(data.wrong, data.line));
    };
    worker.onerror = (event) => {
      event.preventDefault();
      clearTimeout(timer);
      // A script that does not start has an event without words.
      const message = (event.message as string | undefined) ?? 'the program did not start';
      failed(new ProgramError(message.replace(/^Uncaught /, ''), event.lineno));
    };
    worker.postMessage(task);
  }).finally(() => {
    worker.terminate();
    URL.revokeObjectURL(address);
  });
}

/** All before the program stands in its first line, so that lines keep their numbers. */
const before = (polygons: string): string =>
  `for (const name of ${JSON.stringify(network)}) self[name] = undefined;` +
  `const scene = ${polygons.trim()}; const stepsSaid = [];` +
  `function step(members) { if (stepsSaid.push(JSON.stringify(members)) > ${mostSteps}) throw new RangeError("more than ${mostSteps} steps"); }`;

const addressOf = (javascript: string): string =>
  URL.createObjectURL(new Blob([javascript], { type: 'text/javascript' }));

export function runProgram(
  language: Language,
  text: string,
  polygons: string,
  limits: Limits,
): Promise<Program> {
  if (language === 'python') {
    const task: PythonTask = { text, polygons, module: textOf('micropython') };
    return said(scriptAddress('python'), task, limits);
  }
  const source = `${before(polygons.replaceAll('\n', ' '))}${text}\n;self.postMessage({ steps: stepsSaid });`;
  return said(addressOf(source), undefined, limits);
}
