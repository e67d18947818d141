// The sweeps of passes against rays [K4f] as a hand uses them: their estimates are those of gw
// study passes, and a scene without such a sweep says so. Needs GW, the command.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';
import { inChromium, open, thePage } from './page';

const gw = process.env['GW'] ?? '../build/release/bin/gw';
const scenes = process.env['GW_SCENES'] ?? '../scenes';
const folder = mkdtempSync(join(tmpdir(), 'gw-lab-sweep-'));
afterAll(() => rmSync(folder, { recursive: true }));
inChromium();

const begin = (rest: string) => open(`#lang=en&exhibit=rays&size=64x48&depth=2&open=sweep&${rest}`);
const cells = () =>
  thePage().$$eval('details.sweep tbody tr', (rows) =>
    rows.map((row) => Array.from(row.querySelectorAll('th, td'), (e) => e.textContent!.trim())),
  );
const short = (value: number) => value.toLocaleString('en', { maximumSignificantDigits: 3 });

it('has the estimates of gw study passes', async () => {
  const values = [1, 2, 3, 4, 6, 8];
  execFileSync(gw, [
    ...['study', 'passes', `${scenes}/fig9.toml`, '--sweep', `depth=${values.join(',')}`],
    ...['--size', '64x48', '--runs', '0', '-o', folder, '--quiet'],
  ]);
  const { rows } = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8')) as {
    rows: {
      sweep: string;
      value: number;
      estimated: Record<string, Record<'seconds' | 'gain', [number, number, number]>>;
    }[];
  };
  const expected = (list: string) =>
    values.map((value) => {
      const of = rows
        .filter((row) => row.sweep === 'depth' && row.value === value)
        .map((row) => row.estimated[list]!);
      const [low, gain, high] = of[0]!.gain;
      return [
        String(value),
        ...of.map(({ seconds }) => `${short(seconds[1])} s`),
        `${short(gain)} (${short(low)} – ${short(high)})`,
      ];
    });
  await begin('scene=fig9.toml&sweep=depth');
  await thePage().waitForSelector('details.sweep button.measure');
  await thePage().click('details.sweep button.measure');
  await thePage().waitForFunction(
    (rows) => document.querySelectorAll('details.sweep tbody tr').length === rows,
    { timeout: 120_000 },
    values.length,
  );
  const withoutShare = (rows: string[][]) => rows.map(([x, , ...rest]) => [x, ...rest]);
  expect(withoutShare(await cells())).toEqual(expected('vgx'));
  await thePage().select('details.sweep select.prices', 'modern_gpu');
  expect(withoutShare(await cells())).toEqual(expected('modern_gpu'));
  await thePage().select('details.sweep select.prices', 'here');
  for (const row of await cells())
    expect(row.slice(2, 6).every((s) => parseFloat(s) > 0)).toBe(true);
  expect(await thePage().$$eval('details.sweep svg circle', (all) => all.length)).toBe(
    4 * values.length,
  );
}, 180_000);

it('says that a scene has no such sweep', async () => {
  await begin('scene=hidden/five.toml&sweep=depth');
  await thePage().waitForFunction(() =>
    document
      .querySelector('details.sweep [role=status]')
      ?.textContent?.includes('nothing in the scene reflects by rays'),
  );
  expect(await thePage().$('details.sweep button.measure')).toBeNull();
});
