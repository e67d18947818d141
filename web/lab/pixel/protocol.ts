// What the exhibit of one pixel asks the engine, and what it answers.
import type { Channels } from '../machine/protocol';

export interface PixelOptions {
  readonly profile: string;
  readonly width: number;
  readonly height: number;
  /** The pixel; row 0 is at the bottom. */
  readonly x: number;
  readonly y: number;
  readonly corners: readonly {
    /** Sub-pixels. */
    readonly x: number;
    readonly y: number;
    readonly z: number;
    readonly w: number;
    readonly color: readonly number[];
    readonly s: number;
    readonly t: number;
  }[];
  readonly filter: string;
  readonly env: string;
  readonly blend: string;
  readonly background: readonly number[];
}

/** A plane (R9.6) and its value at the pixel (R9.8). Integers of any size are text. */
export interface PlaneFacts {
  readonly name: string;
  readonly a0: number;
  readonly x0: number;
  readonly y0: number;
  readonly gx: string;
  readonly gy: string;
  readonly sum: string;
  readonly value: number;
}

export interface PixelFacts {
  readonly picture: Uint8Array;
  readonly subpixel_bits: number;
  readonly color_bits: number;
  readonly depth_bits: number;
  readonly area2: number;
  readonly corners: readonly {
    readonly x: number;
    readonly y: number;
    readonly z: number;
    readonly color: Channels;
  }[];
  readonly covered: readonly (readonly number[])[];
  readonly order: readonly number[];
  readonly sides: readonly {
    readonly dx: number;
    readonly dy: number;
    readonly top_left: boolean;
    readonly e: number;
  }[];
  readonly inside: boolean;
  readonly depth?: PlaneFacts;
  readonly steps: readonly {
    readonly x: number;
    readonly closed: string;
    readonly stepped: string;
    readonly value: number;
  }[];
  readonly color_planes?: readonly PlaneFacts[];
  readonly perspective?: boolean;
  readonly color?: Channels;
  readonly texture?: {
    readonly planes: readonly PlaneFacts[];
    readonly w: string;
    readonly u: number;
    readonly v: number;
    readonly weights: readonly number[];
    readonly side: number;
    readonly texels: readonly {
      readonly i: number;
      readonly j: number;
      readonly color: Channels;
    }[];
    readonly texel: Channels;
  };
  readonly shaded?: Channels;
  readonly blend?: {
    readonly src: Channels;
    readonly dst: Channels;
    readonly factors: readonly Channels[];
    readonly products: readonly Channels[];
    readonly result: Channels;
  };
  /** The fragment that the machine made. */
  readonly machine?: {
    readonly color: Channels;
    readonly depth: number;
    readonly fate: string;
    readonly stored: Channels;
    readonly stored_depth: number;
    readonly after: Channels;
    readonly after_depth: number;
  };
}

declare module '../machine/protocol' {
  interface Methods {
    pixel(options: PixelOptions): PixelFacts;
  }
}
