// Starts the page. The logs of its runs and its films stand in it, each in a script of its own, and
// are unpacked when an article needs them.
import { mount } from 'svelte';
import '../model/learning_platform';
import { unpackedPieces } from '../model/packed';
import { readLog, type Log } from '../model/steps/log';
import App from './App.svelte';
import type { Film } from './film';

const logs = new Map<string, Promise<Log>>();
function logOf(figure: string): Promise<Log> | undefined {
  const data = document.getElementById(`log-${figure}`)?.textContent;
  if (data && !logs.has(figure)) logs.set(figure, readLog(unpackedPieces(data)));
  return logs.get(figure);
}

function filmOf(figure: string): Film | undefined {
  const data = document.getElementById(`film-${figure}`)?.textContent;
  return data ? (JSON.parse(data) as Film) : undefined;
}

mount(App, {
  target: document.getElementById('app')!,
  props: { logOf, filmOf },
});
