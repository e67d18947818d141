// The words of the articles' page beside those of all pages.
import type { Words } from './en';

const english = {
  articles_title: 'Hidden surfaces: the articles',
  articles_lead:
    'Each article explains one topic with pictures that you can step through and drag. Point at an underlined word: what it names lights up in the picture.',
  articles_all: 'All articles',
  articles_to_lab: 'The lab',
  articles_lab: 'open in the lab',
  articles_begin: 'Before the first step.',
  articles_drag: 'Drag the circles, or move them with Tab and the arrow keys.',
  articles_reset: 'As at the beginning',
  articles_exercises: 'Exercises',
  articles_answer: 'Your answer',
  articles_check: 'Check',
  articles_right: 'Right.',
  articles_wrong: 'Not yet.',
  articles_too_large: 'Not yet: too large.',
  articles_too_small: 'Not yet: too small.',
  articles_no_number: 'Type a number.',
  articles_score: '{0} of {1} solved',
  articles_rows: 'For those who have the lecture: rows of its slides',
} as const;

export type ArticleWords = Words & Readonly<Record<keyof typeof english, string>>;

const japanese: Readonly<Record<keyof typeof english, string>> = {
  articles_title: '隠面消去：読み物',
  articles_lead:
    '一つの話題を一つの読み物にしました。図はステップごとに進められ、点を動かせます。下線のある言葉を指すと、それが図の中で光ります。',
  articles_all: 'すべての読み物',
  articles_to_lab: '実験室',
  articles_lab: '実験室で開く',
  articles_begin: '最初のステップの前です。',
  articles_drag: '丸い点をドラッグするか、Tab と矢印キーで動かします。',
  articles_reset: '最初に戻す',
  articles_exercises: '演習',
  articles_answer: '答え',
  articles_check: '確かめる',
  articles_right: '正解です。',
  articles_wrong: 'まだ違います。',
  articles_too_large: 'まだ違います。大きすぎます。',
  articles_too_small: 'まだ違います。小さすぎます。',
  articles_no_number: '数を入れてください。',
  articles_score: '{1} 問のうち {0} 問が正解',
  articles_rows: '講義資料のある人へ：スライドの行',
};

export const articleWords = { en: english, ja: japanese };
