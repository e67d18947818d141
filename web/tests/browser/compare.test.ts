// The page of a comparison in a real browser.
import { expect, it } from 'vitest';
import { comparison } from '../samples/comparison';
import { describePages } from './browser';

describePages('the comparison', (pages) => {
  const open = (hash = '') => pages.open('compare', [JSON.stringify(comparison)], hash);
  const names = () => pages.textsOf('tbody .name');

  it('begins with a few algorithms, the Z-buffer among them', async () => {
    await open('#lang=en');
    expect(await pages.textsOf('figcaption b')).toEqual(['painter', 'z-buffer', 'newell']);
    expect(await pages.textOf('h1')).toBe('Algorithms compared: sample <b>scene</b>');
    expect(await pages.colorAt(2, 0, 1)).toEqual([0, 0, 255, 255]);
    expect(await pages.colorAt(3, 0, 0)).toEqual([255, 0, 0, 255]);
  });

  it('sorts the table by any counter, and back', async () => {
    await open('#lang=en');
    await (await pages.page.$('thead ::-p-text(keys)'))!.click();
    expect(await names()).toEqual(['painter', 'newell', 'z-buffer']);
    await (await pages.page.$('thead ::-p-text(keys)'))!.click();
    expect(await names()).toEqual(['z-buffer', 'newell', 'painter']);
    expect(await pages.hash()).toContain('sort=keys');
    expect(await pages.textsOf('tbody tr:first-child td')).toEqual(['0', '2', '0']);
  });

  it('shows what is ticked, by itself if enlarged', async () => {
    await open('#lang=en&show=newell');
    await pages.page.click('tbody tr:first-child input');
    expect(await pages.textsOf('figcaption b')).toEqual(['painter', 'newell']);
    await (await pages.page.$('figcaption ::-p-text(Larger)'))!.click();
    expect(await pages.textsOf('figcaption b')).toEqual(['painter']);
    await pages.page.keyboard.press('ArrowRight');
    expect(await pages.textsOf('figcaption b')).toEqual(['z-buffer']);
    await pages.page.keyboard.press('Escape');
    expect(await pages.textsOf('figcaption b')).toEqual(['painter', 'newell']);
  });

  it('tells of a pixel in all pictures', async () => {
    await open('#lang=en&show=painter,newell&plane=difference');
    const box = (await (await pages.page.$('.stack'))!.boundingBox())!;
    await pages.page.mouse.click(box.x + box.width * (3.5 / 4), box.y + box.height / 4);
    expect(await pages.hash()).toContain('pixel=3,0');
    expect(await pages.textsOf('.under')).toEqual([
      '1 far · wrong · Writes: 2',
      '2 near · Writes: 2',
    ]);
    expect(await pages.colorAt(3, 0, 0)).toEqual([230, 20, 20, 255]);
  });

  it('shows the whole title of each algorithm: some differ only at the end', async () => {
    const title = "Painter's algorithm, sorted by the farthest corner of every polygon";
    const algorithms = comparison.algorithms.map((run) => ({
      ...run,
      title,
      name: `a-${run.name}`,
    }));
    await pages.open('compare', [JSON.stringify({ ...comparison, algorithms })], '#lang=en');
    expect((await pages.textsOf('figcaption .title'))[0]).toBe(title);
    const cut = await pages.page.$$eval('figcaption .title', (all) =>
      all.filter((e) => e.scrollWidth > e.clientWidth).map((e) => e.textContent),
    );
    expect(cut).toEqual([]);
  });

  it('shows all three planes, Japanese, dark, on a projector and a phone', async () => {
    await open('#plane=all&lang=ja&theme=dark&projector=1&show=painter');
    expect(await pages.page.$$('canvas')).toHaveLength(3);
    expect(await pages.textOf('h1')).toContain('アルゴリズムの比較');
    for (const [width, height] of [
      [390, 800],
      [1280, 720],
      [3840, 2160],
    ] as const) {
      await pages.page.setViewport({ width, height });
      expect(await pages.excess()).toBeLessThanOrEqual(0);
    }
  });
});
