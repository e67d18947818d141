// Whether a number that a reader typed is the one asked for: whole numbers exactly, others within
// one part in a hundred. Commas and wide digits of Japanese keyboards are read too.
export function isRight(given: string, wanted: string): boolean {
  const plain = given
    .normalize('NFKC')
    .replaceAll(',', '')
    .replace(/\u2212/g, '-')
    .trim();
  if (plain === '' || wanted === '') return false;
  const [a, b] = [Number(plain), Number(wanted)];
  return Number.isInteger(b) ? a === b : Math.abs(a - b) <= Math.abs(b) / 100;
}
