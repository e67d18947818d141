import { describe, expect, it } from 'vitest';
import { labAddress, runs } from '../articles/figures';
import { films } from '../articles/films';
import { gradeOf } from '../articles/grade';
import { linesOf, lineOf, readArticle, type ArticleText, type Part } from '../articles/markup';
import { facing } from '../articles/models/facing';
import { keys } from '../articles/models/keys';
import { layers } from '../articles/models/layers';
import { movedSpot, type Spot, type Spots } from '../articles/models/model';
import { planeSide } from '../articles/models/plane_side';
import { precision } from '../articles/models/precision';
import { scanEdges } from '../articles/models/scan_edges';
import { articleOf, models, topics } from '../articles/topics';

const ids = topics.map(({ id }) => id);
const bindingsOf = (text: ArticleText): Part[] =>
  linesOf(text).flatMap((line) => line.filter(({ kind }) => kind !== 'text' && kind !== 'strong'));

/** What a part is bound to, without its words. */
const nameOf = (part: Part): string => JSON.stringify({ ...part, text: '' });

describe.each(ids)('the article %s', (id) => {
  const [en, ja] = [articleOf(id, 'en'), articleOf(id, 'ja')];

  it('binds the same words and numbers to the same figures in both languages', () => {
    expect([...new Set(bindingsOf(ja).map(nameOf))].sort()).toEqual(
      [...new Set(bindingsOf(en).map(nameOf))].sort(),
    );
    const figures = (text: ArticleText) => text.sections.map(({ figure }) => figure);
    expect(figures(ja)).toEqual(figures(en));
  });

  it('has no blank beside a Japanese comma, full stop or bracket', () => {
    const said = linesOf(ja).map((line) => line.map((part) => ('text' in part ? part.text : '1')));
    for (const text of said.map((parts) => parts.join('')))
      expect(text).not.toMatch(/[、。」）] | [、。「（]/);
  });

  it('names figures of the tables only, and shows each that it names', () => {
    const shown = new Set(en.sections.map(({ figure }) => figure));
    for (const figure of shown)
      if (figure)
        expect([runs, models, films].filter((table) => figure in table).length, figure).toBe(1);
    for (const part of bindingsOf(en))
      if ('figure' in part) expect(shown.has(part.figure), part.figure).toBe(true);
  });

  it('names shapes and values that its models have', () => {
    for (const part of bindingsOf(en)) {
      if (!('figure' in part) || !(part.figure in models)) continue;
      const model = models[part.figure]!;
      const { shapes, values } = model.look(model.spots);
      if (part.kind === 'number') expect(values, part.name).toHaveProperty([part.name]);
      else if (part.kind === 'piece')
        expect(
          shapes.some((shape) => shape.id === part.name),
          part.name,
        ).toBe(true);
      else expect.fail(`${part.figure} has no steps`);
    }
  });

  it('has 600 to 1,200 words, 1,800 to 3,600 signs in Japanese, and three exercises with the same right answers', () => {
    const words = linesOf(en)
      .map((line) => line.map((part) => ('text' in part ? part.text : '1')).join(''))
      .join(' ')
      .split(/\s+/).length;
    expect(words).toBeGreaterThanOrEqual(600);
    expect(words).toBeLessThanOrEqual(1200);
    const signs = linesOf(ja)
      .map((line) => line.map((part) => ('text' in part ? part.text : '1')).join(''))
      .join('').length;
    expect(signs).toBeGreaterThanOrEqual(1800);
    expect(signs).toBeLessThanOrEqual(3600);
    const keys = (text: ArticleText) =>
      text.exercises.map(({ answers }) => answers.map(({ right }) => right));
    expect(en.exercises).toHaveLength(3);
    expect(keys(ja)).toEqual(keys(en));
  });

  it('has sentences of fewer than 25 words', () => {
    for (const line of linesOf(en)) {
      const text = line.map((part) => ('text' in part ? part.text : '1')).join('');
      for (const sentence of text.split(/[.?:;](?:\s|$)/))
        expect(sentence.trim().split(/\s+/).length, sentence).toBeLessThan(25);
    }
  });
});

/** Every spot moved to a few places. */
const places = (name: string): Spots[] => {
  const model = models[name]!;
  const [left, bottom, right, top] = model.box;
  return Object.keys(model.spots).flatMap((spot) =>
    [0, 0.25, 0.5, 0.75, 1].flatMap((x) =>
      [0, 0.3, 0.6, 1].map((y) =>
        movedSpot(model, model.spots, spot, [
          left + x * (right - left),
          bottom + y * (top - bottom),
        ]),
      ),
    ),
  );
};

