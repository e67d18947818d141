// The models of the later articles, by other formulas.
import { describe, expect, it } from 'vitest';
import { exchange } from '../articles/models/exchange';
import { invisibility } from '../articles/models/invisibility';
import { movedSpot, type Model, type Spot, type Spots } from '../articles/models/model';
import { ray } from '../articles/models/ray';
import { shading } from '../articles/models/shading';
import { volume } from '../articles/models/volume';
import { windows } from '../articles/models/windows';
import { placedNames } from '../articles/names';
import { models } from '../articles/topics';
import { nameOf } from '../words/names';

/** Every spot moved to a few places, which are not on the lines of the others. */
const placesOf = (model: Model): Spots[] => {
  const [left, bottom, right, top] = model.box;
  return Object.keys(model.spots).flatMap((spot) =>
    [0.03, 0.27, 0.51, 0.74, 0.97].flatMap((x) =>
      [0.04, 0.31, 0.62, 0.98].map((y) =>
        movedSpot(model, model.spots, spot, [
          left + x * (right - left),
          bottom + y * (top - bottom),
        ]),
      ),
    ),
  );
};

/** Twice the area of three points, above 0 if they turn to the left. */
const area = (a: Spot, b: Spot, c: Spot): number =>
  a[0] * b[1] - b[0] * a[1] + b[0] * c[1] - c[0] * b[1] + c[0] * a[1] - a[0] * c[1];
const hypot = (a: Spot, b: Spot): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
const between = (a: Spot, b: Spot, t: number): Spot => [
  a[0] + t * (b[0] - a[0]),
  a[1] + t * (b[1] - a[1]),
];
/** Whether two segments cross, by the sides of their ends; undefined: they nearly touch. */
function cross(a: Spot, b: Spot, c: Spot, d: Spot): boolean | undefined {
  const sides = [area(a, b, c), area(a, b, d), area(c, d, a), area(c, d, b)];
  if (sides.some((side) => Math.abs(side) < 1e-6)) return undefined;
  return sides[0]! * sides[1]! < 0 && sides[2]! * sides[3]! < 0;
}
const inside = (spot: Spot, corners: readonly Spot[]): boolean =>
  corners.every((corner, i) => area(corner, corners[(i + 1) % corners.length]!, spot) > 0);

it('windows are divided until their areas enclose that of the triangle', () => {
  for (const spots of placesOf(windows)) {
    const { values, shapes } = windows.look(spots);
    const [a, b, c] = [spots['a']!, spots['b']!, spots['c']!];
    const triangle = Math.abs(area(a, b, c)) / 2;
    const cells = (id: string) => shapes.filter((shape) => shape.id === id);
    const sum = (id: string) =>
      cells(id).reduce((all, { at }) => all + (at[1]![0] - at[0]![0]) ** 2, 0);
    expect(sum('empty') + sum('covered') + sum('pixel')).toBe(256);
    expect(sum('covered')).toBeLessThanOrEqual(triangle);
    expect(sum('covered') + sum('pixel')).toBeGreaterThanOrEqual(triangle);
    expect(values['windows']).toBe(1 + 4 * Number(values['divided']));
    const corners = area(a, b, c) > 0 ? [a, b, c] : [a, c, b];
    for (const { at } of cells('empty'))
      expect(inside(between(at[0]!, at[2]!, 0.5), corners)).toBe(false);
    for (const { at } of cells('covered'))
      for (const corner of at)
        corners.forEach((from, i) => {
          expect(area(from, corners[(i + 1) % 3]!, corner)).toBeGreaterThanOrEqual(0);
        });
  }
});

it('invisibility counts at every point of the line the surfaces that hold it', () => {
  for (const spots of placesOf(invisibility)) {
    const { values, shapes } = invisibility.look(spots);
    const [p, q] = [spots['p']!, spots['q']!];
    const outlines = ['surface1', 'surface2'].map(
      (id) => shapes.find((shape) => shape.id === id && shape.kind === 'polygon')!.at,
    );
    const count = (t: number): number =>
      outlines.filter((outline) => inside(between(p, q, t), outline)).length;
    const counts = Array.from({ length: 4000 }, (_, i) => count((i + 0.5) / 4000));
    const seen = counts.filter((value) => value === 0).length / 40;
    expect(Math.abs(Number(values['seen']) - seen)).toBeLessThan(0.2);
    const changed = counts.filter((value, i) => i === 0 || value !== counts[i - 1]);
    expect(values['numbers']).toBe(changed.join(', '));
    expect([values['start'], values['most']]).toEqual([counts[0], Math.max(...counts)]);
    expect(values['crossings']).toBe(
      outlines.reduce((all, outline) => {
        const flags = counts.map((_, i) => inside(between(p, q, (i + 0.5) / 4000), outline));
        return all + flags.filter((flag, i) => i > 0 && flag !== flags[i - 1]).length;
      }, 0),
    );
  }
});

