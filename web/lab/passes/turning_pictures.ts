// Pictures of a turning eye, from two machines in turn: while one draws, the other one begins the
// next. Only the latest request waits; a picture that is ready after a later one is dropped. Eq. 1
// has every fourth eye only, so that eq. 2 has most of the time. What is too slow is drawn with
// less.
import type { Machine } from '../machine/machine';
import type { PassesOptions } from './protocol';

export interface Turned {
  /** By eq. 1. None: the machine cannot. */
  readonly one: Uint8Array | undefined;
  readonly many: Uint8Array | undefined;
  /** Whether `many` has one sample and no rays, because the whole takes too long. */
  readonly less: boolean;
}

/** Milliseconds for a picture by eq. 2. */
const tooLong = 100;

/** An own list says itself where rays come in. */
function withLess(request: PassesOptions): PassesOptions {
  return { ...request, samples: 1, ...(request.list ? {} : { reflections: 'maps' }) };
}

export class TurningPictures {
  private twin: Machine | undefined;
  private idle: Machine[];
  private next: PassesOptions | undefined;
  private asked = 0;
  private shown = 0;
  private one: Uint8Array | undefined;
  private slow = false;

  constructor(
    private readonly machine: Machine,
    private readonly show: (turned: Turned | undefined) => void,
  ) {
    this.idle = [machine];
  }

  ask(request: PassesOptions): void {
    this.next = request;
    if (!this.twin) this.idle.push((this.twin = this.machine.twin()));
    const machine = this.idle.shift();
    if (machine) void this.work(machine);
  }

  /** What is asked for is shown no more. */
  forget(): void {
    this.next = undefined;
    this.shown = this.asked;
    this.one = undefined;
    this.show(undefined);
  }

  /** The next pictures are of other options: they are whole, unless they take too long. */
  expectQuick(): void {
    this.slow = false;
  }

  /** Ends the second machine; the next request begins another. */
  end(): void {
    this.forget();
    this.twin?.end();
    this.twin = undefined;
    this.idle = this.idle.filter((machine) => machine === this.machine);
  }

  private async inOnePass(
    machine: Machine,
    request: PassesOptions,
  ): Promise<Uint8Array | undefined> {
    try {
      return (await machine.ask('draw', { ...request, renderer: 'hardware' })).picture;
    } catch {
      return undefined;
    }
  }

  private async work(machine: Machine): Promise<void> {
    while (this.next) {
      const request = this.next;
      this.next = undefined;
      const number = ++this.asked;
      try {
        const one = number % 4 === 1 ? await this.inOnePass(machine, request) : undefined;
        const less = this.slow;
        const begun = performance.now();
        const { picture } = await machine.ask('draw', less ? withLess(request) : request);
        if (performance.now() - begun > tooLong) this.slow = true;
        if (number <= this.shown) continue;
        this.shown = number;
        this.one = one ?? this.one;
        this.show({ one: this.one, many: picture, less });
      } catch {
        // The whole run, which follows, says why.
      }
    }
    if (machine === this.machine || machine === this.twin) this.idle.push(machine);
  }
}
