// Numbers: as short texts, between limits, among ascending ones.

/** Three digits. */
export const short = (v: number): string => Number(v.toPrecision(3)).toString();

export const clamped = (value: number, least: number, most: number): number =>
  Math.min(Math.max(value, least), most);

/** How many of the ascending numbers are below a value. */
export function countBelow(ascending: readonly number[], value: number): number {
  let low = 0;
  let high = ascending.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ascending[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
