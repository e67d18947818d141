import { describe, expect, it } from 'vitest';
import { runs } from '../articles/figures';
import { isRight } from '../articles/grade';
import { linesOf, lineOf, readArticle, type ArticleText, type Part } from '../articles/markup';
import { facing } from '../articles/models/facing';
import { keys } from '../articles/models/keys';
import { layers } from '../articles/models/layers';
import { movedSpot, type Spots } from '../articles/models/model';
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

  it('names figures of the tables only, and shows each that it names', () => {
    const shown = new Set(en.sections.map(({ figure }) => figure));
    for (const figure of shown)
      if (figure) expect(figure in runs !== figure in models, figure).toBe(true);
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

  it('has 600 to 1,200 words, and three exercises with the same right answers', () => {
    const words = linesOf(en)
      .map((line) => line.map((part) => ('text' in part ? part.text : '1')).join(''))
      .join(' ')
      .split(/\s+/).length;
    expect(words).toBeGreaterThanOrEqual(600);
    expect(words).toBeLessThanOrEqual(1200);
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

describe('the models', () => {
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
    expect(isRight(given, wanted)).toBe(right);
  });
});
