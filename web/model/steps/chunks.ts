// The additions of a log's steps to a drawing, in chunks. A step changes only the last chunk. Does
// not draw.
import type { Step } from './log';

export class Chunks<Part> {
  private readonly whole: Part[] = [];

  constructor(
    private readonly steps: readonly Step[],
    private readonly make: (steps: readonly Step[]) => Part,
    private readonly length = 1024,
  ) {}

  /** After `position` steps. The last part changes with every step. */
  upTo(position: number): Part[] {
    const count = Math.floor(position / this.length);
    for (let i = this.whole.length; i < count; ++i)
      this.whole.push(this.make(this.steps.slice(i * this.length, (i + 1) * this.length)));
    const rest = this.steps.slice(count * this.length, position);
    return [...this.whole.slice(0, count), this.make(rest)];
  }
}
