// The words of a quiz, beside those of all pages.
export const quiz = {
  title: 'Hidden surfaces: exercises',
  question: 'Question {0} of {1}',
  questions: 'Questions',
  check: 'Check',
  right: 'Right.',
  wrong: 'Not right. Try again, or look at the step that decides.',
  wrong_among: 'Not right: all that fit, and no others.',
  number: 'Your answer, a whole number',
  why: 'Show me why',
  hide: 'Hide the steps',
  next: 'Next question',
  answer: 'The answer is {0}.',
  score: '{0} of {1} right at the first try',
  done: 'All questions are answered: {0} of {1} right at the first try.',
  corners: 'Corners: pixels from the upper left; Z: 0 nearest, 1 farthest',
  corner: 'Corner',
  again: 'Another quiz',
  only: 'Only questions of this kind: {0}',
  seed: 'Quiz {0}',
  keys: 'Keys: arrows step through an opened run; Tab and Space choose an answer.',
} as const;

export type QuizWords = Readonly<Record<keyof typeof quiz, string>>;
