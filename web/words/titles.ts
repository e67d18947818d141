// The titles of the project's algorithms. The English ones come with the data.
import type { Language } from './language';
import { translated } from './names';

/**
 * A student's own algorithm keeps the title that it has. The code of a lecture's row stays away:
 * few readers have that lecture.
 */
export const titleOf = (algorithm: string, title: string, language: Language): string =>
  translated('title', algorithm, language) ?? title.replace(/ \[L\d+\]$/, '');