describe('the models', () => {
  it.each(Object.keys(models))('%s has the same finite values wherever its points are', (name) => {
    const model = models[name]!;
    const names = Object.keys(model.look(model.spots).values).sort();
    for (const spots of places(name)) {
      const { shapes, values } = model.look(spots);
      expect(Object.keys(values).sort()).toEqual(names);
      for (const value of Object.values(values))
        if (typeof value === 'number') expect(Number.isFinite(value)).toBe(true);
      for (const { at } of shapes) expect(at.flat().every(Number.isFinite)).toBe(true);
    }
  });

  it('facing has the side of the eye of each line: twice the area of eye and side', () => {
    for (const spots of places('facing')) {
      const { values } = facing.look(spots);
      const corners = ['a', 'b', 'c', 'd', 'e'].map((name) => spots[name]!);
      corners.forEach(([ax, ay], i) => {
        const [bx, by] = corners[(i + 1) % 5]!;
        const [ex, ey] = spots['eye']!;
        const area = ax * by - bx * ay + bx * ey - ex * by + ex * ay - ax * ey;
        expect(values[`D${i + 1}`]).toBeCloseTo(-area, 9);
      });
    }
  });

  it('facing has a hidden front side if a corner is pulled in, and none while it is convex', () => {
    const pulled = { ...facing.spots, d: [0, 0], eye: [-6, 1.5] } as Spots;
    expect(facing.look(pulled).values['hidden']).toBe(1);
    expect(facing.look(facing.spots).values).toMatchObject({ hidden: 0, front: 1, back: 4 });
  });
});

describe('the model of the painter', () => {
  it('has wrong columns where a small wall is: 10 to a unit of width', () => {
    expect(keys.look(keys.spots).values).toMatchObject({
      order_nearest: '3, 2, 1',
      wrong_nearest: 20,
      order_farthest: '1, 3, 2',
      wrong_farthest: 15,
      order_centroid: '3, 1, 2',
      wrong_centroid: 35,
    });
  });
  it('has none if the long wall is level', () => {
    const level = { ...keys.spots, a: [-5, 0], b: [5, 0] } as Spots;
    const { values } = keys.look(level);
    expect([values['wrong_nearest'], values['wrong_farthest'], values['wrong_centroid']]).toEqual([
      0, 0, 0,
    ]);
  });
});

it('the model of visibility shows on every line of sight one wall or none', () => {
  for (const x of [-5, -2, 0, 3, 6]) {
    const { values } = layers.look({ ...layers.spots, eye: [x, -4] });
    const of = (name: string) => Number(values[name]);
    expect(of('seen1') + of('seen2') + of('seen3') + of('empty')).toBe(9);
    expect(of('met') - of('hidden') + of('empty')).toBe(9);
    expect(of('most')).toBeLessThanOrEqual(3);
  }
});

/** The parameter of a ray at a wall, by Cramer's rule; none: it passes. */
function hitOf(eye: Spot, toward: Spot, [a, b]: readonly [Spot, Spot]): number | undefined {
  const [dx, dy] = [toward[0] - eye[0], toward[1] - eye[1]];
  const [ex, ey] = [a[0] - b[0], a[1] - b[1]];
  const area = dx * ey - dy * ex;
  const [t, s] = [
    ((a[0] - eye[0]) * ey - (a[1] - eye[1]) * ex) / area,
    (dx * (a[1] - eye[1]) - dy * (a[0] - eye[0])) / area,
  ];
  return t > 0 && s >= 0 && s <= 1 ? t : undefined;
}

describe('the model of the planes', () => {
  it('orders two walls as every line of sight does that meets both', () => {
    let met = 0;
    for (const spots of places('sides')) {
      const { values } = planeSide.look(spots);
      const [eye, p, q, c, d] = ['eye', 'p', 'q', 'c', 'd'].map((name) => spots[name]!) as [
        Spot,
        Spot,
        Spot,
        Spot,
        Spot,
      ];
      const area = (s: Spot) => (d[0] - c[0]) * (s[1] - c[1]) - (d[1] - c[1]) * (s[0] - c[0]);
      const length = Math.hypot(d[0] - c[0], d[1] - c[1]);
      if (length === 0) continue;
      expect(Math.abs(Number(values['p']))).toBeCloseTo(Math.abs(area(p)) / length, 9);
      expect(Math.sign(Number(values['p']) * Number(values['eye']))).toBe(
        Math.sign(area(p) * area(eye)) + 0,
      );
      expect(values['pieces']).toBe(area(p) * area(q) < 0 ? 3 : 2);
      if (values['pieces'] === 3 || area(eye) === 0) continue;
      for (let i = 0; i < 40; ++i) {
        const part = (i + 0.5) / 40;
        const toward: Spot = [p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])];
        const [one, two] = [hitOf(eye, toward, [p, q]), hitOf(eye, toward, [c, d])];
        if (one === undefined || two === undefined || Math.abs(one - two) < 1e-9) continue;
        met += 1;
        expect(values['order']).toBe(one < two ? '2, 1' : '1, 2');
      }
    }
    expect(met).toBeGreaterThan(100);
  });
});

