// The data that the command puts into a page: <script class="data"> with base64 of gzip of text.
// Unpacks piece by piece, so that a long log never stands in memory as one string.

export async function* piecesOf(text: ReadableStream<string>): AsyncGenerator<string> {
  const reader = text.getReader();
  for (let read = await reader.read(); !read.done; read = await reader.read()) yield read.value;
}

export function unpackedPieces(base64: string): AsyncGenerator<string> {
  const bytes = Uint8Array.from(atob(base64.trim()), (c) => c.charCodeAt(0));
  const unzipped = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
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
