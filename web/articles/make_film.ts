// Runs the commands of a film and reads what they wrote. Only the build and its test use it.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Film, FilmValues } from './film';
import type { FilmFigure } from './films';

type Row = readonly [name: string, values: FilmValues];

interface Counted {
  readonly by_name: readonly {
    readonly name: string;
    readonly runs: number;
    readonly counters: Readonly<Record<string, number>>;
  }[];
}

/** Rows of a CSV file or of the counters of passes. */
function rowsOf(file: string): Row[] {
  const text = readFileSync(file, 'utf8');
  if (file.endsWith('.json'))
    return (JSON.parse(text) as Counted).by_name.map(({ name, runs, counters }) => [
      name,
      { runs, ...counters },
    ]);
  const [head, ...lines] = text.trim().split('\n');
  const names = head!.split(',');
  return lines.map((line) => {
    const cells = line.split(',').map((cell, i) => [names[i]!, Number(cell)] as const);
    return [line, Object.fromEntries(cells.filter(([, value]) => Number.isFinite(value)))];
  });
}

const begins = (name: string, words: string): boolean =>
  words === '' || name === words || name.startsWith(`${words} `) || name.startsWith(`${words},`);

function sumOf(rows: readonly Row[], words: string): FilmValues {
  const sum: Record<string, number> = {};
  for (const [name, values] of rows)
    if (begins(name, words))
      for (const [key, value] of Object.entries(values)) sum[key] = (sum[key] ?? 0) + value;
  if (Object.keys(sum).length === 0) throw new Error(`no row begins with '${words}'`);
  return sum;
}

export function makeFilm(figure: FilmFigure, gw: string, scenes: string): Film {
  const out = mkdtempSync(join(tmpdir(), 'gw-film-'));
  for (const command of figure.commands) {
    const words = command.split(' ').map((word) => word.replace(/^OUT/, out));
    const all = words.map((word) => word.replace(/^SCENES/, scenes));
    execFileSync(gw, all, { stdio: ['ignore', 'ignore', 'inherit'] });
  }
  const frames = figure.frames.map(({ picture, table, row }) => ({
    picture: readFileSync(join(out, picture)).toString('base64'),
    values: sumOf(rowsOf(join(out, table)), row),
  }));
  rmSync(out, { recursive: true });
  return { frames };
}
