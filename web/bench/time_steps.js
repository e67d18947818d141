// How long a player takes from a click to the picture: for each page the steps it holds, and the
// median and longest time of one step on and of a jump to any step, with the wait for the screen.
// scripts/time-player calls it.
import { statSync } from 'node:fs';
import { resolve } from 'node:path';
import puppeteer from 'puppeteer-core';

const browser = await puppeteer.launch({
  executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu'],
});
console.log('page steps megabytes step_median step_longest jump_median jump_longest');
for (const file of process.argv.slice(2)) {
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 720 });
  await page.goto(`file://${resolve(file)}`);
  await page.waitForSelector('section');
  const found = await page.evaluate(async () => {
    const slider = document.querySelector('input[type=range]');
    const forward = document.querySelectorAll('.bar button')[4];
    /** Until the frame after the event is drawn. */
    const timeOf = (act) =>
      new Promise((done) => {
        const begun = performance.now();
        act();
        requestAnimationFrame(() => {
          const drawn = new MessageChannel();
          drawn.port1.onmessage = () => done(performance.now() - begun);
          drawn.port2.postMessage(0);
        });
      });
    const goTo = (step) => () => {
      slider.value = String(step);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    };
    const steps = Number(slider.max);
    const all = { step: [], jump: [] };
    await timeOf(goTo(steps)); // keeps what the views need of all steps
    let seed = 1;
    for (let i = 0; i < 60; ++i) {
      seed = (seed * 16807) % 2147483647;
      all.jump.push(await timeOf(goTo(seed % steps)));
      all.step.push(await timeOf(() => forward.click()));
    }
    const sorted = (times) => times.sort((a, b) => a - b).map((t) => Math.round(t));
    const of = (times) => [sorted(times)[30], sorted(times)[59]];
    return [steps, ...of(all.step), ...of(all.jump)];
  });
  const megabytes = (statSync(file).size / 1e6).toFixed(1);
  console.log([file, found[0], megabytes, ...found.slice(1)].join(' '));
  await page.close();
}
await browser.close();
