// A sentence below a picture, as letters on a canvas.

/** A Japanese letter with the marks that no line begins with, or a word. */
const unbroken =
  /[\u3040-\u30fe\u3400-\u9fff][、。）」ー]*\s*|[^\s\u3040-\u30fe\u3400-\u9fff]+\s*/g;

/**
 * Lines no wider than `room`; broken at blanks and between Japanese letters, else within a word.
 */
export function linesOfText(
  text: string,
  room: number,
  widthOf: (text: string) => number,
): string[] {
  const lines: string[] = [];
  let line = '';
  for (const part of text.match(unbroken) ?? []) {
    if (widthOf(line + part.trimEnd()) <= room) {
      line += part;
      continue;
    }
    if (line && widthOf(part.trimEnd()) <= room) {
      lines.push(line.trimEnd());
      line = part;
      continue;
    }
    for (const letter of part) {
      if (line && widthOf(line + letter) > room) {
        lines.push(line.trimEnd());
        line = '';
      }
      line += letter;
    }
  }
  if (line.trim()) lines.push(line.trimEnd());
  return lines;
}

/** Letters and colours of the page. */
export interface Lettering {
  readonly letters: number;
  readonly ink: string;
  readonly paper: string;
}

const rows = 3;

/** The picture with room for three lines below; a longer text ends with three dots. */
export function withCaption(
  picture: HTMLCanvasElement,
  text: string,
  { letters, ink, paper }: Lettering,
): HTMLCanvasElement {
  const line = Math.round(1.35 * letters);
  const out = document.createElement('canvas');
  out.width = picture.width;
  out.height = picture.height + rows * line + 10;
  const context = out.getContext('2d')!;
  context.fillStyle = paper;
  context.fillRect(0, 0, out.width, out.height);
  context.drawImage(picture, 0, 0);
  context.fillStyle = ink;
  context.font = `${letters}px sans-serif`;
  context.textBaseline = 'middle';
  const lines = linesOfText(text, out.width - 16, (part) => context.measureText(part).width);
  lines.slice(0, rows).forEach((part, i) => {
    const last = i === rows - 1 && lines.length > rows;
    context.fillText(
      last ? `${part.slice(0, -2)}…` : part,
      8,
      picture.height + 5 + (i + 0.5) * line,
    );
  });
  return out;
}