it('the model of the scan line has the pixels whose middles are in the triangle', () => {
  for (const spots of places('edges')) {
    const { values } = scanEdges.look(spots);
    const [a, b, c] = ['a', 'b', 'c'].map((name) => spots[name]!) as [Spot, Spot, Spot];
    const y = spots['line']![1] + 0.5;
    const side = (p: Spot, q: Spot, x: number) =>
      (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    let [strict, loose] = [0, 0];
    for (let x = 0.5; x < 24; ++x) {
      const signs = [side(a, b, x), side(b, c, x), side(c, a, x)];
      if (signs.every((s) => s > 0) || signs.every((s) => s < 0)) strict += 1;
      if (signs.every((s) => s >= 0) || signs.every((s) => s <= 0)) loose += 1;
    }
    expect(values['pixels']).toBeGreaterThanOrEqual(strict);
    expect(values['pixels']).toBeLessThanOrEqual(loose);
    expect([0, 2]).toContain(values['edges']);
  }
  expect(scanEdges.look(scanEdges.spots).values).toMatchObject({ begin: 6, pixels: 12, edges: 2 });
});

it('the model of depths stores what the perspective matrix gives', () => {
  for (const spots of places('depth')) {
    const { values } = precision.look(spots);
    const [near, far, z] = ['near', 'far', 'point'].map((name) => spots[name]![0]!) as [
      number,
      number,
      number,
    ];
    const stored = (at: number) =>
      65535 * (((far + near) / (far - near) - (2 * far * near) / ((far - near) * at) + 1) / 2);
    expect(Math.abs(Number(values['stored']) - stored(z))).toBeLessThanOrEqual(0.5001);
    expect(stored(Number(values['half']))).toBeCloseTo(65535 / 2, 4);
    const step = Number(values['step']);
    expect(stored(z + step / 2) - stored(z - step / 2)).toBeCloseTo(1, 2);
  }
});

describe('the markup', () => {
  it('reads words bound to pieces and steps, and numbers', () => {
    expect(lineOf('a [bar](run#3a), [cut](run@split/plane:3,2~2), {run:end.wrong}')).toEqual([
      { kind: 'text', text: 'a ' },
      { kind: 'piece', text: 'bar', figure: 'run', name: '3a' },
      { kind: 'text', text: ', ' },
      {
        kind: 'step',
        text: 'cut',
        figure: 'run',
        step: { test: 'split', result: 'plane', pieces: ['3', '2'], nth: 2 },
      },
      { kind: 'text', text: ', ' },
      { kind: 'number', figure: 'run', step: undefined, name: 'end.wrong' },
    ]);
    expect(lineOf('{run@z/nearer|z}')).toMatchObject([{ step: { test: 'z' }, name: 'z' }]);
  });

  it.each([
    ['[a bar](run)', 'a mark that is none'],
    ['{run}}', 'a mark that is none'],
    ['[{run:z}](run#3)', 'a mark that is none'],
    ['[a](run@split)', 'expected test/result'],
  ])('refuses %s', (line, message) => {
    expect(() => lineOf(line)).toThrow(message);
  });

  it.each([
    ['## only', 'expected # title'],
    ['# t\n\n> l\n\ntext', 'heading before it'],
    ['# t\n\n> l\n\n? q\n+ a', 'and feedback'],
    ['# t\n\n> l\n\n? q\n- a :: f\n- b :: f', 'one right answer'],
  ])('refuses %j', (text, message) => {
    expect(() => readArticle(text)).toThrow(message);
  });
});

describe('an answer', () => {
  it.each([
    ['14', '14', true],
    ['１４', '14', true],
    ['−14', '-14', true],
    ['14.05', '14', false],
    ['0.333', '0.3333', true],
    ['0.32', '0.3333', false],
    ['', '0', false],
    ['x', '1', false],
  ])('%s for %s is right: %s', (given, wanted, right) => {
    expect(gradeOf(given, wanted) === 'right').toBe(right);
  });
});

it('leads to its run in the lab, at the step that is shown', () => {
  for (const run of Object.values(runs)) {
    const parts = new URLSearchParams(labAddress(run, 7).slice(1));
    expect(parts.get('exhibit')).toBe('hidden');
    expect(parts.get('scene')).toBe(`hidden/${run.scene}.toml`);
    expect(parts.get('step')).toBe('7');
  }
});

it('says on which side a wrong number is', () => {
  expect(gradeOf('4', '3')).toBe('large');
  expect(gradeOf('−4', '3')).toBe('small');
  expect(gradeOf('2.9', '3.1')).toBe('small');
  expect(gradeOf('three', '3')).toBe('none');
});
