// What the page asks the worker, and what it answers.
import type { Point } from '../../model/steps/log';

export interface View {
  readonly width: number;
  readonly height: number;
  readonly profile: string;
  readonly eye?: readonly number[];
  readonly at?: readonly number[];
  readonly up?: readonly number[];
  readonly fov?: number;
}

export interface SceneFacts {
  readonly name: string;
  readonly warnings: readonly string[];
  readonly objects: readonly { name: string; material: string; triangles: number }[];
  readonly lights: readonly string[];
  readonly eye: readonly [number, number, number];
  readonly at: readonly [number, number, number];
  readonly up: readonly [number, number, number];
  readonly fov: number;
}

export interface AlgorithmName {
  readonly name: string;
  readonly title: string;
  readonly lines: boolean;
}

export interface DrawOptions extends View {
  readonly renderer: string;
  readonly samples?: number;
  /** 'rays' or 'maps'. */
  readonly reflections?: string;
}

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

type Channels = readonly number[];
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

export interface LightChange {
  /** So many shots were done. */
  readonly after: number;
  readonly object: string;
  /** A reflectance, an emitter, or a place, as `gw radiosity --change` has them. */
  readonly what: 'Kd' | 'dim' | 'move';
  readonly value: readonly number[];
}
/** A state of the light of a scene. */
export interface LightOptions {
  readonly width: number;
  readonly height: number;
  /** Pixels across. */
  readonly hemicube: number;
  readonly shots: number;
  readonly changes: readonly LightChange[];
  /** The changes are there before the first shot. */
  readonly anew?: boolean;
}
export interface LitTone {
  /** Stops. */
  readonly exposure: number;
  readonly gamma: number;
  /** The estimate of the light yet to come is shown. */
  readonly ambient: boolean;
  readonly anew?: boolean;
}
export interface LightFacts {
  readonly shots: number;
  readonly hemicubes: number;
  /** The state that was asked for is not reached. */
  readonly more: boolean;
  /** Nothing is unshot. */
  readonly dark: boolean;
  /** Shares: before the first shot, and after every step. */
  readonly unshot: readonly number[];
  /** The steps that were changes. */
  readonly changed: readonly number[];
  readonly emitted: Channels;
  readonly absorbed: Channels;
  readonly escaped: Channels;
  readonly left: Channels;
  readonly figures: readonly {
    readonly name: string;
    readonly Kd: Channels;
    readonly emission: Channels;
  }[];
  readonly pixmaps: readonly {
    readonly name: string;
    readonly width: number;
    readonly height: number;
  }[];
  readonly texels: number;
  readonly patches: number;
  /** The last shot; before the first one, the next. */
  readonly shot: {
    readonly patch: number;
    readonly pixmap: number;
    readonly x: number;
    readonly y: number;
    readonly width: number;
    readonly height: number;
    readonly flux: Channels;
    /** Hemicubes that the patch shoots from. */
    readonly points: number;
  };
}

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

export interface HiddenOptions extends View {
  readonly algorithm: string;
  readonly level: string;
  /** Seconds: an algorithm that would take longer is refused. */
  readonly limit?: number;
}

/** Files by path, as bytes. */
export type Files = Readonly<Record<string, Uint8Array>>;

export interface Drawn {
  readonly answer: {
    readonly passes: readonly { name: string; counters: Readonly<Record<string, number>> }[];
  };
  readonly picture: Uint8Array;
  readonly milliseconds: number;
}

export interface Graded {
  /** The text of steps.jsonl. */
  readonly log: string;
  /** By pixel, the upper row first: equal, tie, edge, snapped, wrong. Empty for lines. */
  readonly difference: Uint8Array;
}

/** The methods of the worker: arguments to answers. */
export interface Methods {
  /** Texts of the page, or a module compiled before; `vectors`: which of the two engines it is. */
  start(
    engine: string | WebAssembly.Module,
    vectors: boolean,
    scenes: string,
  ): {
    algorithms: readonly AlgorithmName[];
    simd: string;
    /** Paths of all files. */
    scenes: readonly string[];
    module: WebAssembly.Module;
  };
  write(files: Files): void;
  open(path: string): SceneFacts;
  draw(options: DrawOptions): Drawn;
  manifest(options: DrawOptions): string;
  hidden(options: HiddenOptions): Graded;
  passes(options: PassesOptions): PassesRun;
  /** Of the last passes(). */
  plane(pass: number, plane: string): PlaneSeen;
  /** Rows of words, the header first; of the last passes(). */
  history(x: number, y: number): string[][];
  pixel(options: PixelOptions): PixelFacts;
  volumes(options: PassesOptions & { readonly from?: readonly number[] }): VolumesSeen;
  /** One step towards the state, or its beginning. */
  light(options: LightOptions): LightFacts;
  /** Pictures of the light of the last light(). */
  lit(options: View & LitTone): Uint8Array;
  pixmap(options: LitTone & { readonly pixmap: number }): Uint8Array;
  hemicube(options: { readonly patch: number; readonly point: number }): Uint8Array;
  rays(options: RaysOptions): RaysRun;
  raytraced(options: RaysOptions): RaysRun;
  identifiers(options: RaysOptions): Identified;
  reasons(options: RaysOptions): ReasonsRun;
  /** Of a pixel of the last identifiers(). */
  path(options: { readonly x: number; readonly y: number; readonly ordinary: boolean }): PathFacts;
  outside(options: View & { readonly from?: readonly number[] }): OutsideSeen;
  cast(options: CastOptions): CastRun;
  visits(options: CastOptions & { readonly x: number; readonly y: number }): VisitFacts;
  inside(options: InsideOptions): InsideFacts;
  polygons(options: View): string;
  play(options: View, steps: string): Graded;
}

export interface Request {
  readonly number: number;
  readonly method: keyof Methods;
  readonly values: readonly unknown[];
}
export interface Answer {
  readonly number: number;
  readonly value?: unknown;
  readonly error?: string;
}
