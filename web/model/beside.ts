// If the lab and the articles stand in one folder, a script (web/link_pages) writes into each the
// other's name; only then they have links to each other.
export const other = document.documentElement.dataset['beside'] ?? '';
