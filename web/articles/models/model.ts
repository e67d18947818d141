// A figure that the page computes: points that are dragged, shapes and numbers that follow. The y
// axis points upwards.

export type Spot = readonly [number, number];
export type Spots = Readonly<Record<string, Spot>>;

/** Colours by meaning: the sheet of the articles says which. */
export type Tone = 'first' | 'second' | 'front' | 'back' | 'wrong' | 'faint' | 'light';

export interface Shape {
  /** A text may name it. */
  readonly id?: string;
  /** `polygon` and `cell` are filled; an arrow ends at its last spot; a text stands at its spot. */
  readonly kind: 'polygon' | 'cell' | 'line' | 'arrow' | 'dot' | 'text';
  readonly at: readonly Spot[];
  readonly tone: Tone;
  readonly text?: string;
}

export interface Picture {
  readonly shapes: readonly Shape[];
  /** Named by the texts. */
  readonly values: Readonly<Record<string, number | string>>;
}

export interface Model {
  /** Left, bottom, right, top. */
  readonly box: readonly [number, number, number, number];
  readonly spots: Spots;
  /** Their names for those who do not see them. */
  readonly names: Readonly<Record<string, string>>;
  /** Spots lie on a grid of this width, and the arrow keys move them by it. */
  readonly grid: number;
  /** Where a spot may be; none: in the box. */
  readonly limit?: (name: string, spot: Spot) => Spot;
  readonly look: (spots: Spots) => Picture;
}

const onto = (value: number, grid: number, low: number, high: number): number =>
  Number(Math.min(high, Math.max(low, Math.round(value / grid) * grid)).toFixed(6));

/** The spots after one has been moved. */
export function movedSpot(model: Model, spots: Spots, name: string, [x, y]: Spot): Spots {
  const [left, bottom, right, top] = model.box;
  const spot: Spot = [onto(x, model.grid, left, right), onto(y, model.grid, bottom, top)];
  return { ...spots, [name]: model.limit?.(name, spot) ?? spot };
}
