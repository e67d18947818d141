// Starts the page with the logs that stand in it. Without any, the page asks for a file.
import { mount } from 'svelte';
import { readLog, type Log } from '../model/steps/log';
import { takeData, unpackedPieces } from '../model/packed';
import App from './App.svelte';

async function start(): Promise<void> {
  const logs: Log[] = [];
  for (const data of takeData()) logs.push(await readLog(unpackedPieces(data)));
  mount(App, { target: document.getElementById('app')!, props: { logs } });
}

start().catch((error: unknown) => {
  document.getElementById('app')!.textContent = String(error);
});
