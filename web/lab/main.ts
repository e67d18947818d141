// Starts the lab: the machine in its worker, with the scenes that stand in the page.
import { mount } from 'svelte';
import App from './App.svelte';
import { engineModule, hasVectors, sceneFiles } from './data';
import { Machine } from './machine';

async function start(): Promise<void> {
  const vectors = hasVectors();
  const [wasm, files] = await Promise.all([engineModule(vectors), sceneFiles()]);
  const [machine, facts] = await Machine.start(wasm, vectors, files);
  // The tests of the same bits ask the machine itself.
  Object.assign(window, { machine, facts });
  mount(App, {
    target: document.getElementById('app')!,
    props: { machine, facts, scenes: Object.keys(files) },
  });
}

start().catch((error: unknown) => {
  document.getElementById('app')!.textContent = String(error);
});
