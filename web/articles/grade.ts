// Whether a number that a reader typed is the one asked for: whole numbers exactly, others within
// one part in a hundred. Commas and wide digits of Japanese keyboards are read too.
export type Grade = 'right' | 'large' | 'small' | 'none';

/** none: there is no number, or none to compare it with. */
export function gradeOf(given: string, wanted: string): Grade {
  const plain = given
    .normalize('NFKC')
    .replaceAll(',', '')
    .replace(/\u2212/g, '-')
    .trim();
  const [a, b] = [Number(plain), Number(wanted)];
  if (plain === '' || wanted === '' || Number.isNaN(a - b)) return 'none';
  const isRight = Number.isInteger(b) ? a === b : Math.abs(a - b) <= Math.abs(b) / 100;
  return isRight ? 'right' : a > b ? 'large' : 'small';
}
