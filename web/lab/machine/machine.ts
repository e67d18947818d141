// The machine as the page sees it: every method of the worker as a promise. A worker that is
// stopped, or whose memory is full, is ended, and another one begins with the same files.
import { beginWorker, type BegunWorker } from './begin_worker';
import { folder } from './data';
import type { Answer, Files, Methods } from './protocol';

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
  private module: WebAssembly.Module | undefined;
  private files: Files = {}; // beside the page's scenes
  /** What the last answer warns of, if it is a picture's. */
  onwarnings: ((warnings: readonly string[]) => void) | undefined;
  /** The first worker's answer; later ones give the same. */
  readonly started: Result<'start'>;

  /** The worker begins by itself: it has been asked to start. */
  constructor(begun: BegunWorker) {
    this.started = this.begin(begun);
    this.started.then(
      ({ module }) => (this.module = module),
      () => undefined, // the page has the error
    );
  }

  private begin({ worker, first }: BegunWorker): Result<'start'> {
    this.worker = worker;
    const take = (event: MessageEvent<Answer>): void => {
      const { number, value, error } = event.data;
      const asked = this.waiting.get(number);
      this.waiting.delete(number);
      if (asked && asked.method !== 'open') this.hear(value);
      if (error === undefined) asked?.done(value);
      else asked?.failed(new Error(error.replaceAll(folder, '')));
      if (error?.startsWith('not enough memory')) {
        if (asked?.method === 'open') this.scene = ''; // it would fail again
        this.stop(error).catch(() => undefined); // the page has the error
      }
    };
    void first.then((event) => {
      worker.onmessage = take;
      take(event);
    });
    return new Promise((done, failed) => {
      this.waiting.set(0, { method: 'start', done: done as (value: unknown) => void, failed });
    });
  }

  private hear(value: unknown): void {
    if (typeof value !== 'object' || value === null || !('warnings' in value)) return;
    this.onwarnings?.(value.warnings as readonly string[]);
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

  /** Another machine with the same files and scene. */
  twin(): Machine {
    const twin = new Machine(beginWorker(this.module));
    twin.onwarnings = (warnings) => this.onwarnings?.(warnings);
    twin.write(this.files).catch(() => undefined); // what is asked for next fails
    twin.ask('open', this.scene).catch(() => undefined);
    return twin;
  }
  /** Nothing is answered any more. */
  end(): void {
    this.worker?.terminate();
  }

  /** Ends what the machine does now. What was asked for fails with `why`. */
  async stop(why: string): Promise<void> {
    this.worker?.terminate();
    const unanswered = [...this.waiting.values()];
    this.waiting.clear();
    // All three before anything else that is asked meanwhile.
    const begun = this.begin(beginWorker(this.module));
    const written = this.ask('write', this.files);
    const opened = this.scene ? this.ask('open', this.scene) : undefined;
    for (const { method, done, failed } of unanswered)
      if (method === 'start') done(begun);
      else failed(new Error(why));
    await Promise.all([begun, written, opened]);
  }
}
