// The exhibit of own algorithms: programs that are right, wrong, broken, or endless.
import { expect, it } from 'vitest';
import { packedText } from '../../model/packed';
import { inChromium, open, thePage } from './page';

inChromium();
const page = '#lang=en&exhibit=own&size=160x120&scene=hidden/cycle.toml';
const begin = (code: string) => open(`${page}&code=${packedText(code)}`);
const beginPython = (code: string) => open(`${page}&language=python&code=${packedText(code)}`);
const grade = async () => {
  await thePage().waitForSelector('.grade');
  return thePage().$eval('.grade', (e) => e.textContent ?? '');
};
const complaint = async () => {
  await thePage().waitForSelector('[role=alert]');
  return thePage().$eval('[role=alert]', (e) => e.textContent ?? '');
};

it('grades the examples', async () => {
  await open(page);
  expect(await grade()).not.toContain('Wrong pixels: 0 of');
  await thePage().select('select.example', 'z-buffer');
  await thePage().click('button.run');
  await thePage().waitForSelector('.grade.right');
  expect(await grade()).toBe('Wrong pixels: 0 of 19200');
});

it('runs what is typed', async () => {
  await begin('step({ kind: "draw", pieces: ["1"] });\n');
  const before = await grade();
  await thePage().click('.cm-content');
  await thePage().keyboard.type('step({ kind: "draw", pieces: ["2"] });');
  await thePage().click('button.run');
  await thePage().waitForFunction(
    (before) => document.querySelector('.grade')?.textContent !== before,
    {},
    before,
  );
  await thePage().waitForFunction(() => location.hash.includes('code='));
});

it('marks the line of an error', async () => {
  await begin('const a = 1;\nnothing.here();\n');
  expect(await complaint()).toContain('line 2: ReferenceError');
  expect(await thePage().$eval('.wrong-line', (e) => e.textContent)).toBe('nothing.here();');
});

it('marks the line of a mistake in the syntax', async () => {
  await begin('const a = 1;\nlet let = ;\n');
  expect(await complaint()).toContain('line 2: SyntaxError');
});

it('names the step that the machine refuses', async () => {
  await begin('step({ kind: "draw", pieces: ["99"] });\n');
  expect(await complaint()).toContain("step:1: unknown polygon '99'");
});

it.each([
  [
    'step({ kind: "draw", pieces: ["99"] });',
    "1 番目のステップ：知らないポリゴン '99' です。必要なもの：シーンのポリゴンかその部分",
  ],
  ['while (true) {}', '5 秒たっても終わりません'],
  ['\nnothing.here();', "2 行目：名前の誤りです（ReferenceError）：'nothing' は定義されていません"],
  ['throw new Error("my own words");', '1 行目：エラーです（Error）：my own words'],
])('tells in Japanese what is wrong with %s', async (code, expected) => {
  await open(`${page.replace('lang=en', 'lang=ja')}&code=${packedText(code)}`);
  expect(await complaint()).toBe(expected);
});

it('tells in Japanese what is wrong with a program in Python', async () => {
  const code = packedText('\nnothing.here()\n');
  await open(`${page.replace('lang=en', 'lang=ja')}&language=python&code=${code}`);
  expect(await complaint()).toBe(
    "2 行目：名前の誤りです（NameError）：'nothing' は定義されていません",
  );
});

it('ends a program that loops, and goes on', async () => {
  await begin('while (true) {}\n');
  expect(await complaint()).toContain('no end after 5 s');
  await thePage().select('select.example', 'painter');
  await thePage().click('button.run');
  await grade();
});

it('grades the same programs in Python', async () => {
  await open(page);
  const painted = await grade();
  await thePage().select('select.language', 'python');
  await thePage().waitForFunction(() => location.hash.includes('language=python'));
  expect(await thePage().$eval('.cm-content', (e) => e.textContent)).toContain(
    'def depth(polygon)',
  );
  await thePage().click('button.run');
  await grade();
  expect(await grade()).toBe(painted);
  await thePage().select('select.example', 'z-buffer');
  await thePage().click('button.run');
  await thePage().waitForSelector('.grade.right');
  expect(await grade()).toBe('Wrong pixels: 0 of 19200');
});

it('marks the line of an error in Python', async () => {
  await beginPython('def f():\n    return nothing\n\nf()\n');
  expect(await complaint()).toContain("line 2: NameError: name 'nothing' isn't defined");
  await thePage().waitForSelector('.wrong-line');
  expect(await thePage().$eval('.wrong-line', (e) => e.textContent)).toBe('    return nothing');
});

it('marks the line of a mistake in the syntax of Python', async () => {
  await beginPython('a = 1\nlet let = ;\n');
  expect(await complaint()).toContain('line 2: SyntaxError');
});

it('ends a program in Python that loops', async () => {
  await beginPython('while True:\n    pass\n');
  expect(await complaint()).toContain('no end after 5 s');
});

it('keeps a program in Python from the network', async () => {
  await beginPython('import js\njs.fetch("https://example.org")\n');
  expect(await complaint()).toContain('line 2: ');
});

it('names the step of a program in Python that the machine refuses', async () => {
  await beginPython('step(kind="draw", pieces=["99"])\n');
  expect(await complaint()).toContain("step:1: unknown polygon '99'");
});

it('takes a dictionary as a step of Python', async () => {
  await beginPython('step({"kind": "draw"}, pieces=["98"])\n');
  expect(await complaint()).toContain("step:1: unknown polygon '98'");
});

it('says that a program runs, stops it, and marks what is left as old', async () => {
  await open(page);
  await grade();
  await thePage().waitForSelector('.blame');
  await thePage().click('.cm-content');
  await thePage().keyboard.type('while (true);');
  await thePage().waitForSelector('button.stop');
  expect(await thePage().$('.grade')).toBeNull();
  expect(await thePage().$('.blame')).toBeNull();
  await thePage().click('button.stop');
  expect(await complaint()).toBe('Stopped.');
  expect(await thePage().$('button.stop')).toBeNull();
  await thePage().waitForSelector('.old canvas');
});

it('ends the run before when another one begins', async () => {
  await begin('while (true) {}\n');
  await thePage().waitForSelector('button.stop');
  await thePage().select('select.example', 'z-buffer');
  await thePage().click('button.run');
  await thePage().waitForSelector('.grade.right', { timeout: 3_000 }); // its own end is after 5 s
  expect(await thePage().$('.old')).toBeNull();
});

it.each([
  [1280, 720],
  [1920, 1080],
])('shows program, picture and controls together at %i x %i', async (width, height) => {
  await open('#lang=en&exhibit=own', width, height);
  await thePage().waitForSelector('.blame');
  await thePage().waitForFunction(
    () => document.querySelector('.bar')!.getBoundingClientRect().bottom <= innerHeight,
  );
  const eye = (await (await thePage().$('.stack'))!.boundingBox())!;
  const second = (await (await thePage().$('.second'))!.boundingBox())!;
  expect(eye.width).toBeGreaterThan(0.28 * width);
  const blame = (await (await thePage().$('.blame button'))!.boundingBox())!;
  expect(blame.y + blame.height).toBeLessThan(height);
  expect(second.width).toBeLessThan(1.5 * eye.width);
});

it('has no raw signs in its words', async () => {
  await open(page);
  await grade();
  const words = await thePage().$eval('main', (e) => e.textContent!);
  expect(words).not.toMatch(/`scene|played/);
  expect(await thePage().$$eval('.look code', (all) => all.map((e) => e.textContent))).toEqual([
    'scene',
    'step(...)',
  ]);
});
