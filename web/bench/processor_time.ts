// Processor time of a browser's workers, from /proc: other work on the computer changes it little.
import { readdirSync, readFileSync } from 'node:fs';

/** `otherwise`: the process has ended. */
function tried<T>(work: () => T, otherwise: T): T {
  try {
    return work();
  } catch {
    return otherwise;
  }
}
const read = (file: string): string => tried(() => readFileSync(file, 'utf8'), '');
const numbersIn = (folder: string): number[] =>
  tried(() => readdirSync(folder), [])
    .map(Number)
    .filter((number) => Number.isInteger(number));
const parentOf = (process: number): number =>
  Number(read(`/proc/${process}/stat`).split(') ').at(-1)?.split(' ')[1]);

const belongsTo = (browser: number, process: number): boolean =>
  process === browser || (process > 1 && belongsTo(browser, parentOf(process)));

/** Milliseconds so far, of all workers of the process and its descendants. */
export function workerTime(browser: number): number {
  let nanoseconds = 0;
  for (const process of numbersIn('/proc').filter((process) => belongsTo(browser, process)))
    for (const thread of numbersIn(`/proc/${process}/task`)) {
      const folder = `/proc/${process}/task/${thread}`;
      if (read(`${folder}/comm`).startsWith('DedicatedWorker'))
        nanoseconds += Number(read(`${folder}/schedstat`).split(' ')[0]);
    }
  return nanoseconds / 1e6;
}
