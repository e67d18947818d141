// What a program of the visitor may not do, in any language.
export const mostSteps = 200_000;

/** Names of a worker that reach the network. */
export const network: readonly string[] = [
  'fetch',
  'XMLHttpRequest',
  'WebSocket',
  'EventSource',
  'importScripts',
];
