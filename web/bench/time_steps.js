// How long a player takes from a click to the picture: for each page the steps it holds, and the
// median and longest time of one step on and of a jump to any step, with the wait for the screen;
// then the same in processor time of the page's thread, which other work does not lengthen.
// scripts/time-player calls it.
import { statSync } from 'node:fs';
import { resolve } from 'node:path';
import puppeteer from 'puppeteer-core';

const clicks = 60;

/** In the page: the milliseconds until the frame after the event is drawn. */
function timeOf(name, step) {
  const slider = document.querySelector('input[type=range]');
  return new Promise((done) => {
    const begun = performance.now();
    if (name === 'step') document.querySelectorAll('.bar button')[4].click();
    else {
      slider.value = String(step);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    }
    requestAnimationFrame(() => {
      const drawn = new MessageChannel();
      drawn.port1.onmessage = () => done(performance.now() - begun);
      drawn.port2.postMessage(0);
    });
  });
}

/** Milliseconds of the page's thread so far. */
async function worked(client) {
  const { metrics } = await client.send('Performance.getMetrics');
  return 1000 * metrics.find((metric) => metric.name === 'TaskDuration').value;
}

function medianAndLongest(times) {
  const sorted = times.sort((a, b) => a - b).map((t) => Math.round(t));
  return [sorted[sorted.length >> 1], sorted.at(-1)];
}

const browser = await puppeteer.launch({
  executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu'],
});
const kinds = ['step', 'jump', 'step_work', 'jump_work'];
console.log(
  ['page steps megabytes', ...kinds.map((kind) => `${kind}_median ${kind}_longest`)].join(' '),
);
for (const file of process.argv.slice(2)) {
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 720 });
  await page.goto(`file://${resolve(file)}`);
  await page.waitForSelector('section');
  const client = await page.createCDPSession();
  await client.send('Performance.enable', { timeDomain: 'threadTicks' });
  const steps = await page.$eval('input[type=range]', (slider) => Number(slider.max));
  const times = Object.fromEntries(kinds.map((kind) => [kind, []]));
  const take = async (name, step) => {
    const before = await worked(client);
    times[name].push(await page.evaluate(timeOf, name, step));
    times[`${name}_work`].push((await worked(client)) - before);
  };
  await page.evaluate(timeOf, 'jump', steps); // keeps what the views need of all steps
  let seed = 1;
  for (let i = 0; i < clicks; ++i) {
    seed = (seed * 16807) % 2147483647;
    await take('jump', seed % steps);
    await take('step');
  }
  const megabytes = (statSync(file).size / 1e6).toFixed(1);
  console.log(
    [file, steps, megabytes, ...kinds.flatMap((k) => medianAndLongest(times[k]))].join(' '),
  );
  await page.close();
}
await browser.close();
