// Numbers as this exhibit shows them.
export const short = (v: number): string => Number(v.toPrecision(3)).toString();
