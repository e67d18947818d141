// Wrong pixels by the step that painted them last, and by polygon.

export interface Blame {
  /** 1, 2, ...; 0: no step painted them. */
  readonly step: number;
  readonly polygon: number;
  /** What the step covered. */
  readonly over: number;
  readonly expected: number;
  readonly pixels: number;
  readonly first: readonly [number, number];
}

export interface BlamedPolygon {
  readonly id: number;
  /** Wrong pixels that should show it, and that show it. */
  readonly missing: number;
  readonly extra: number;
}

export function blamedPolygons(all: readonly Blame[]): BlamedPolygon[] {
  const ids = [...new Set(all.flatMap((b) => [b.polygon, b.expected]))].sort((a, b) => a - b);
  const sum = (parts: readonly Blame[]) => parts.reduce((total, b) => total + b.pixels, 0);
  return ids.map((id) => ({
    id,
    missing: sum(all.filter((b) => b.expected === id)),
    extra: sum(all.filter((b) => b.polygon === id)),
  }));
}
