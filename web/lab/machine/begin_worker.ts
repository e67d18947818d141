// A worker with the machine: it starts at once, from the texts in the page.
import { hasVectors, scriptAddress, textOf } from './data';
import type { Request } from './protocol';

declare global {
  interface Window {
    /** The worker that early.ts began, until the page's script takes it. */
    begun?: Worker | undefined;
  }
}

/** `compiled`: by a worker before. Its answer to the request 0 is that of the method `start`. */
export function beginWorker(compiled?: WebAssembly.Module): Worker {
  const vectors = hasVectors();
  const address = scriptAddress('worker');
  const worker = new Worker(address);
  const values = [compiled ?? textOf(vectors ? 'engine' : 'scalar'), vectors, textOf('scenes')];
  worker.postMessage({ number: 0, method: 'start', values } satisfies Request);
  return worker;
}
