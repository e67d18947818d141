// A step as a picture file: SVG, PNG, or a range of steps as GIF.
import { applyPalette, GIFEncoder, quantize } from 'gifenc';
import { withCaption, type Lettering } from './caption';

/** The drawing over the pixels, as one SVG without references. */
export function drawingOf(canvas: HTMLCanvasElement, overlay: SVGSVGElement): SVGSVGElement {
  const svg = overlay.cloneNode(true) as SVGSVGElement;
  const box = overlay.getBoundingClientRect();
  const [, , width = '0', height = '0'] = (svg.getAttribute('viewBox') ?? '').split(' ');
  svg.removeAttribute('aria-hidden'); // in the page its canvas speaks
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', canvas.getAttribute('aria-label') ?? '');
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  svg.setAttribute('width', String(Math.round(box.width)));
  svg.setAttribute('height', String(Math.round(box.height)));
  const image = document.createElementNS('http://www.w3.org/2000/svg', 'image');
  image.setAttribute('href', canvas.toDataURL());
  image.setAttribute('width', width);
  image.setAttribute('height', height);
  image.setAttribute('style', 'image-rendering: pixelated');
  svg.prepend(image);
  return svg;
}

export const svgOf = (canvas: HTMLCanvasElement, overlay: SVGSVGElement): string =>
  new XMLSerializer().serializeToString(drawingOf(canvas, overlay));

async function rastered(
  canvas: HTMLCanvasElement,
  overlay: SVGSVGElement,
): Promise<HTMLCanvasElement> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgOf(canvas, overlay))}`;
  await image.decode();
  const out = document.createElement('canvas');
  out.width = image.width;
  out.height = image.height;
  const context = out.getContext('2d')!;
  context.imageSmoothingEnabled = false;
  context.drawImage(canvas, 0, 0, out.width, out.height);
  context.drawImage(image, 0, 0);
  return out;
}

export async function pngOf(canvas: HTMLCanvasElement, overlay: SVGSVGElement): Promise<Blob> {
  const out = await rastered(canvas, overlay);
  return new Promise((resolve, reject) =>
    out.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png'),
  );
}

/** Two steps as typed, in any order, as a range within 0 .. last. Empty: the first and the last. */
export function rangeOf(a: number | null, b: number | null, last: number): [number, number] {
  const within = (step: number): number => Math.min(Math.max(Math.trunc(step), 0), last);
  const first = within(a ?? 0);
  const second = within(b ?? last);
  return [Math.min(first, second), Math.max(first, second)];
}

/** A step on the page: its picture, the drawing over it, and its sentence. */
export interface Shown {
  readonly canvas: HTMLCanvasElement;
  readonly overlay: SVGSVGElement;
  readonly text: string;
}

/** How long the last step stays before a GIF begins again. */
const rest = 2000;

/**
 * `show` brings a step to the page and resolves when it is drawn. Each picture has its sentence
 * below.
 */
export async function gifOf(
  from: number,
  to: number,
  milliseconds: number,
  lettering: Lettering,
  show: (step: number) => Promise<Shown>,
): Promise<Blob> {
  const gif = GIFEncoder();
  for (let step = from; step <= to; ++step) {
    const { canvas, overlay, text } = await show(step);
    const picture = withCaption(await rastered(canvas, overlay), text, lettering);
    const { data, width, height } = picture
      .getContext('2d')!
      .getImageData(0, 0, picture.width, picture.height);
    const palette = quantize(data, 256);
    const delay = step === to ? Math.max(rest, milliseconds) : milliseconds;
    gif.writeFrame(applyPalette(data, palette), width, height, { palette, delay });
  }
  gif.finish();
  return new Blob([gif.bytes()], { type: 'image/gif' });
}

export function save(content: Blob | string, name: string, type = 'image/svg+xml'): void {
  const blob = typeof content === 'string' ? new Blob([content], { type }) : content;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
