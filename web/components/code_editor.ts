// CodeMirror as an editor of JavaScript or Python with one line marked as wrong. Tab leaves it
// (Escape is not needed). A page takes it as a script of its own, since it is large.
import { javascript } from '@codemirror/lang-javascript';
import { python } from '@codemirror/lang-python';
import { syntaxHighlighting } from '@codemirror/language';
import { Compartment, StateEffect, StateField, type Text } from '@codemirror/state';
import { Decoration, EditorView, type DecorationSet } from '@codemirror/view';
import { classHighlighter } from '@lezer/highlight';
import { basicSetup } from 'codemirror';

export interface CodeEditor {
  show(text: string): void;
  speak(language: 'javascript' | 'python'): void;
  /** 1, 2, ...; 0: none. */
  mark(line: number): void;
  /** Letters on a dark ground. */
  darken(dark: boolean): void;
  destroy(): void;
}

const mark = StateEffect.define<number>();
const decorations = (line: number, doc: Text): DecorationSet =>
  line >= 1 && line <= doc.lines
    ? Decoration.set([Decoration.line({ class: 'wrong-line' }).range(doc.line(line).from)])
    : Decoration.none;
const marked = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update: (now, transaction) =>
    transaction.effects
      .filter((effect) => effect.is(mark))
      .reduce(
        (_, effect) => decorations(effect.value as number, transaction.state.doc),
        now.map(transaction.changes),
      ),
  provide: (field) => EditorView.decorations.from(field),
});

const spoken = new Compartment();
const ground = new Compartment();
const groundOf = (dark: boolean) => EditorView.theme({}, { dark });

export function codeEditor(
  parent: HTMLElement,
  text: string,
  label: string,
  onchange: (text: string) => void,
): CodeEditor {
  const view = new EditorView({
    parent,
    doc: text,
    extensions: [
      basicSetup,
      spoken.of(javascript()),
      syntaxHighlighting(classHighlighter),
      ground.of(groundOf(false)),
      marked,
      // A text that Tab reaches can be scrolled by keys.
      EditorView.contentAttributes.of({ 'aria-label': label, tabindex: '0' }),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) onchange(update.state.doc.toString());
      }),
    ],
  });
  return {
    show(now) {
      const { doc } = view.state;
      if (doc.toString() !== now)
        view.dispatch({ changes: { from: 0, to: doc.length, insert: now } });
    },
    speak: (language) =>
      view.dispatch({
        effects: spoken.reconfigure(language === 'python' ? python() : javascript()),
      }),
    mark: (line) => view.dispatch({ effects: mark.of(line) }),
    darken: (dark) => view.dispatch({ effects: ground.reconfigure(groundOf(dark)) }),
    destroy: () => view.destroy(),
  };
}
