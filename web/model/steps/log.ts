// A step log as `gw hidden --steps` writes it: lines of JSON, described in docs/step_logs.md
// and checked by steps.schema.json. y counts downwards from the picture's upper edge.
import type { Text } from '../../words/language';
import type { Point } from '../point';
import type { Blame } from './blame';

export type Level = 'polygon' | 'line' | 'span' | 'pixel';
export type Kind = 'compare' | 'decide' | 'sort' | 'split' | 'draw';

export type Loop = readonly Point[];
export type Value = boolean | number | string | readonly number[] | readonly string[];

export interface NamedOutline {
  readonly name: string;
  readonly outline: readonly Loop[];
}

/** a x + b y + z + d is the distance behind the plane; null: it is seen from its edge. */
export type Plane = readonly [number, number, number, number];

export interface HeaderPiece extends NamedOutline {
  readonly plane: Plane | null;
}

export interface Polygon {
  readonly id: number;
  readonly part: string;
  readonly color: string;
  readonly world: Loop;
  readonly nearest: number;
  readonly farthest: number;
  readonly centroid: number;
  readonly outline: readonly Loop[];
  readonly pieces: readonly HeaderPiece[];
}

export interface View {
  readonly eye: Point;
  readonly at: Point;
  readonly up: Point;
  /** Vertical, degrees. */
  readonly fov: number;
  /** Above 0: orthographic, this many world units high. */
  readonly ortho_height: number;
  readonly near: number;
  readonly far: number;
}

/** By test, by result: a sentence with the names of values in braces. */
export type SentenceWords = Readonly<Record<string, Readonly<Record<string, Text>>>>;

export interface Header {
  readonly log: 'gw hidden steps';
  readonly version: number;
  readonly algorithm: string;
  readonly title: string;
  readonly draws: 'surfaces' | 'lines';
  readonly decides: 'window' | 'world';
  readonly level: Level;
  readonly scene: string;
  readonly size: readonly [number, number];
  /** Units of the window grid in a pixel. */
  readonly unit: number;
  /** The farthest value of the depth plane. */
  readonly depth: number;
  readonly view: View;
  readonly background: string;
  readonly words: SentenceWords;
  readonly polygons: readonly Polygon[];
}

/** Pixels x0 .. x1 - 1 of row y get an identifier. */
export type Painted = readonly [y: number, x0: number, x1: number, id: number];
/** x, y, width, height in pixels. */
export type Window = readonly [number, number, number, number];

export interface DrawnLine {
  readonly from: Point;
  readonly to: Point;
  readonly visible: readonly (readonly [number, number])[];
}

export interface Step {
  readonly step: number;
  readonly level: Level;
  readonly kind: Kind;
  readonly test: string;
  readonly result: string;
  readonly pieces?: readonly string[];
  readonly decisive?: boolean;
  readonly window?: Window;
  readonly values?: Readonly<Record<string, Value>>;
  readonly painted?: readonly Painted[];
  readonly made?: readonly NamedOutline[];
  readonly line?: DrawnLine;
  /** Counters that changed since the last step. */
  readonly counts?: Readonly<Record<string, number>>;
}

export interface Log {
  readonly header: Header;
  readonly steps: readonly Step[];
  /** All counts of the run; empty if the log ends early. */
  readonly totals: Readonly<Record<string, number>>;
  /** Of wrong pixels; empty for a right picture. */
  readonly blame: readonly Blame[];
  /** The log has its last line. */
  readonly whole: boolean;
}

interface End {
  readonly end: number;
  readonly counts: Readonly<Record<string, number>>;
  readonly blame?: readonly Blame[];
}

export class LogError extends Error {}

function isHeader(value: unknown): value is Header {
  return (
    typeof value === 'object' && value !== null && 'log' in value && value.log === 'gw hidden steps'
  );
}

function parseLine(line: string, number: number): unknown {
  try {
    return JSON.parse(line);
  } catch (error) {
    throw new LogError(`line ${number}: ${(error as Error).message}; expected a line of JSON`);
  }
}

/** Reads a log piece by piece. Throws LogError "line N: what; expected what". */
export class LogReader {
  private rest = '';
  private lines = 0;
  private header: Header | undefined;
  private readonly steps: Step[] = [];
  private end: End | undefined;

  add(piece: string): void {
    const lines = (this.rest + piece).split('\n');
    this.rest = lines.pop()!;
    for (const line of lines) this.addLine(line);
  }

  /** After the last piece. */
  log(): Log {
    if (this.rest !== '' || this.lines === 0) this.addLine(this.rest);
    this.rest = '';
    return {
      header: this.header!,
      steps: this.steps,
      totals: this.end?.counts ?? {},
      blame: this.end?.blame ?? [],
      whole: this.end !== undefined,
    };
  }

  private addLine(line: string): void {
    if (this.end) return;
    const value = parseLine(line, ++this.lines);
    if (this.lines === 1) this.begin(value);
    else this.addStep(value as Step | End);
  }

  private begin(value: unknown): void {
    if (!isHeader(value))
      throw new LogError('line 1: not a header; expected a file that gw hidden --steps wrote');
    if (value.version !== 1)
      throw new LogError(`line 1: version ${value.version}; this page reads version 1`);
    this.header = value;
  }

  private addStep(value: Step | End): void {
    if ('end' in value) this.end = value;
    else if (typeof value.step !== 'number' || typeof value.kind !== 'string')
      throw new LogError(`line ${this.lines}: not a step; expected "step" and "kind"`);
    else this.steps.push(value);
  }
}

export async function readLog(pieces: AsyncIterable<string> | Iterable<string>): Promise<Log> {
  const reader = new LogReader();
  for await (const piece of pieces) reader.add(piece);
  return reader.log();
}

export function parseLog(text: string): Log {
  const reader = new LogReader();
  reader.add(text);
  return reader.log();
}

/** The identifier of a piece's polygon: "12ab" and "12.1" belong to 12. */
export function polygonOf(piece: string): number {
  return Number.parseInt(piece, 10);
}
