// What the page asks the worker, and what it answers. The methods that one exhibit needs stand in
// its folder (hidden/state.ts, passes/protocol.ts, ...).

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

/** Of a colour. */
export type Channels = readonly number[];

/** Files by path, as bytes. */
export type Files = Readonly<Record<string, Uint8Array>>;

export interface Started {
  readonly algorithms: readonly AlgorithmName[];
  readonly simd: string;
  /** Paths of all files. */
  readonly scenes: readonly string[];
  readonly module: WebAssembly.Module;
}

/**
 * The methods: arguments to answers. start, write and open are the worker's; all others are rows of
 * the engine's table (web/engine/method.h), from options to an answer.
 */
export interface Methods {
  /** Texts of the page, or a module compiled before; `vectors`: which of the two engines it is. */
  start(engine: string | WebAssembly.Module, vectors: boolean, scenes: string): Started;
  write(files: Files): void;
  open(path: string): SceneFacts;
  draw(options: DrawOptions): {
    readonly picture: Uint8Array;
    readonly warnings: readonly string[];
  };
  manifest(options: DrawOptions): { readonly text: string };
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
