// Programs in C on pages of their own: the bits of this computer's library; keys, mouse, menus.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { inChromium, thePage } from './page';

const pages = process.env['GW_PROGRAMS'] ?? '../build/lab/programs';
const gw = process.env['GW'] ?? '../build/release/bin/gw';
const examples = process.env['GW_EXAMPLES'] ?? '../examples/irisgl';

inChromium();

const show = (name: string, variables = '') =>
  thePage().goto(`file://${pages}/${name}.html${variables}`);
const end = () => thePage().waitForSelector('body[data-status="0"]');

/** What the program on the page wrote. */
const fileOfPage = async (name: string) =>
  Buffer.from(
    await thePage().evaluate(
      (name) =>
        Array.from(
          (window as unknown as { FS: { readFile(name: string): Uint8Array } }).FS.readFile(name),
        ),
      name,
    ),
  );

/** The picture of the last frame, as the library writes it. */
function pictureHere(name: string, frames: string): Buffer {
  const folder = mkdtempSync(join(tmpdir(), 'programs-'));
  const options = (which: string) =>
    execFileSync(gw, ['irisgl-config', which]).toString().trim().split(' ');
  const program = join(folder, name);
  execFileSync('cc', [
    ...options('--cflags'),
    join(examples, `${name}.c`),
    ...options('--libs'),
    '-lm',
    '-o',
    program,
  ]);
  const picture = join(folder, 'picture.ppm');
  const environment: NodeJS.ProcessEnv = {
    ...process.env,
    GW_FRAMES: frames,
    GW_SCREENSHOT: picture,
  };
  delete environment['DISPLAY'];
  execFileSync(program, { env: environment });
  return readFileSync(picture);
}

it.each(['hidden', 'flight'])('draws %s with the bits of the library', async (name) => {
  const frames = '0-3';
  await show(name, `?GW_FRAMES=${frames}&GW_SCREENSHOT=picture.ppm`);
  await end();
  const bytes = await fileOfPage('picture.ppm');
  expect(bytes.equals(pictureHere(name, frames))).toBe(true);
});

it('leaves a recording that the command reads', async () => {
  await show('hidden', '?GW_FRAMES=0-1&GW_RECORD=hidden.gwt');
  await end();
  const bytes = await fileOfPage('hidden.gwt');
  const recording = join(mkdtempSync(join(tmpdir(), 'programs-')), 'hidden.gwt');
  writeFileSync(recording, bytes);
  expect(execFileSync(gw, ['replay', recording]).toString()).toContain('480 x 480 pixels');
});

/** Waits for other words below the things than these; returns them. */
async function nextLabel(old: string): Promise<string> {
  const label = await thePage().waitForFunction(
    (old) => {
      const picture = document.querySelector('canvas')?.getContext('2d');
      const data = picture?.getImageData(0, 420, 200, 30).data;
      const text = data?.join();
      return text !== old && data?.some((each, i) => i % 4 < 3 && each === 255) && text;
    },
    {},
    old,
  );
  return (await label.jsonValue()) as string;
}

it('takes keys', async () => {
  await show('hidden');
  const byDepth = await nextLabel('');
  await thePage().keyboard.press('2');
  const byOrder = await nextLabel(byDepth);
  await thePage().keyboard.press('1');
  expect(await nextLabel(byOrder)).toBe(byDepth);
  await thePage().keyboard.press('Escape');
  await end();
});

it('shows a menu while its button is down, and does what it says', async () => {
  await show('hidden');
  await thePage().waitForSelector('canvas');
  const box = (await (await thePage().$('canvas'))!.boundingBox())!;
  await thePage().mouse.move(box.x + 200, box.y + 100);
  await thePage().mouse.down({ button: 'right' });
  const lastRow = () =>
    thePage().waitForFunction(() => {
      const canvas = document.querySelector('canvas')!;
      const { data, width, height } = canvas.getContext('2d')!.getImageData(0, 0, 480, 480);
      for (let y = height - 1; y >= 0; --y) {
        let grey = 0;
        let at = 0;
        for (let x = 0; x < width; ++x) {
          const i = 4 * (y * width + x);
          if (data[i] === 170 && data[i + 1] === 170 && data[i + 2] === 170)
            [grey, at] = [grey + 1, x];
        }
        if (grey > 40) return { x: at - 20, y: y - 6 };
      }
      return undefined;
    });
  const quit = (await (await lastRow()).jsonValue())!;
  await thePage().mouse.move(box.x + quit.x, box.y + quit.y);
  await thePage().mouse.up({ button: 'right' });
  await end();
});

it('ends when its window is closed', async () => {
  await show('flight');
  await thePage().waitForSelector('figcaption button');
  await thePage().click('figcaption button');
  await end();
});

it('shows the pictures that a program of OSMesa writes', async () => {
  await show('osmesa');
  await end();
  const [width, pixel] = await thePage().$eval('figure canvas', (element) => {
    const canvas = element as HTMLCanvasElement;
    return [canvas.width, [...canvas.getContext('2d')!.getImageData(16, 16, 1, 1).data]] as const;
  });
  expect(width).toBe(32);
  expect(pixel).toEqual([255, 128, 0, 255]);
});
