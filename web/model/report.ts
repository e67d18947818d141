// A report as `gw inspect` writes it: data.js calls gw_report with this, pictures lie beside the
// page (docs/recordings.md). Does not draw.
export const planeNames = [
  'color',
  'depth',
  'stencil',
  'back',
  'accum',
  'polygons',
  'identifiers',
] as const;
export type PlaneName = (typeof planeNames)[number];

/** Names of pictures; without `change` the pass left the plane as it was. */
export interface PlanePictures {
  readonly before: string;
  readonly after: string;
  readonly change?: string;
  /** Changed ones. */
  readonly pixels?: number;
  /** The difference is amplified so much. */
  readonly times?: number;
}

export interface Pass {
  readonly pass: number;
  readonly name: string;
  /** The parameter set as the paper writes it; empty: none. */
  readonly set: string;
  /** Places of its commands. */
  readonly first: number;
  readonly end: number;
  /** What differs from the pass before. */
  readonly state: readonly (readonly [string, string])[];
  readonly counters: Readonly<Record<string, number>>;
  readonly estimated_seconds: number;
  readonly identifiers: boolean;
  /** Through which a screen shows its colours: a place in Report.maps. */
  readonly map?: number;
  readonly planes: Readonly<Partial<Record<PlaneName, PlanePictures>>>;
}

/** A map as a report has it. */
export interface MapChange {
  /** 'window'; index 0 of planes above or below it shows what is below. */
  readonly planes: string;
  readonly bits: number;
  /** Of an index, its lowest; the others are in G. */
  readonly bits_in_r: number;
  /** Indices and colours, R in the lowest byte, that the map before it has not. */
  readonly changes: readonly (readonly [number, number])[];
}

export interface Price {
  readonly count: string;
  readonly stage: string;
  readonly nanoseconds: number;
  readonly estimate: boolean;
  readonly source: string;
}

/** First, before, number, step, after, primitive, ordinal: report_json.cpp. */
export type CallRun = readonly [number, string, number, number, string, string, number];

export interface Report {
  readonly version: number;
  readonly file: string;
  readonly command: string;
  readonly language: string;
  readonly scene: string;
  readonly renderer: string;
  readonly profile: { readonly name: string; readonly color_bits: number };
  readonly width: number;
  readonly height: number;
  readonly passes_of_recording: number;
  /** Pictures have smaller ones beside them. */
  readonly small: boolean;
  readonly time: { readonly machine: string; readonly prices: readonly Price[] };
  readonly history: { readonly first: number; readonly last: number } | null;
  /** Pixels of a side of a tile of histories. */
  readonly tile: number;
  readonly commands: readonly string[];
  readonly calls: readonly (readonly CallRun[])[];
  readonly passes: readonly Pass[];
  /** Without them no colour is an index. */
  readonly maps?: readonly MapChange[];
}

export const isInside = (report: Report, x: number, y: number): boolean =>
  [x, y].every((v) => Number.isInteger(v) && v >= 0) && x < report.width && y < report.height;

export const planesOfPass = (pass: Pass): PlaneName[] =>
  planeNames.filter((plane) => pass.planes[plane] !== undefined);
export const isChanged = (pass: Pass, plane: PlaneName): boolean =>
  pass.planes[plane]?.change !== undefined;

/**
 * Identifiers if the pass wrote some, else the first plane that it changed; of a pass of
 * identifiers that changed nothing, these too.
 */
export function tellingPlane(pass: Pass): PlaneName {
  if (pass.identifiers && isChanged(pass, 'identifiers')) return 'identifiers';
  const changed = planesOfPass(pass).find((plane) => isChanged(pass, plane));
  return changed ?? (pass.identifiers ? 'identifiers' : 'color');
}

export const passOfCommand = (report: Report, command: number): Pass =>
  report.passes.find((pass) => command >= pass.first && command < pass.end)!;

export function timeText(seconds: number): string {
  if (seconds >= 0.9995) return `${seconds.toPrecision(3)} s`;
  if (seconds >= 0.9995e-3) return `${(seconds * 1e3).toPrecision(3)} ms`;
  return `${(seconds * 1e6).toPrecision(3)} µs`;
}

/** The parameter set in parts: members, and what stands between them. */
export function setParts(set: string): { text: string; kind: 'off' | 'on' | 'between' }[] {
  return set
    .split(/([^(), ]+=[^,)]*)/)
    .filter((text) => text !== '')
    .map((text) => ({
      text,
      kind: /=(0|none)$/.test(text) ? 'off' : text.includes('=') ? 'on' : 'between',
    }));
}

/** "Pixel {0}, {1}" with the values in place of the numbers. */
export const filled = (pattern: string, ...values: readonly (string | number)[]): string =>
  pattern.replace(/\{(\d)\}/g, (_, i: string) => String(values[Number(i)]));
