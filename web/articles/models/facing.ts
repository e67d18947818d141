// A solid from above: five sides, their normals, the eye, and the sign of D_f of every side.
import type { Model, Shape, Spot } from './model';
import { cross, dot, meets, minus, mixed, outwards, plus, scaled, sidesOf, unit } from './plane';

const corners = ['a', 'b', 'c', 'd', 'e'] as const;

/** Whether another side lies between the eye and this point. */
const isHidden = (eye: Spot, point: Spot, sides: readonly (readonly [Spot, Spot])[]): boolean =>
  sides.some(([from, to]) => {
    const t = meets(eye, point, from, to);
    return t !== undefined && t > 1e-9 && t < 1 - 1e-9;
  });

export const facing: Model = {
  box: [-6, -5, 6, 5],
  grid: 0.5,
  spots: { eye: [0, -4.5], a: [-2, -1], b: [2, -1], c: [3, 1.5], d: [0, 3.5], e: [-3, 1.5] },
  names: { eye: 'eye', a: 'corner a', b: 'corner b', c: 'corner c', d: 'corner d', e: 'corner e' },
  look: (spots) => {
    const eye = spots['eye']!;
    const outline = corners.map((name) => spots[name]!);
    const sides = sidesOf(outline);
    const values: Record<string, number> = { front: 0, back: 0, hidden: 0, inward: 0 };
    const shapes: Shape[] = [{ kind: 'polygon', at: outline, tone: 'faint' }];
    sides.forEach(([from, to], i) => {
      const normal = outwards(minus(to, from));
      const d = dot(minus(eye, from), normal);
      const middle = mixed(from, to, 0.5);
      const others = sides.filter((_, j) => j !== i);
      const hidden = d > 0 && isHidden(eye, middle, others);
      const name = `side${i + 1}`;
      values[`D${i + 1}`] = d;
      values[`x${i + 1}`] = eye[0] - from[0];
      values[`y${i + 1}`] = eye[1] - from[1];
      values[`nx${i + 1}`] = normal[0];
      values[`ny${i + 1}`] = normal[1];
      values[d > 0 ? 'front' : 'back']! += 1;
      if (hidden) values['hidden']! += 1;
      if (cross(minus(to, from), minus(sides[(i + 1) % 5]![1], to)) < 0) values['inward']! += 1;
      const tone = hidden ? 'wrong' : d > 0 ? 'front' : 'back';
      const tip = plus(middle, scaled(unit(normal), 1));
      shapes.push({ id: name, kind: 'line', at: [from, to], tone });
      shapes.push({ id: name, kind: 'arrow', at: [middle, tip], tone });
      shapes.push({
        kind: 'text',
        at: [plus(middle, scaled(unit(normal), -0.5))],
        tone,
        text: String(i + 1),
      });
    });
    shapes.push({ kind: 'line', at: [eye, mixed(outline[0]!, outline[1]!, 0.5)], tone: 'light' });
    return { shapes, values };
  },
};
