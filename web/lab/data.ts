// The bytes that stand in the page: WebAssembly and scenes.
const bytesOf = (base64: string): Uint8Array =>
  Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

async function unpacked(id: string): Promise<Response> {
  const text = document.getElementById(id)?.textContent ?? '';
  const stream = new Blob([bytesOf(text.trim())]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream('gzip')));
}

export const engineBytes = async (): Promise<ArrayBuffer> =>
  (await unpacked('engine')).arrayBuffer();

export const folder = '/scenes/';

/** By path, "/scenes/hidden/cycle.toml". */
export async function sceneFiles(): Promise<Record<string, Uint8Array>> {
  const files = (await (await unpacked('scenes')).json()) as Record<string, string>;
  return Object.fromEntries(
    Object.entries(files).map(([name, base64]) => [folder + name, bytesOf(base64)]),
  );
}
