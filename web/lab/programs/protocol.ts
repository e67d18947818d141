// What the exhibit of programs asks the engine, what it answers, and the messages between the lab
// and a program's page (engine/programs/lab.js).
import type { CounterValues } from '../passes/protocol';

export interface RecordingFacts {
  /** That have frames; planes above or below one are named "window 1 overlay". */
  readonly windows: readonly string[];
  readonly window: string;
  readonly width: number;
  readonly height: number;
  readonly frames: readonly { readonly pass: number; readonly name: string }[];
}

export type StepKind = 'clear' | 'primitives' | 'pixels' | 'shown' | 'other';

export interface FrameStep {
  readonly kind: StepKind;
  readonly polygons: number;
  readonly lines: number;
  readonly points: number;
  readonly counters: CounterValues;
  /** Estimated, on a VGX. */
  readonly seconds: number;
}

export interface FrameSeen {
  readonly steps: readonly FrameStep[];
  /** That is drawn to: 'color' or 'back'. */
  readonly plane: string;
  readonly uses_depth: boolean;
  /** The machine that the times are estimated for. */
  readonly machine: string;
}

/** Of a pixel, 0 to 255 a channel; through the colour map, if there is an index. */
export interface PixelValue {
  readonly index?: number;
  readonly rgb: readonly number[];
}

/** A fragment, or a command that wrote to the pixel without one. */
export interface PixelEvent {
  readonly step: number;
  readonly command: string;
  /** Of the depth plane, before it. */
  readonly stored: number;
  /** The fragment's colour, or the one that was written. */
  readonly value: PixelValue;
  /** Of the pixel, after it. */
  readonly after: PixelValue;
  readonly fate?: string;
  readonly depth?: number;
}

declare module '../machine/protocol' {
  interface Methods {
    recording(options: { readonly file: string; readonly window: string }): RecordingFacts;
    /** Of the last recording(); plane() is then of its steps. */
    frame(options: { readonly frame: number; readonly most: number }): FrameSeen;
    /** Of the last frame(). */
    events(options: { readonly x: number; readonly y: number }): PixelEvent[];
  }
}

/** What a program is told. */
export type ToProgram =
  | { readonly what: 'look'; readonly language: string; readonly dark: boolean }
  | { readonly what: 'key'; readonly code: string; readonly key: string }
  /** Its entry from 1 is chosen; 0: the menu stays open. */
  | { readonly what: 'menu'; readonly entry: number }
  | { readonly what: 'record'; readonly frames: number };

/** What it tells. */
export type FromProgram =
  | { readonly what: 'here' | 'begun' | 'running' | 'refused' }
  | { readonly what: 'size'; readonly height: number }
  | { readonly what: 'ended'; readonly status: number }
  | { readonly what: 'recorded'; readonly bytes: Uint8Array };
