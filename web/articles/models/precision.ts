// The depth that a Z-buffer of 16 bits stores, against the distance: x is the distance from the eye
// (near plane, point, far plane), y the stored part of all depths.
import type { Model, Shape, Spot } from './model';

const bits = 16;
const all = 2 ** bits - 1;
const most = 100;
/** Units of the drawing for the whole range of depths. */
const tall = 60;

/** The part of the depth range, 0 at the near plane and 1 at the far plane. */
const depthOf = (z: number, near: number, far: number): number =>
  (far * (z - near)) / (z * (far - near));

export const precision: Model = {
  box: [0, -8, most, tall + 8],
  grid: 0.25,
  spots: { near: [1, 0], far: [100, tall], point: [40, tall / 2] },
  names: { near: 'near plane', far: 'far plane', point: 'point' },
  limit: (name, [x]) =>
    name === 'near'
      ? [Math.min(20, Math.max(0.25, x)), 0]
      : name === 'far'
        ? [Math.max(50, x), tall]
        : [Math.min(50, Math.max(20, x)), tall / 2],
  look: (spots) => {
    const [near, far, z] = [spots['near']![0], spots['far']![0], spots['point']![0]];
    const stored = Math.round(depthOf(z, near, far) * all);
    const curve: Spot[] = Array.from({ length: 101 }, (_, i) => {
      // More places near the eye, where the curve bends.
      const at = near + (far - near) * (i / 100) ** 2;
      return [at, tall * depthOf(at, near, far)];
    });
    /** The distance whose depth is half of all. */
    const half = (2 * near * far) / (near + far);
    const step = (z * z * (far - near)) / (far * near * all);
    const depth = depthOf(z, near, far);
    const shapes: Shape[] = [
      {
        kind: 'line',
        at: [
          [0, 0],
          [most, 0],
        ],
        tone: 'light',
      },
      {
        kind: 'line',
        at: [
          [0, tall],
          [most, tall],
        ],
        tone: 'light',
      },
      { id: 'curve', kind: 'line', at: curve, tone: 'second' },
      {
        id: 'half',
        kind: 'line',
        at: [
          [half, 0],
          [half, tall / 2],
        ],
        tone: 'wrong',
      },
      {
        id: 'depth',
        kind: 'line',
        at: [
          [z, 0],
          [z, tall * depth],
          [0, tall * depth],
        ],
        tone: 'first',
      },
      { id: 'depth', kind: 'dot', at: [[z, tall * depth]], tone: 'first' },
    ];
    const values = { near, far, z, bits, all, stored, half, step };
    return { shapes, values: { ...values, ratio: far / near, share: 100 * depth } };
  },
};
