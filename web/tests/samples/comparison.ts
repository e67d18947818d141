// A comparison made by hand: three algorithms, 4 x 2 pixels, two polygons.
import type { Comparison } from '../../model/comparison';

export const comparison: Comparison = {
  data: 'gw hidden comparison',
  version: 1,
  scene: 'sample <b>scene</b>',
  size: [4, 2],
  background: '#000000',
  polygons: [
    { id: 1, part: 'far', color: '#ff0000' },
    { id: 2, part: 'near', color: '#0000ff' },
  ],
  complexity: [2, 0, 2, 2, 2, 0, 2, 1],
  algorithms: [
    {
      name: 'painter',
      title: "Painter's algorithm",
      counts: { polygons: 2, keys: 5, rays: 0, wrong: 1 },
      ids: [2, 0, 1, 2, 1, 1, 2, 0, 2, 2],
      difference: [3, 0, 1, 4, 4, 0],
      writes: [2, 0, 2, 2, 2, 0, 2, 1],
    },
    {
      name: 'z-buffer',
      title: 'Z-buffer',
      counts: { polygons: 2, keys: 0, rays: 0, wrong: 0 },
      ids: [2, 0, 2, 2, 2, 0, 2, 2],
      difference: [8, 0],
      writes: [2, 0, 2, 1, 2, 0, 2, 1],
    },
    {
      name: 'newell',
      title: 'Newell, Newell, Sancha',
      counts: { polygons: 2, keys: 3, rays: 0, wrong: 0 },
      ids: [2, 0, 2, 2, 2, 0, 2, 2],
      difference: [8, 0],
      writes: [2, 0, 2, 2, 2, 0, 2, 1],
    },
  ],
};
