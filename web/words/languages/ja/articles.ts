// The page of the articles.
export const articles = {
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
