// The exhibit of own algorithms: programs that are right, wrong, broken, or endless.
import { expect, it } from 'vitest';
import { packedText } from '../../model/packed_text';
import { inChromium, open, thePage } from './page';

inChromium();
const begin = (code: string, scene = 'hidden/cycle.toml') =>
  open(`#lang=en&exhibit=own&size=160x120&scene=${scene}&code=${packedText(code)}`);
const grade = async () => {
  await thePage().waitForSelector('.grade');
  return thePage().$eval('.grade', (e) => e.textContent ?? '');
};
const complaint = async () => {
  await thePage().waitForSelector('[role=alert]');
  return thePage().$eval('[role=alert]', (e) => e.textContent ?? '');
};

it('grades the examples', async () => {
  await open('#lang=en&exhibit=own&size=160x120&scene=hidden/cycle.toml');
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

it('ends a program that loops, and goes on', async () => {
  await begin('while (true) {}\n');
  expect(await complaint()).toContain('no end after 5 s');
  await thePage().select('select.example', 'painter');
  await thePage().click('button.run');
  await grade();
});
