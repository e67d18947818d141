// The bytes that stand in the page: WebAssembly and scenes.
function bytesOf(base64: string): Uint8Array {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

function unpacked(id: string, type: string): Response {
  const text = document.getElementById(id)?.textContent ?? '';
  const stream = new Blob([bytesOf(text.trim())]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream('gzip')), {
    headers: { 'Content-Type': type },
  });
}

/** A module with a value of 128 bits. */
const vectorModule = [
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15,
  253, 98, 11,
];
/** Whether this browser has WebAssembly's vectors. */
export const hasVectors = (): boolean => WebAssembly.validate(new Uint8Array(vectorModule));

/** Compiled while it is unpacked, once for all workers. */
export const engineModule = (vectors: boolean): Promise<WebAssembly.Module> =>
  WebAssembly.compileStreaming(unpacked(vectors ? 'engine' : 'scalar', 'application/wasm'));

export const folder = '/scenes/';

/** By path, "/scenes/hidden/cycle.toml". */
export async function sceneFiles(): Promise<Record<string, Uint8Array>> {
  const files = (await unpacked('scenes', 'application/json').json()) as Record<string, string>;
  return Object.fromEntries(
    Object.entries(files).map(([name, base64]) => [folder + name, bytesOf(base64)]),
  );
}
