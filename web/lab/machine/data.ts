// What stands in the page as text: the engines and the scenes, packed, and scripts that not every
// visit needs.
export const folder = '/scenes/';

export const textOf = (id: string): string =>
  document.getElementById(id)?.textContent?.trim() ?? '';

export const scriptAddress = (id: string): string =>
  URL.createObjectURL(new Blob([textOf(id)], { type: 'text/javascript' }));

/** A module with a value of 128 bits. */
const vectorModule = [
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15,
  253, 98, 11,
];
/** Whether this browser has WebAssembly's vectors. */
export const hasVectors = (): boolean => WebAssembly.validate(new Uint8Array(vectorModule));
