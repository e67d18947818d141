// Colours of polygons: those of the scene, or ones that colour-blind people can tell apart.
export type Palette = 'scene' | 'distinct';

// M. Okabe, K. Ito, "Color Universal Design", 2002: eight colours without black.
const distinct = ['#e69f00', '#56b4e9', '#009e73', '#f0e442', '#0072b2', '#d55e00', '#cc79a7'];

interface Colored {
  readonly background: string;
  readonly polygons: readonly { readonly id: number; readonly color: string }[];
}

export function colorsOf(header: Colored, palette: Palette): Map<number, string> {
  const colors = new Map<number, string>([[0, header.background]]);
  header.polygons.forEach((p, i) =>
    colors.set(p.id, palette === 'scene' ? p.color : distinct[i % distinct.length]!),
  );
  return colors;
}

/** Red, green, blue in 0 .. 255 of "#rrggbb". */
export function channels(color: string): [number, number, number] {
  const value = Number.parseInt(color.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** Black or white, the easier to read on a colour. */
export function inkOn(color: string): string {
  const [r, g, b] = channels(color);
  return 0.299 * r + 0.587 * g + 0.114 * b > 140 ? '#000000' : '#ffffff';
}
