// The outline of what changed, as RGBA: the unchanged pixels that touch a changed one are white,
// all others are clear.

/** `change`: RGBA, black is no change. */
export function outlined(change: Uint8Array, width: number, height: number): Uint8Array {
  const isChanged = (x: number, y: number): boolean => {
    if (x < 0 || y < 0 || x >= width || y >= height) return false;
    const i = 4 * (y * width + x);
    return change[i] !== 0 || change[i + 1] !== 0 || change[i + 2] !== 0;
  };
  const out = new Uint8Array(width * height * 4);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      if (isChanged(x, y)) continue;
      const touches =
        isChanged(x - 1, y) || isChanged(x + 1, y) || isChanged(x, y - 1) || isChanged(x, y + 1);
      if (touches) out.set([255, 255, 255, 255], 4 * (y * width + x));
    }
  return out;
}
