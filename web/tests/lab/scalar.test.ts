// A browser without WebAssembly's vectors gets the other engine, with the same bits.
import { expect, it } from 'vitest';
import { inChromium, open, thePage, type LabWindow } from './page';

inChromium();

const drawn = () =>
  thePage().evaluate(async () => {
    const { machine, facts } = window as unknown as LabWindow;
    const view = { width: 64, height: 48, profile: 'vgx' };
    await machine.ask('open', '/scenes/fig9.toml');
    const { text } = await machine.ask('manifest', { ...view, renderer: 'multipass' });
    await machine.ask('open', '/scenes/hidden/cycle.toml');
    const hidden = { ...view, algorithm: 'newell', level: 'polygon' };
    const log = (await machine.ask('hidden', hidden)).text;
    return { simd: facts.simd, manifest: text, log };
  });

it('draws the same without vectors', async () => {
  await open('#lang=en&size=64x48');
  await thePage().waitForSelector('canvas');
  const withVectors = await drawn();
  expect(withVectors.simd).toBe('WASM');
  await thePage().evaluateOnNewDocument(() => {
    WebAssembly.validate = () => false;
  });
  await thePage().reload();
  await thePage().waitForSelector('canvas');
  const without = await drawn();
  expect(without.simd).not.toBe('WASM');
  expect(without.manifest).toBe(withVectors.manifest);
  expect(without.log).toBe(withVectors.log);
});
