// What the lab uses of MicroPython's package, which has no types.
declare module '@micropython/micropython-webassembly-pyscript/micropython.mjs' {
  interface MicroPython {
    readonly globals: { set(name: string, value: unknown): void };
    /** Throws an Error whose message is Python's traceback. */
    runPython(text: string): unknown;
  }
  export function loadMicroPython(options: {
    readonly url: string;
    /** In bytes. */
    readonly heapsize: number;
  }): Promise<MicroPython>;
}
