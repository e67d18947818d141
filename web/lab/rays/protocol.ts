// What the exhibit of rays asks the engine, and what it answers.
import type { DrawOptions, View } from '../machine/protocol';
import type { Point } from '../../model/point';

export interface RaysOptions extends DrawOptions {
  /** Rays in a path, the one from the eye counted. */
  readonly depth: number;
}

/** A picture with rays, and what they cost. */
export interface RaysRun {
  readonly picture: Uint8Array;
  readonly counts: {
    readonly primary: number;
    readonly reflected: number;
    readonly transmitted: number;
    readonly shadow: number;
    readonly shaded: number;
  };
  readonly milliseconds: number;
  /** Of them, the item buffer and its rays; of ordinary ray tracing all. */
  readonly tracing: number;
  /** What no eye changes was made in this time, too. */
  readonly made: boolean;
}

export interface Identified {
  /** Pixels. */
  readonly traced: number;
  /** Identifiers in false colours, four bytes a pixel. */
  readonly ids: Uint8Array;
  /** By pixel, the upper row first: 1 if it is traced. */
  readonly mask: Uint8Array;
}

export interface ReasonsRun {
  readonly reasons: readonly {
    readonly why: string;
    readonly pixels: number;
    readonly mean: number;
    readonly largest: number;
  }[];
  /** Passes that add colours. */
  readonly passes: number;
  /** By pixel, the upper row first: same, polygon, shadow, rounding, fog, lighting. */
  readonly reason: Uint8Array;
}

export interface FollowedRay {
  readonly kind: 'reflected' | 'transmitted' | 'shadow';
  /** In its path, where the ray from the eye is 1; 0: a shadow ray. */
  readonly number: number;
  /** Of the light that arrives at the eye. */
  readonly part: number;
  readonly from: Point;
  readonly to: Point;
  readonly light?: string;
  readonly arrives?: boolean;
  /** What it meets; none: the background. */
  readonly object?: string;
  readonly id?: number;
}

export interface PathFacts {
  /** Of the polygon; 0: the background. */
  readonly id: number;
  readonly object?: string;
  /** The item buffer's ray goes on from here. */
  readonly traced: boolean;
  readonly eye: Point;
  readonly to: Point;
  readonly rays: readonly FollowedRay[];
  /** How many there are; the first ones are told. */
  readonly all: number;
}

export interface OutsideSeen {
  readonly picture: Uint8Array;
  readonly eye: Point;
  readonly at: Point;
  readonly up: Point;
  /** World to clip space, by columns. */
  readonly matrix: readonly number[];
}

export interface CastOptions extends View {
  readonly method: string;
  readonly inside: string;
  /** Tests: a picture that would take more is refused. */
  readonly limit?: number;
}

export interface CastCounts {
  readonly rays: number;
  readonly shapes: number;
  readonly boxes: number;
  readonly voxels: number;
}

export interface CastRun {
  readonly picture: Uint8Array;
  /** The tests of each pixel in grey. */
  readonly tests: Uint8Array;
  readonly counts: CastCounts;
  readonly shapes: number;
  readonly milliseconds: number;
}

export interface VisitFacts {
  readonly from: Point;
  readonly to: Point;
  readonly counts: CastCounts;
  readonly boxes: readonly {
    readonly low: Point;
    readonly high: Point;
    /** Tested in it. */
    readonly shapes: number;
  }[];
  readonly object?: string;
}

export interface SweepFacts {
  readonly name: string;
  readonly values: readonly number[];
  /** Of a plot's axis; 0: linear. */
  readonly log: number;
  /** Why the scene has no such sweep; '': it has. */
  readonly refusal: string;
}

/** Seconds, or a ratio, at the prices of a list. */
export interface Estimate {
  readonly list: string;
  readonly value: number;
  readonly low: number;
  readonly high: number;
}

export interface SweepRow {
  /** Measured: percent of pixels that are glossy, triangles, pixels, ... */
  readonly x: number;
  /** Of the pixels, those whose reflections are traced. */
  readonly share: number;
  readonly methods: readonly {
    readonly name: string;
    readonly passes: number;
    readonly fragments: number;
    readonly rays: number;
    /** In this browser. */
    readonly seconds: number;
    readonly estimates: readonly Estimate[];
  }[];
  /** Ordinary ray tracing over the item buffer. */
  readonly gains: readonly Estimate[];
}

export interface InsideOptions {
  readonly corners: readonly (readonly number[])[];
  readonly columns: number;
  readonly rows: number;
  readonly point: readonly number[];
}

export interface InsideFacts {
  /** By pixel, row 0 at the bottom: a bit for each test. */
  readonly cells: readonly number[];
  readonly sides: readonly {
    readonly crossed: boolean;
    readonly product: number;
    /** None: the point is on the side. */
    readonly angle: number | null;
  }[];
  /** Of the point. */
  readonly tests: number;
}

declare module '../machine/protocol' {
  interface Methods {
    rays(options: RaysOptions): RaysRun;
    raytraced(options: RaysOptions): RaysRun;
    identifiers(options: RaysOptions): Identified;
    reasons(options: RaysOptions): ReasonsRun;
    /** Of a pixel of the last identifiers(). */
    path(options: {
      readonly x: number;
      readonly y: number;
      readonly ordinary: boolean;
    }): PathFacts;
    outside(options: View & { readonly from?: readonly number[] }): OutsideSeen;
    cast(options: CastOptions): CastRun;
    visits(options: CastOptions & { readonly x: number; readonly y: number }): VisitFacts;
    inside(options: InsideOptions): InsideFacts;
    sweeps(options: RaysOptions): { readonly sweeps: readonly SweepFacts[] };
    sweep_row(options: RaysOptions & { readonly sweep: string; readonly value: number }): SweepRow;
  }
}
