// A log played forwards and backwards: the picture, the counters, the order and the outlines of all
// pieces after any step. Keyframes bound the time of a jump. Does not draw.
import { clamped } from '../numbers';
import { polygonOf, type Log, type Loop, type Step } from './log';

const keyframes = 64;

interface Keyframe {
  readonly ids: Uint32Array;
  readonly counts: ReadonlyMap<string, number>;
}

interface Made {
  readonly step: number;
  readonly outline: readonly Loop[];
}

export class Replay {
  readonly width: number;
  readonly height: number;
  /** Identifiers by pixel, the upper row first. */
  readonly ids: Uint32Array;
  private done = 0;
  private readonly interval: number;
  private readonly frames: Keyframe[] = [];
  private counts = new Map<string, number>();
  /** By the number of steps done: the last Sort among them, else -1. */
  private readonly sorts: Int32Array;
  private readonly outlines = new Map<string, Made[]>();
  /** Steps done when a piece was first drawn. */
  private readonly draws = new Map<string, number>();

  constructor(readonly log: Log) {
    [this.width, this.height] = log.header.size;
    this.ids = new Uint32Array(this.width * this.height);
    this.interval = Math.max(1, Math.ceil(log.steps.length / keyframes));
    this.sorts = new Int32Array(log.steps.length + 1).fill(-1);
    for (const polygon of log.header.polygons) {
      this.addOutline(String(polygon.id), 0, polygon.outline);
      for (const piece of polygon.pieces) this.addOutline(piece.name, 0, piece.outline);
    }
    this.keep();
    for (let i = 0; i < log.steps.length; ++i) {
      const step = log.steps[i]!;
      this.sorts[i + 1] = step.kind === 'sort' ? i : this.sorts[i]!;
      if (step.kind === 'draw')
        for (const piece of step.pieces ?? [])
          if (!this.draws.has(piece)) this.draws.set(piece, i + 1);
      for (const made of step.made ?? []) this.addOutline(made.name, i + 1, made.outline);
      this.apply(step);
      this.done = i + 1;
      if (this.done % this.interval === 0) this.keep();
    }
  }

  /** Steps done. */
  get position(): number {
    return this.done;
  }

  /** The state after `steps` steps, 0 to all. */
  seek(steps: number): void {
    const wanted = Math.min(Math.max(0, Math.trunc(steps)), this.log.steps.length);
    const frame = Math.floor(wanted / this.interval);
    if (wanted < this.done || frame * this.interval > this.done) {
      const kept = this.frames[frame]!;
      this.ids.set(kept.ids);
      this.counts = new Map(kept.counts);
      this.done = frame * this.interval;
    }
    for (; this.done < wanted; ++this.done) this.apply(this.log.steps[this.done]!);
  }

  /** The step done last; none at the beginning. */
  step(): Step | undefined {
    return this.log.steps[this.done - 1];
  }

  /** After the last step those of the whole run. */
  count(name: string): number {
    const atEnd = this.done === this.log.steps.length ? this.log.totals[name] : undefined;
    return atEnd ?? this.counts.get(name) ?? 0;
  }
  /** Whether steps count it, not only the whole run. */
  isCounted(name: string): boolean {
    return this.frames.at(-1)!.counts.has(name) || this.counts.has(name);
  }
  countNames(): string[] {
    return [...new Set([...Object.keys(this.log.totals), ...this.frames.at(-1)!.counts.keys()])];
  }

  /** The last Sort done; none before the first. */
  order(): Step | undefined {
    return this.log.steps[this.sorts[this.done]!];
  }

  /** A piece's outline after the steps done; empty if it is unknown. */
  outline(name: string): readonly Loop[] {
    const found = this.outlines.get(name) ?? this.outlines.get(String(polygonOf(name))) ?? [];
    return (found.findLast((made) => made.step <= this.done) ?? found[0])?.outline ?? [];
  }

  /** Whether a step done has drawn the piece. */
  isDrawn(piece: string): boolean {
    return (this.draws.get(piece) ?? Infinity) <= this.done;
  }

  idAt(x: number, y: number): number {
    return this.ids[y * this.width + x] ?? 0;
  }

  private addOutline(name: string, step: number, outline: readonly Loop[]): void {
    const known = this.outlines.get(name);
    if (known) known.push({ step, outline });
    else this.outlines.set(name, [{ step, outline }]);
  }

  private keep(): void {
    this.frames.push({ ids: this.ids.slice(), counts: new Map(this.counts) });
  }

  private apply(step: Step): void {
    for (const [y, x0, x1, id] of step.painted ?? [])
      this.ids.fill(id, y * this.width + x0, y * this.width + x1);
    const changed = step.counts;
    for (const name in changed) this.counts.set(name, changed[name]!);
  }
}

/** The first step after `from` (or before it, if `by` is -1) that fits; -1: none. As steps done. */
export function nextWhere(
  steps: readonly Step[],
  from: number,
  by: 1 | -1,
  fits: (step: Step) => boolean,
): number {
  for (let done = from + by; done >= 1 && done <= steps.length; done += by)
    if (fits(steps[done - 1]!)) return done;
  return -1;
}

/** Steps done after one more or less, or at the next decisive step, if there is one. */
export function moved(steps: readonly Step[], from: number, by: 1 | -1, decisive: boolean): number {
  if (!decisive) return clamped(from + by, 0, steps.length);
  const found = nextWhere(steps, from, by, (step) => step.decisive === true);
  return found >= 0 ? found : from;
}

/** Whether a step asks for this pixel or paints it. */
export function touches(step: Step, x: number, y: number): boolean {
  if (step.painted) return step.painted.some(([row, x0, x1]) => row === y && x0 <= x && x < x1);
  if (!step.window) return false;
  const [left, top, width, height] = step.window;
  return x >= left && x < left + width && y >= top && y < top + height;
}
