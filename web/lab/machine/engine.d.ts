// What Emscripten makes of web/engine.
declare module 'gw-engine' {
  /** Why the engine refused. */
  interface Refusal {
    readonly error?: string;
  }
  /** JSON or a text, and planes by name. */
  interface Called extends Refusal {
    readonly json?: string;
    readonly [member: string]: string | Uint8Array | undefined;
  }
  export interface Engine {
    add_picture(
      path: string,
      width: number,
      height: number,
      bits: number,
      texels: Uint8Array,
    ): Refusal;
    /** A method of the engine's table, with options as JSON. */
    call(method: string, options: string): Called;
  }
  export interface EngineModule {
    Engine: new () => Engine;
    FS: {
      mkdirTree(path: string): void;
      writeFile(path: string, data: Uint8Array | string): void;
      readFile(path: string): Uint8Array;
      analyzePath(path: string): { readonly exists: boolean };
    };
  }
  export default function make_engine(settings: {
    instantiateWasm(
      imports: WebAssembly.Imports,
      done: (instance: WebAssembly.Instance) => void,
    ): object;
    locateFile(name: string): string;
  }): Promise<EngineModule>;
}
// The same without vectors.
declare module 'gw-scalar' {
  export { default } from 'gw-engine';
}

/** Of package.json. */
declare const __GW_VERSION__: string;
/** hiddensurface/run/messages.LANGUAGE.json, by language. */
declare const __GW_MESSAGES__: Readonly<Record<string, Readonly<Record<string, string>>>>;
