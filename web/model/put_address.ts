// Puts a page's state into its address. Browsers refuse more than 200 changes in ten seconds, and a
// log that is played makes 60 in one. So changes wait for their turn; the last always gets it.
const interval = 60;
let last = -Infinity;
let waiting: string | undefined;

function put(address: string): void {
  last = performance.now();
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
