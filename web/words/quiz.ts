// The words of a quiz beside those of all pages.
import type { Language } from './language';

const english = {
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

export type QuizWords = Readonly<Record<keyof typeof english, string>>;

const japanese: QuizWords = {
  title: '隠面消去：演習',
  question: '第 {0} 問（全 {1} 問）',
  questions: '問題',
  check: '確かめる',
  right: '正解です。',
  wrong: '違います。もう一度考えるか、判断が決まるステップを見てください。',
  wrong_among: '違います。当てはまるものをすべて、それだけを選びます。',
  number: '答え（整数）',
  why: '理由を見る',
  hide: 'ステップを閉じる',
  next: '次の問題',
  answer: '答えは {0} です。',
  score: '{1} 問のうち {0} 問が初回で正解',
  done: '全問に答えました。{1} 問のうち {0} 問が初回で正解です。',
  corners: '頂点：左上からの画素。Z は 0 が最も近く、1 が最も遠い',
  corner: '頂点',
  again: '別の問題集',
  only: 'この種類だけにする：{0}',
  seed: '問題集 {0}',
  keys: 'キー：開いた実行は矢印で進めます。答えは Tab と Space で選びます。',
};

export const quizWords: Readonly<Record<Language, QuizWords>> = { en: english, ja: japanese };
