// Gzip in base64, as the page holds engines and scenes.
export function bytesOf(base64: string): Uint8Array {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export function unpacked(text: string, type: string): Response {
  const stream = new Blob([bytesOf(text)]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream('gzip')), {
    headers: { 'Content-Type': type },
  });
}
