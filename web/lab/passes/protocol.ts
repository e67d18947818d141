// What the exhibit of passes asks the engine, and what it answers.
import type { DrawOptions } from '../machine/protocol';

export interface PassesOptions extends DrawOptions {
  /** The pass list as TOML; '': the scene's or the renderer's. */
  readonly list?: string;
  /** 'volume', 'map' or 'none' for the lights that cast a shadow; '': as the scene has it. */
  readonly shadow?: string;
  readonly translucency?: string;
}

export type CounterValues = Readonly<Record<string, number>>;

/** A pass that ran. */
export interface RunPass {
  readonly name: string;
  /** The parameter set as the paper writes it; '': the driver's own pass. */
  readonly set: string;
  /** Of the list that it comes from. */
  readonly row: number | null;
  readonly counters: CounterValues;
  /** Estimated, on a VGX. */
  readonly seconds: number;
}

export interface PassesRun {
  readonly toml: string;
  readonly passes: readonly RunPass[];
  /** The machine that the times are estimated for. */
  readonly machine: string;
  readonly picture: Uint8Array;
}

export interface PlaneSeen {
  readonly picture: Uint8Array;
  /** What the pass changed. */
  readonly change: Uint8Array;
  /** Pixels. */
  readonly changed: number;
  /** The change is amplified so much. */
  readonly times: number;
}

export interface VolumesSeen {
  readonly picture: Uint8Array;
  readonly volumes: number;
  readonly eye: readonly [number, number, number];
  readonly at: readonly [number, number, number];
  readonly up: readonly [number, number, number];
}

declare module '../machine/protocol' {
  interface Methods {
    passes(options: PassesOptions): PassesRun;
    /** Of the last passes(). */
    plane(options: { readonly pass: number; readonly plane: string }): PlaneSeen;
    /** Rows of words, the header first; of the last passes(). */
    history(options: { readonly x: number; readonly y: number }): string[][];
    volumes(options: PassesOptions & { readonly from?: readonly number[] }): VolumesSeen;
  }
}
