// A worker with the machine: it starts at once, from the texts in the page.
import { hasVectors, scriptAddress, textOf } from './data';
import type { Answer, Request } from './protocol';

export interface BegunWorker {
  readonly worker: Worker;
  /** Its answer to `start`. It may come before anybody asks for it: a browser drops what it tells a
   * worker's owner who does not listen yet. */
  readonly first: Promise<MessageEvent<Answer>>;
}

declare global {
  interface Window {
    /** The worker that early.ts began, until the page's script takes it. */
    begun?: BegunWorker | undefined;
  }
}

/** `compiled`: by a worker before. Its answer to the request 0 is that of the method `start`. */
export function beginWorker(compiled?: WebAssembly.Module): BegunWorker {
  const vectors = hasVectors();
  const address = scriptAddress('worker');
  const worker = new Worker(address);
  const first = new Promise<MessageEvent<Answer>>((heard) => (worker.onmessage = heard));
  const values = [compiled ?? textOf(vectors ? 'engine' : 'scalar'), vectors, textOf('scenes')];
  worker.postMessage({ number: 0, method: 'start', values } satisfies Request);
  return { worker, first };
}
