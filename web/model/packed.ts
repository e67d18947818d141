// Data as words in base 64: gzip in pages (the command's <script class="data">, the lab's engines
// and scenes), plain texts in addresses. Unpacks pages' texts piece by piece: a long log never
// stands in memory as one string.

export function bytesOf(base64: string): Uint8Array {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export async function* piecesOf(text: ReadableStream<string>): AsyncGenerator<string> {
  const reader = text.getReader();
  for (let read = await reader.read(); !read.done; read = await reader.read()) yield read.value;
}

export function unpackedPieces(base64: string): AsyncGenerator<string> {
  const unzipped = new Blob([bytesOf(base64.trim())])
    .stream()
    .pipeThrough(new DecompressionStream('gzip'));
  return piecesOf(unzipped.pipeThrough(new TextDecoderStream()));
}

export async function unpacked(base64: string): Promise<string> {
  let text = '';
  for await (const piece of unpackedPieces(base64)) text += piece;
  return text;
}

/** Takes the data out of the page, which needs its memory. */
export function takeData(): string[] {
  return [...document.querySelectorAll('script.data')].map((element) => {
    const text = element.textContent ?? '';
    element.remove();
    return text;
  });
}

/** As a module of WebAssembly wants it, without a text between. */
export function unpackedAs(text: string, type: string): Response {
  const stream = new Blob([bytesOf(text)]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream('gzip')), {
    headers: { 'Content-Type': type },
  });
}

const url64 = { '+': '-', '/': '_', '=': '' } as Readonly<Record<string, string>>;
/** A text of the visitor as a word of the address. */
export const packedText = (text: string): string =>
  btoa(String.fromCharCode(...new TextEncoder().encode(text))).replace(
    /[+/=]/g,
    (c) => url64[c] ?? c,
  );
export function unpackedText(word: string): string {
  try {
    const bytes = atob(word.replaceAll('-', '+').replaceAll('_', '/'));
    return new TextDecoder().decode(Uint8Array.from(bytes, (c) => c.charCodeAt(0)));
  } catch {
    return '';
  }
}
