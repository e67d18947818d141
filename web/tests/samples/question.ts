// A question as the command writes it.
import type { Question } from '../../model/quiz';

const text = (en: string) => ({ en, ja: `${en}。` });

export const question: Question = {
  kind: 'order',
  title: text('Painting order'),
  text: text('Which order gives the picture?'),
  choices: [text('1 2'), text('2 1')],
  among: 0,
  answer: 'b',
  why: text('1 lies before 2.'),
  drawing: '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 3"></svg>',
  spoken: text('A drawing of 2 polygons.'),
  corners: [],
  algorithm: 'newell',
  step: 3,
};
