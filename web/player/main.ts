// Starts the page with the logs that stand in it: <script class="log"> with base64 of gzip of the
// lines of JSON. Without any, the page asks for a file.
import { mount } from 'svelte';
import { parseLog, type Log } from '../model/log';
import App from './App.svelte';

async function unpack(base64: string): Promise<string> {
  const bytes = Uint8Array.from(atob(base64.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).text();
}

async function start(): Promise<void> {
  const elements = [...document.querySelectorAll('script.log')];
  const logs: Log[] = [];
  for (const element of elements) logs.push(parseLog(await unpack(element.textContent ?? '')));
  document.title =
    logs.map((log) => `${log.header.title}, ${log.header.scene}`).join(' – ') || 'gw hidden';
  mount(App, { target: document.getElementById('app')!, props: { logs } });
}

start().catch((error: unknown) => {
  document.getElementById('app')!.textContent = String(error);
});
