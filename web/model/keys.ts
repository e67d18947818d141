// Keys of a page and their effects. Keys that are typed into fields, or with Ctrl, Alt or Meta, are
// not the page's.
export type KeyActions = Readonly<Record<string, (() => void) | false | undefined>>;

const fields = 'input:not([type=checkbox]), select, textarea, [contenteditable]';

/** Does what the key stands for. `notIn`: elements that have these keys themselves. */
export function pressKey(event: KeyboardEvent, actions: KeyActions, notIn = fields): void {
  const target = event.target as HTMLElement;
  if (event.ctrlKey || event.altKey || event.metaKey || target.matches(notIn)) return;
  const action = actions[event.key];
  if (!action) return;
  action();
  event.preventDefault();
}

/** Space is also the key of these elements. */
export const hasSpace = (event: KeyboardEvent): boolean =>
  (event.target as HTMLElement).matches('button, summary, input');

/** Keys 1, 2, ... for the words. */
export const byNumber = <Word>(words: readonly Word[], choose: (word: Word) => void): KeyActions =>
  Object.fromEntries(words.map((word, i) => [String(i + 1), () => choose(word)]));

/** Arrows for steps to the right and down. */
export const arrows = (move: (dx: number, dy: number) => void): KeyActions => ({
  ArrowLeft: () => move(-1, 0),
  ArrowRight: () => move(1, 0),
  ArrowUp: () => move(0, -1),
  ArrowDown: () => move(0, 1),
});
