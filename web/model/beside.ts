// Whether the lab and the articles stand in one folder: their scripts then mark both pages, and
// only marked pages have links to each other.
export const hasOther = document.documentElement.dataset['beside'] === 'yes';
