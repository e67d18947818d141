// The cut of a scan line through all polygons: the segments of the x-z diagram, and the depth at a
// pixel. Does not draw.
import { depthAt } from './camera';
import type { Header, HeaderPiece, Loop, Polygon } from './log';
import { whole } from './outline';

export interface Segment {
  readonly id: number;
  readonly name: string;
  readonly color: string;
  /** Units of the window grid, and of the depth plane at both ends. */
  readonly x0: number;
  readonly x1: number;
  readonly z0: number;
  readonly z1: number;
}

/** The x at which the outline crosses y, ascending: inside between the first and second, ... */
export function crossings(outline: readonly Loop[], y: number): number[] {
  const found: number[] = [];
  for (const loop of outline)
    loop.forEach((a, i) => {
      const b = loop[(i + 1) % loop.length]!;
      if (a[1] <= y !== b[1] <= y) found.push(a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0]));
    });
  return found.sort((a, b) => a - b);
}

function segmentsOf(polygon: Polygon, piece: HeaderPiece, y: number): Segment[] {
  const plane = piece.plane;
  if (!plane) return [];
  const x = crossings(whole(piece.outline), y);
  const segments: Segment[] = [];
  for (let i = 0; i + 1 < x.length; i += 2)
    segments.push({
      id: polygon.id,
      name: piece.name,
      color: polygon.color,
      x0: x[i]!,
      x1: x[i + 1]!,
      z0: depthAt(plane, x[i]!, y),
      z1: depthAt(plane, x[i + 1]!, y),
    });
  return segments;
}

/** At the middle of a row of pixels. */
export function segmentsOfRow(header: Header, row: number): Segment[] {
  const y = (row + 0.5) * header.unit;
  return header.polygons.flatMap((p) => p.pieces.flatMap((piece) => segmentsOf(p, piece, y)));
}

/** The depth of a polygon at a pixel's middle, to the nearest whole value. */
export function depthOfPixel(header: Header, id: number, x: number, y: number): number | undefined {
  const at = [(x + 0.5) * header.unit, (y + 0.5) * header.unit] as const;
  const pieces = header.polygons.find((p) => p.id === id)?.pieces ?? [];
  const covers = (piece: HeaderPiece) =>
    crossings(piece.outline, at[1]).filter((crossing) => crossing <= at[0]).length % 2 === 1;
  const plane = (pieces.find(covers) ?? pieces[0])?.plane;
  return plane ? Math.round(depthAt(plane, ...at)) : undefined;
}
