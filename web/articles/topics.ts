// The articles in their order, with the models of their figures and their place in the lecture.
// A topic's texts are text/ID.en.txt, text/ID.ja.txt, and those of other languages.
import type { Language } from '../words/language';
import { readArticle, type ArticleText } from './markup';
import { exchange } from './models/exchange';
import { facing } from './models/facing';
import { invisibility } from './models/invisibility';
import { keys } from './models/keys';
import { layers } from './models/layers';
import type { Model } from './models/model';
import { planeSide } from './models/plane_side';
import { precision } from './models/precision';
import { ray } from './models/ray';
import { scanEdges } from './models/scan_edges';
import { shading } from './models/shading';
import { volume } from './models/volume';
import { windows } from './models/windows';

export interface Topic {
  readonly id: string;
  /** Rows of the lecture's slides (docs/papers.md). */
  readonly rows: string;
}

export const topics: readonly Topic[] = [
  { id: 'visibility', rows: 'L1, L2' },
  { id: 'back-faces', rows: 'L3, L4' },
  { id: 'painters', rows: 'L5' },
  { id: 'newell-bsp', rows: 'L5' },
  { id: 'scan-line', rows: 'L6, L7' },
  { id: 'z-buffer', rows: 'L8' },
  { id: 'areas', rows: '' },
  { id: 'hidden-lines', rows: 'L1' },
  { id: 'ray-casting', rows: 'L9, L10' },
  { id: 'shading', rows: 'K2, K3' },
  { id: 'stencil-shadows', rows: 'K3.2' },
  { id: 'item-buffer', rows: 'K4' },
  { id: 'radiosity', rows: 'F1, F2' },
];

export const models: Readonly<Record<string, Model>> = {
  facing,
  keys,
  layers,
  depth: precision,
  edges: scanEdges,
  sides: planeSide,
  windows,
  contour: invisibility,
  ray,
  light: shading,
  volume,
  exchange,
};

const files = import.meta.glob<string>('./text/*.txt', {
  query: '?raw',
  import: 'default',
  eager: true,
});
const read = new Map<string, ArticleText>();

const fileOf = (id: string, language: Language): string => `./text/${id}.${language}.txt`;

/** The language of the article's text: English if it is not written in this one. */
export const writtenIn = (id: string, language: Language): Language =>
  fileOf(id, language) in files ? language : 'en';

export function articleOf(id: string, language: Language): ArticleText {
  const path = fileOf(id, writtenIn(id, language));
  const known = read.get(path) ?? readArticle(files[path]!);
  read.set(path, known);
  return known;
}
