// What the page asks the worker, and what it answers.
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
  start(wasm: ArrayBuffer, files: Files): { algorithms: readonly AlgorithmName[]; simd: string };
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
  volumes(options: PassesOptions & { readonly from?: readonly number[] }): VolumesSeen;
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
