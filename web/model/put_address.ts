// Puts a page's state into its address. A change costs the browser up to 10 ms, and it refuses more
// than 200 in ten seconds. So changes wait, longer the longer they go on; the last one is always
// put.
const [least, most] = [60, 240]; // milliseconds
let interval = least;
let last = -Infinity;
let waiting: string | undefined;

function put(address: string): void {
  const now = performance.now();
  interval = now - last < 2 * interval ? Math.min(most, 1.2 * interval) : least;
  last = now;
  if (address !== location.hash) history.replaceState(null, '', address);
}

/** The state until now stays behind: Back returns to it. */
export function leaveAddress(): void {
  history.pushState(null, '', location.href);
}

export function putAddress(address: string): void {
  const isQueued = waiting !== undefined;
  const wait = last + interval - performance.now();
  if (!isQueued && wait <= 0) return put(address);
  waiting = address;
  if (isQueued) return;
  setTimeout(() => {
    put(waiting!);
    waiting = undefined;
  }, wait);
}
