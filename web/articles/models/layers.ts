// Three walls from above and nine lines of sight: each shows the nearest wall that it meets.
import type { Model, Shape, Spot } from './model';
import { meets, mixed } from './plane';

const walls = ['1', '2', '3'] as const;
const tones = { '1': 'first', '2': 'second', '3': 'front' } as const;
const rays = 9;

export const layers: Model = {
  box: [-6, -5, 6, 5],
  grid: 0.5,
  spots: {
    eye: [0, -4.5],
    a: [-4, 3],
    b: [4, 3],
    c: [-3, 1],
    d: [0.5, 0],
    e: [0, -1.5],
    f: [2, -1],
  },
  names: {
    eye: 'eye',
    a: 'left end of wall 1',
    b: 'right end of wall 1',
    c: 'left end of wall 2',
    d: 'right end of wall 2',
    e: 'left end of wall 3',
    f: 'right end of wall 3',
  },
  look: (spots) => {
    const eye = spots['eye']!;
    const ends: Record<string, [Spot, Spot]> = {
      '1': [spots['a']!, spots['b']!],
      '2': [spots['c']!, spots['d']!],
      '3': [spots['e']!, spots['f']!],
    };
    const shapes: Shape[] = [];
    const seen: Record<string, number> = { '1': 0, '2': 0, '3': 0 };
    let met = 0;
    let most = 0;
    let empty = 0;
    for (let i = 0; i < rays; ++i) {
      const angle = ((i - (rays - 1) / 2) / (rays - 1)) * 1.4;
      const far: Spot = [eye[0] + 12 * Math.sin(angle), eye[1] + 12 * Math.cos(angle)];
      const hits = walls.flatMap((name) => {
        const t = meets(eye, far, ...ends[name]!);
        return t !== undefined && t > 0 && t <= 1 ? [{ name, t }] : [];
      });
      const nearest = hits.sort((a, b) => a.t - b.t)[0];
      met += hits.length;
      most = Math.max(most, hits.length);
      if (nearest) seen[nearest.name]! += 1;
      else empty += 1;
      const end = mixed(eye, far, nearest?.t ?? 1);
      shapes.push({ kind: 'line', at: [eye, end], tone: 'light' });
      if (nearest) shapes.push({ kind: 'dot', at: [end], tone: tones[nearest.name] });
    }
    for (const name of walls)
      shapes.push(
        { id: `wall${name}`, kind: 'line', at: ends[name]!, tone: tones[name] },
        { kind: 'text', at: [mixed(...ends[name]!, 0.5)], tone: tones[name], text: name },
      );
    const [one, two, three] = walls.map((name) => seen[name]!) as [number, number, number];
    const values = {
      rays,
      tests: rays * 3,
      met,
      most,
      empty,
      seen1: one,
      seen2: two,
      seen3: three,
    };
    return { shapes, values: { ...values, hidden: met - one - two - three } };
  },
};
