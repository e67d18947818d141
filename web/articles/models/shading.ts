// A point of a plane, the light and the eye, from the side: the ambient, diffuse and specular parts
// of the light that reaches the eye, as the machine computes them, with the half-way vector.
import type { Model, Shape, Spot } from './model';
import { dot, plus, scaled, unit } from './plane';

const [ka, kd, ks, gloss] = [0.15, 0.5, 0.35, 20];
const normal: Spot = [0, 1];
const degrees = (cosine: number): number => (180 / Math.PI) * Math.acos(Math.min(1, cosine));
/** Height of the column for all the light. */
const tall = 5;

export const shading: Model = {
  box: [-6, -1, 6, 7],
  grid: 0.5,
  spots: { light: [-3, 4], eye: [2, 5] },
  names: { light: 'light', eye: 'eye' },
  limit: (_, [x, y]) => [Math.min(4.5, x), Math.max(0.5, y)],
  look: (spots) => {
    const toLight = unit(spots['light']!);
    const toEye = unit(spots['eye']!);
    const half = unit(plus(toLight, toEye));
    const [cosine, sharp] = [dot(toLight, normal), dot(half, normal)];
    const [ambient, diffuse, specular] = [ka, kd * cosine, ks * sharp ** gloss];
    const shapes: Shape[] = [
      {
        kind: 'line',
        at: [
          [-6, 0],
          [4.6, 0],
        ],
        tone: 'faint',
      },
    ];
    const arrow = (id: string, to: Spot, length: number, tone: Shape['tone']): void => {
      const end = scaled(to, length);
      shapes.push({ id, kind: 'arrow', at: [[0, 0], end], tone });
      shapes.push({ kind: 'text', at: [plus(end, scaled(to, 0.35))], tone, text: id });
    };
    arrow('N', normal, 2, 'faint');
    arrow('L', toLight, 2.4, 'first');
    arrow('V', toEye, 2.4, 'second');
    arrow('H', half, 2.8, 'front');
    let y = 0;
    for (const [id, part, tone] of [
      ['ambient', ambient, 'faint'],
      ['diffuse', diffuse, 'first'],
      ['specular', specular, 'front'],
    ] as const) {
      const top = y + tall * part;
      const at: Spot[] = [
        [5, y],
        [5.8, y],
        [5.8, top],
        [5, top],
      ];
      shapes.push({ id, kind: 'cell', at, tone }, { id, kind: 'line', at: [...at, at[0]!], tone });
      y = top;
    }
    const sum = ambient + diffuse + specular;
    const values = { ka, kd, ks, gloss, ambient, diffuse, specular, sum };
    return {
      shapes,
      values: { ...values, theta: degrees(cosine), alpha: degrees(sharp) },
    };
  },
};
