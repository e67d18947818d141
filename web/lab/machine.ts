// The machine as the page sees it: every method of the worker as a promise. A worker that is stopped,
// or whose memory is full, is ended, and another one begins with the same files.
import type { Answer, Files, Methods } from './protocol';
import MachineWorker from './worker?worker&inline';

type Result<M extends keyof Methods> = Promise<ReturnType<Methods[M]>>;

export class Machine {
  private worker: Worker | undefined;
  private number = 0;
  private readonly waiting = new Map<
    number,
    {
      method: keyof Methods;
      done: (value: unknown) => void;
      failed: (error: Error) => void;
    }
  >();
  private scene = '';

  private constructor(
    private readonly wasm: WebAssembly.Module,
    private readonly vectors: boolean,
    private files: Files,
  ) {}

  static async start(
    wasm: WebAssembly.Module,
    vectors: boolean,
    files: Files,
  ): Promise<[Machine, ReturnType<Methods['start']>]> {
    const machine = new Machine(wasm, vectors, files);
    return [machine, await machine.begin()];
  }

  private begin(): Result<'start'> {
    this.worker = new MachineWorker();
    this.worker.onmessage = (event: MessageEvent<Answer>) => {
      const { number, value, error } = event.data;
      const asked = this.waiting.get(number);
      this.waiting.delete(number);
      if (error === undefined) asked?.done(value);
      else asked?.failed(new Error(error));
      if (error?.startsWith('not enough memory')) {
        if (asked?.method === 'open') this.scene = ''; // it would fail again
        this.stop(error).catch(() => undefined); // the page has the error
      }
    };
    return this.ask('start', this.wasm, this.vectors, this.files);
  }

  ask<M extends keyof Methods>(method: M, ...values: Parameters<Methods[M]>): Result<M> {
    const number = ++this.number;
    if (method === 'open') this.scene = values[0] as string;
    return new Promise((done, failed) => {
      this.waiting.set(number, { method, done: done as (value: unknown) => void, failed });
      this.worker!.postMessage({ number, method, values });
    });
  }

  async write(files: Files): Promise<void> {
    this.files = { ...this.files, ...files };
    await this.ask('write', files);
  }

  /** Ends what the machine does now. What was asked for fails with `why`. */
  async stop(why: string): Promise<void> {
    this.worker?.terminate();
    for (const { failed } of this.waiting.values()) failed(new Error(why));
    this.waiting.clear();
    // Both before anything else that is asked meanwhile.
    const begun = this.begin();
    const opened = this.scene ? this.ask('open', this.scene) : undefined;
    await Promise.all([begun, opened]);
  }
}
