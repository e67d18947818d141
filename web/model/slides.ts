// Steps as slides: each an SVG of 1280 x 720 with the picture, its sentences and its number. The
// browser prints them, one a page.
import { linesOfText } from './caption';
import { drawingOf } from './export';
import type { Step } from './steps/log';
import { stagesIn, type Story } from './steps/stories';
import { storyIn, type Language } from '../words/language';

export const [slideWidth, slideHeight] = [1280, 720];
/** More decisive steps are left out. */
export const mostSlides = 60;
const namespace = 'http://www.w3.org/2000/svg';
const family = "'Noto Sans', 'Noto Sans CJK JP', 'Hiragino Sans', 'Yu Gothic', sans-serif";

/** Steps done at each slide, and what is told there beside the step's sentence. */
export interface Stop {
  readonly at: number;
  readonly told?: string | undefined;
}

/** The decisive steps and the end. */
export function decisiveStops(steps: readonly Step[]): Stop[] {
  const all = steps.flatMap((step, i) => (step.decisive === true ? [{ at: i + 1 }] : []));
  const first = all.slice(0, mostSlides - 1);
  return first.at(-1)?.at === steps.length ? first : [...first, { at: steps.length }];
}

export function storyStops(story: Story, steps: readonly Step[], language: Language): Stop[] {
  const said = storyIn(story.id, language, true);
  return stagesIn(story, steps).map(({ at, stage }) => ({ at, told: said[stage] }));
}

export interface SlideText {
  readonly title: string;
  /** The first of them is larger. */
  readonly paragraphs: readonly string[];
  readonly foot: string;
}

function textAt(x: number, y: number, size: number, words: string, color = '#17181c'): SVGElement {
  const text = document.createElementNS(namespace, 'text');
  const attributes = { x, y, fill: color, 'font-family': family, 'font-size': size };
  for (const [name, value] of Object.entries(attributes)) text.setAttribute(name, String(value));
  text.textContent = words;
  return text;
}

function ruler(size: number): (text: string) => number {
  const context = document.createElement('canvas').getContext('2d')!;
  context.font = `${size}px ${family}`;
  return (text) => context.measureText(text).width;
}

/** The letters become smaller until all of the text fits beside the picture. */
function column(paragraphs: readonly string[], x: number, width: number): SVGElement[] {
  const [top, bottom] = [112, 655];
  for (let size = 30; ; size -= 2) {
    const out: SVGElement[] = [];
    let y = top;
    paragraphs.forEach((paragraph, i) => {
      const letters = i === 0 ? size : Math.round(0.8 * size);
      const color = i === 0 ? '#17181c' : '#4d4d55';
      y += i === 0 ? letters : 1.6 * letters;
      for (const line of linesOfText(paragraph, width, ruler(letters))) {
        out.push(textAt(x, y, letters, line, color));
        y += 1.4 * letters;
      }
    });
    if (y <= bottom || size <= 12) return out;
  }
}

/** The picture of the page as it stands there now. */
export function slideOf(
  canvas: HTMLCanvasElement,
  overlay: SVGSVGElement,
  { title, paragraphs, foot }: SlideText,
): SVGSVGElement {
  const slide = document.createElementNS(namespace, 'svg');
  slide.setAttribute('xmlns', namespace);
  slide.setAttribute('viewBox', `0 0 ${slideWidth} ${slideHeight}`);
  slide.setAttribute('width', String(slideWidth));
  slide.setAttribute('height', String(slideHeight));
  slide.setAttribute('role', 'img');
  slide.setAttribute('aria-label', [title, ...paragraphs].join(' '));
  const ground = document.createElementNS(namespace, 'rect');
  ground.setAttribute('width', '100%');
  ground.setAttribute('height', '100%');
  ground.setAttribute('fill', '#ffffff');
  const picture = drawingOf(canvas, overlay);
  const scale = Math.min(740 / canvas.width, 555 / canvas.height);
  const [width, height] = [canvas.width * scale, canvas.height * scale];
  for (const name of ['role', 'aria-label', 'class', 'style']) picture.removeAttribute(name);
  Object.entries({ x: 40, y: 100, width, height }).forEach(([name, value]) =>
    picture.setAttribute(name, String(Math.round(value))),
  );
  const headline = textAt(40, 66, 34, title);
  headline.setAttribute('font-weight', 'bold');
  const left = 40 + width + 36;
  slide.append(ground, headline, picture, ...column(paragraphs, left, slideWidth - left - 40));
  slide.append(textAt(40, 700, 18, foot, '#595959'));
  return slide;
}

const sheet = `
@page { size: ${slideWidth}px ${slideHeight}px; margin: 0; }
body.slides { margin: 0; padding: 0; max-width: none; }
body.slides > :not(.deck) { display: none !important; }
.deck svg { display: block; break-after: page; break-inside: avoid; }
.deck svg:last-child { break-after: auto; }`;

/** Shows the slides instead of the page; answers with what takes them away. */
export function showSlides(slides: readonly SVGSVGElement[]): () => void {
  const deck = document.createElement('div');
  deck.className = 'deck';
  deck.append(...slides);
  const style = document.createElement('style');
  style.textContent = sheet;
  document.head.append(style);
  document.body.append(deck);
  document.body.classList.add('slides');
  return () => {
    document.body.classList.remove('slides');
    deck.remove();
    style.remove();
  };
}

/** The browser's dialog: a printer, or a PDF. */
export function printSlides(slides: readonly SVGSVGElement[]): void {
  const leave = showSlides(slides);
  addEventListener('afterprint', leave, { once: true });
  print();
}

export const fileOfSlide = (slide: SVGSVGElement): string =>
  `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(slide)}\n`;
