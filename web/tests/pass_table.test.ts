import { expect, it } from 'vitest';
import { brief, cellAt, rowsFrom, shown, tomlOf, withCell } from '../model/pass_table';

const toml = `[[pass]]
name = "depth"
clear = ["color", "depth"]
depth = {func = "less", mask = true}

[[pass]]
name = "diffuse"
Kd = "object"
Ks = 0
`;

it('reads rows and writes them again', () => {
  const rows = rowsFrom(toml);
  expect(rows.map((row) => shown(row.get('name')))).toEqual(['depth', 'diffuse']);
  expect(rows[0]!.get('depth')).toBe('{func = "less", mask = true}');
  expect(rowsFrom(tomlOf(rows))).toEqual(rows);
});

it('shortens what is only read', () => {
  const [row] = rowsFrom(toml);
  const texts = ['name', 'clear', 'depth', 'Ka'].map((key) => brief(row!.get(key)));
  expect(texts).toEqual(['depth', 'color, depth', 'func=less, mask=true', '']);
});

it('finds the cell of a line', () => {
  const rows = rowsFrom(toml);
  const lines = tomlOf(rows).split('\n');
  expect(lines[6]).toBe('Kd = "object"');
  expect(cellAt(rows, 7)).toEqual({ row: 1, key: 'Kd' });
  expect(cellAt(rows, 5)).toEqual({ row: 1, key: 'name' });
  expect(cellAt(rows, 99)).toBeUndefined();
});

it('writes what is typed as TOML', () => {
  const [row] = rowsFrom(toml);
  expect(withCell(row!, 'Kd', 'object').get('Kd')).toBe('"object"');
  expect(withCell(row!, 'Kd', '0.5').get('Kd')).toBe('0.5');
  expect(withCell(row!, 'Kd', '[1, 0, 0]').get('Kd')).toBe('[1, 0, 0]');
  expect(withCell(row!, 'color', 'false').get('color')).toBe('false');
  expect(withCell(row!, 'name', '1').get('name')).toBe('"1"');
  expect(withCell(row!, 'clear', '').has('clear')).toBe(false);
});
