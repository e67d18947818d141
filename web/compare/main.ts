// Starts the page with the comparison that stands in it.
import { mount } from 'svelte';
import type { Comparison } from '../model/comparison';
import { takeData, unpacked } from '../model/packed';
import App from './App.svelte';

async function start(): Promise<void> {
  const [data] = takeData();
  if (data === undefined)
    throw new Error('no comparison in this page; gw hidden --compare writes it');
  const comparison = JSON.parse(await unpacked(data)) as Comparison;
  mount(App, { target: document.getElementById('app')!, props: { comparison } });
}

start().catch((error: unknown) => {
  document.getElementById('app')!.textContent = String(error);
});
