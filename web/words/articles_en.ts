// The words of the articles' page, in English. A part of en.ts.
export const articles = {
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
