// A pass list as a table: a row for a pass, a cell for a key of [[pass]]. Cells are TOML
// (docs/passes.md). Does not judge values: the machine does.
export type PassRow = ReadonlyMap<string, string>;

/** The columns, in the paper's order; keys that a pass lacks have their initial value. */
export const passKeys = [
  'name',
  'Ka',
  'Kd',
  'Ks',
  'Ke',
  'Map',
  'depth',
  'stencil',
  'blend',
  'lights',
  'objects',
  'fog',
  'color',
  'clear',
  'action',
] as const;

const header = '[[pass]]';

export function rowsFrom(toml: string): PassRow[] {
  const rows: Map<string, string>[] = [];
  for (const line of toml.split('\n')) {
    const [, key, value] = /^(\w+) = (.*)$/.exec(line) ?? [];
    if (line === header) rows.push(new Map());
    else if (key && value) rows.at(-1)?.set(key, value);
  }
  return rows;
}

const lines = (row: PassRow): string[] => [
  header,
  ...[...row].map(([key, value]) => `${key} = ${value}`),
];
export const tomlOf = (rows: readonly PassRow[]): string => rows.flatMap(lines).join('\n') + '\n';

/** The cell that a line of tomlOf is, from 1. */
export function cellAt(
  rows: readonly PassRow[],
  line: number,
): { row: number; key: string } | undefined {
  let first = 1;
  for (const [row, cells] of rows.entries()) {
    if (line < first + 1 + cells.size) {
      const key = [...cells.keys()][line - first - 1] ?? 'name';
      return { row, key };
    }
    first += 1 + cells.size;
  }
  return undefined;
}

/** A cell as people read it: words without quotation marks. */
export const shown = (value: string | undefined): string => (value ?? '').replace(/^"(.*)"$/, '$1');
/** Shorter, to be read only: "func=Equal, mask=false". */
export const brief = (value: string | undefined): string =>
  (value ?? '').replace(/["{}[\]]/g, '').replaceAll(' = ', '=');
/** Typed text as TOML; text that is no other value is a string. */
export function written(key: string, text: string): string {
  const isOther = key !== 'name' && /^([[{"]|[-+.\d]|true$|false$)/.test(text);
  return isOther ? text : `"${text}"`;
}

/** The row with another value of a key; '' takes the key out. */
export function withCell(row: PassRow, key: string, text: string): PassRow {
  const changed = new Map(row);
  if (text.trim() === '') changed.delete(key);
  else changed.set(key, written(key, text.trim()));
  return changed;
}
