// The page's side of the machine: no answer of its worker is lost.
import { expect, it, vi } from 'vitest';
import { beginWorker } from '../lab/machine/begin_worker';
import { Machine } from '../lab/machine/machine';
import type { Request } from '../lab/machine/protocol';

/** Answers at once, to whoever listens then, with what it was asked. */
class QuickWorker {
  onmessage: ((event: { data: unknown }) => void) | null = null;
  postMessage({ number, method }: Request): void {
    setTimeout(() => this.onmessage?.({ data: { number, value: { method } } }), 0);
  }
  terminate(): void {
    this.onmessage = null;
  }
}

const soon = () => new Promise((done) => setTimeout(done, 5));

vi.stubGlobal('Worker', QuickWorker);
vi.stubGlobal('document', { getElementById: () => null });

it('hears a worker that has started before the page listens', async () => {
  const begun = beginWorker();
  await soon();
  const machine = new Machine(begun);
  expect(await machine.started).toEqual({ method: 'start' });
  expect(await machine.ask('recording', { file: '', window: '' })).toEqual({ method: 'recording' });
});

it('hears a worker that starts later, and what was asked meanwhile', async () => {
  const machine = new Machine(beginWorker());
  const asked = machine.ask('recording', { file: '', window: '' });
  expect(await machine.started).toEqual({ method: 'start' });
  expect(await asked).toEqual({ method: 'recording' });
});

it('begins again after a stop', async () => {
  const machine = new Machine(beginWorker());
  await machine.stop('stopped');
  expect(await machine.started).toEqual({ method: 'start' });
  expect(await machine.ask('recording', { file: '', window: '' })).toEqual({ method: 'recording' });
});
