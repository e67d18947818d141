// The search of the site: sections that have all words, those with a word in the heading first.
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
    found.push({ address, heading, text, hits });
  }
  return found.sort((a, b) => b.hits - a.hits).slice(0, 20);
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
      if (!list.hidden && found.length === 0) list.textContent = 'Nothing has these words.';
    });
  });
}
if (typeof module !== 'undefined') module.exports = { search };
