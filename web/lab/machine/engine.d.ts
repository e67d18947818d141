// What Emscripten makes of web/engine.
declare module 'gw-engine' {
  export interface Engine {
    add_picture(
      path: string,
      width: number,
      height: number,
      bits: number,
      texels: Uint8Array,
    ): string;
    open(path: string): string;
    draw(options: string): string;
    manifest(options: string): string;
    hidden(options: string): string;
    passes(options: string): string;
    plane(options: string): string;
    history(options: string): string;
    pixel(options: string): string;
    volumes(options: string): string;
    polygons(options: string): string;
    light(options: string): string;
    lit(options: string): string;
    pixmap(options: string): string;
    hemicube(options: string): string;
    rays(options: string): string;
    raytraced(options: string): string;
    identifiers(options: string): string;
    reasons(options: string): string;
    path(options: string): string;
    outside(options: string): string;
    cast(options: string): string;
    visits(options: string): string;
    inside(options: string): string;
    play(options: string, steps: string): string;
    picture(): Uint8Array;
    change(): Uint8Array;
    difference(): Uint8Array;
  }
  export interface EngineModule {
    Engine: new () => Engine;
    algorithms(): string;
    simd_target(): string;
    FS: {
      mkdirTree(path: string): void;
      writeFile(path: string, data: Uint8Array | string): void;
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
