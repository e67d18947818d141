// The search of the site: sections that have all words. First those with a word in the heading,
// among them the articles; then those that have the words most often.
// `pages` is made by scripts/site: [address, heading, text] of each section.
'use strict';

function search(pages, question) {
  const words = question.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const found = [];
  for (const [address, heading, text] of pages) {
    const head = heading.toLowerCase();
    const all = head + ' ' + text.toLowerCase();
    if (!words.every((word) => all.includes(word))) continue;
    const hits = words.filter((word) => head.includes(word)).length;
    const times = words.reduce((sum, word) => sum + all.split(word).length - 1, 0);
    const isArticle = Number(address.startsWith('articles.html'));
    found.push({ address, heading, text, rank: [hits, isArticle, times] });
  }
  const before = (a, b) => b[0] - a[0] || b[1] - a[1] || b[2] - a[2];
  return found.sort((a, b) => before(a.rank, b.rank)).slice(0, 20);
}

if (typeof document !== 'undefined') {
  const root = document.documentElement;
  if (matchMedia('(prefers-color-scheme: dark)').matches) root.dataset.theme = 'dark';
  addEventListener('DOMContentLoaded', () => {
    const input = document.querySelector('.site input');
    const list = document.querySelector('.found');
    input.addEventListener('input', () => {
      const found = search(window.pages, input.value);
      list.replaceChildren(
        ...found.map(({ address, heading, text }) => {
          const item = document.createElement('li');
          const link = document.createElement('a');
          link.href = input.dataset.root + address;
          link.textContent = heading;
          item.append(link, ' ' + text.slice(0, 140));
          return item;
        }),
      );
      list.hidden = input.value.trim() === '';
      if (!list.hidden && found.length === 0) list.textContent = input.dataset.none;
    });
  });
}
