// The worker of a program in Python: MicroPython, whose module the page has as text.
import { loadMicroPython } from '@micropython/micropython-webassembly-pyscript/micropython.mjs';
import { unpackedAs } from '../../model/packed';
import { mostSteps, network } from './limits';
import type { PythonTask, Said } from './program';

const heap = 128 * 1024 * 1024; // bytes

/** The program has a name of its own, which its lines have in messages. */
const before = `
import json
def run_program():
    def step(members=None, **more):
        say_step(json.dumps(dict(members or {}, **more)))
    names = {'scene': json.loads(polygons), 'step': step, '__name__': '__main__'}
    exec(compile(text, 'program', 'exec'), names)
`;

function asError(error: unknown): Said {
  const message = error instanceof Error ? error.message : String(error);
  const lines = message.split('\n').filter((line) => line.trim() !== '');
  const places = [...message.matchAll(/File "program", line (\d+)/g)];
  return { wrong: lines.at(-1) ?? message, line: Number(places.at(-1)?.[1] ?? 0) };
}

async function run({ text, polygons, module }: PythonTask): Promise<Said> {
  const names = self as unknown as Record<string, unknown>;
  names.fetch = () => Promise.resolve(unpackedAs(module, 'application/wasm'));
  const python = await loadMicroPython({ url: 'micropython.wasm', heapsize: heap });
  for (const name of network) names[name] = undefined;
  const steps: string[] = [];
  python.globals.set('text', text);
  python.globals.set('polygons', polygons);
  python.globals.set('say_step', (step: string) => {
    if (steps.push(step) > mostSteps) throw new RangeError(`more than ${mostSteps} steps`);
  });
  python.runPython(before);
  python.runPython('run_program()');
  return { steps };
}

self.onmessage = ({ data }: MessageEvent<PythonTask>) => {
  void run(data)
    .catch(asError)
    .then((said) => self.postMessage(said));
};