describe('the model of rays', () => {
  it('meets the walls that lie across the ray, the nearest first', () => {
    for (const spots of placesOf(ray)) {
      const { values } = ray.look(spots);
      const [eye, pixel] = [[0, -4.5] as Spot, spots['pixel']!];
      const far = between(eye, pixel, 40);
      const walls: [string, Spot, Spot][] = [
        ['1', [-5, 4], [5, 4]],
        ['2', spots['c']!, spots['d']!],
        ['3', spots['m']!, spots['n']!],
      ];
      const met = walls.filter(([, a, b]) => cross(eye, far, a, b));
      if (walls.some(([, a, b]) => cross(eye, far, a, b) === undefined)) continue;
      expect(values['hits']).toBe(met.length);
      const at = (name: string): Spot => between(eye, pixel, Number(values[`t${name}`]));
      for (const [name, a, b] of met) expect(Math.abs(area(a, b, at(name)))).toBeLessThan(1e-9);
      const least = Math.min(...met.map(([name]) => Number(values[`t${name}`])));
      if (met.length > 0) expect(values[`t${String(values['nearest'])}`]).toBe(least);
      else expect(values['nearest']).toBe('0');
      if (met.length === 0) continue;
      const blockers = walls.filter(([name]) => name !== values['nearest']);
      const way = blockers.map(([, a, b]) =>
        cross(at(String(values['nearest'])), spots['light']!, a, b),
      );
      if (values['lit'] === 1) expect(way).not.toContain(true);
      expect(values['rays']).toBe(values['nearest'] === '3' ? 3 : 2);
    }
  });
  it('reflects at the mirror as at the beginning: wall 2 is seen in it, and the light is free', () => {
    expect(ray.look(ray.spots).values).toMatchObject({
      nearest: '3',
      second: '2',
      lit: 1,
      hits: 2,
    });
  });
});

it('shading has the cosines of the angles, by the law of cosines', () => {
  for (const spots of placesOf(shading)) {
    const { values } = shading.look(spots);
    const [light, eye] = [spots['light']!, spots['eye']!];
    const [theta, view] = [Math.atan2(light[0], light[1]), Math.atan2(eye[0], eye[1])];
    const alpha = (theta + view) / 2;
    expect(values['diffuse']).toBeCloseTo(0.5 * Math.cos(theta), 9);
    expect(values['theta']).toBeCloseTo((Math.abs(theta) * 180) / Math.PI, 5);
    expect(values['alpha']).toBeCloseTo((Math.abs(alpha) * 180) / Math.PI, 5);
    expect(values['specular']).toBeCloseTo(0.35 * Math.cos(alpha) ** 20, 9);
  }
});

it('volumes count behind the point the walls between it and the light', () => {
  let shadows = 0;
  for (const spots of placesOf(volume)) {
    const { values } = volume.look(spots);
    const walls: [Spot, Spot][] = [
      [spots['a']!, spots['b']!],
      [spots['c']!, spots['d']!],
    ];
    const before = (spot: Spot) => walls.map((wall) => cross(spots['light']!, spot, ...wall));
    const [point, eye] = [before(spots['point']!), before(spots['eye']!)];
    if ([...point, ...eye].includes(undefined)) continue;
    const count = (all: (boolean | undefined)[]) => all.filter(Boolean).length;
    shadows += count(point);
    expect(values['fail']).toBe(count(point));
    expect(values['around']).toBe(count(eye));
    expect(values['pass']).toBe(count(point) - count(eye));
  }
  expect(shadows).toBeGreaterThan(20);
});

describe('the model of the exchange', () => {
  it('has the form factor that a sum over directions gives', () => {
    for (const spots of placesOf(exchange)) {
      const { values } = exchange.look(spots);
      const [a, b, c, d] = ['a', 'b', 'c', 'd'].map((name) => spots[name]!) as [
        Spot,
        Spot,
        Spot,
        Spot,
      ];
      let sum = 0;
      const parts = 2000;
      for (let i = 0; i < parts; ++i) {
        const x = between(a, b, (i + 0.5) / parts);
        const sines = [c, d].map((end) => (end[0] - x[0]) / hypot(x, end)) as [number, number];
        sum += Math.abs(sines[1] - sines[0]) / 2;
      }
      expect(values['F12']).toBeCloseTo(sum / parts, 4);
      expect(Number(values['F21']) * hypot(c, d)).toBeCloseTo(
        Number(values['F12']) * hypot(a, b),
        9,
      );
    }
  });
  it('has radiosities that its equations hold for', () => {
    const { values } = exchange.look(exchange.spots);
    const of = (name: string) => Number(values[name]);
    expect(of('B1')).toBeCloseTo(1 + of('rho1') * of('F12') * of('B2'), 9);
    expect(of('B2')).toBeCloseTo(of('rho2') * of('F21') * of('B1'), 9);
  });
});

describe('the names of points', () => {
  const all = Object.entries(models).flatMap(([name, model]) =>
    (['en', 'ja'] as const).map((language) => [name, language, model] as const),
  );
  it.each(all)('of %s do not cover each other, in %s', (_, language, model) => {
    const [left, bottom, right, top] = model.box;
    const scale = 640 / (right - left);
    const points = Object.entries(model.spots).map(([name, [x, y]]) => ({
      text: nameOf('label', model.names[name]!, language),
      x: (x - left) * scale,
      y: (top - y) * scale,
    }));
    const names = placedNames(points, [], 17, [640, (top - bottom) * scale]);
    const halfOf = (text: string) => ((language === 'ja' ? 15 : 9) * text.length) / 2;
    names.forEach((a, i) => {
      for (const b of names.slice(i + 1)) {
        const isAside = Math.abs(a.x - b.x) >= halfOf(a.text) + halfOf(b.text);
        expect(isAside || Math.abs(a.y - b.y) >= 17, `${a.text} and ${b.text}`).toBe(true);
      }
    });
  });
});
