// The article that is shown, in the page's address: "#article=back-faces".
import { addressOf, known, putSettings, settingsFrom, type Settings } from '../model/settings';

export interface ArticlesState extends Settings {
  /** '': the list of all. */
  article: string;
}

export function toArticlesAddress(state: ArticlesState, defaults: Settings): string {
  const parts = new URLSearchParams();
  if (state.article) parts.set('article', state.article);
  putSettings(parts, state, defaults);
  return addressOf(parts);
}

export function fromArticlesAddress(
  hash: string,
  defaults: Settings,
  articles: readonly string[],
): ArticlesState {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  return { ...settingsFrom(parts, defaults), article: known(parts.get('article'), articles, '') };
}
