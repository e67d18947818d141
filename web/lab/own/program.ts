// Runs a program of the visitor: JavaScript in a worker of its own, with a time limit and without
// the network. It gets the polygons as `scene` and says its steps by `step({...})`.

export interface Program {
  /** The steps, one line of JSON each. */
  readonly steps: string[];
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

export const mostSteps = 200_000;

/** All before the program stands in its first line, so that lines keep their numbers. */
const before = (polygons: string): string =>
  'for (const name of ["fetch", "XMLHttpRequest", "WebSocket", "EventSource", "importScripts"]) self[name] = undefined;' +
  `const scene = ${polygons.trim()}; const stepsSaid = [];` +
  `function step(members) { if (stepsSaid.push(JSON.stringify(members)) > ${mostSteps}) throw new RangeError("more than ${mostSteps} steps"); }`;

export function runProgram(text: string, polygons: string, seconds: number): Promise<Program> {
  const source = `${before(polygons.replaceAll('\n', ' '))}${text}\n;self.postMessage(stepsSaid);`;
  const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
  const worker = new Worker(url);
  return new Promise<Program>((done, failed) => {
    const timer = setTimeout(
      () => failed(new ProgramError(`no end after ${seconds} s`, 0)),
      seconds * 1000,
    );
    worker.onmessage = (event: MessageEvent<string[]>) => {
      clearTimeout(timer);
      done({ steps: event.data });
    };
    worker.onerror = (event) => {
      event.preventDefault();
      clearTimeout(timer);
      failed(new ProgramError(event.message.replace(/^Uncaught /, ''), event.lineno));
    };
  }).finally(() => {
    worker.terminate();
    URL.revokeObjectURL(url);
  });
}
