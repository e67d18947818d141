// A text of the visitor as a word of the address.
const url64 = { '+': '-', '/': '_', '=': '' } as Readonly<Record<string, string>>;
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
