// Starts the page with the questions and the logs that stand in it.
import { mount } from 'svelte';
import { takeData, unpacked } from '../model/packed';
import { readQuestions } from '../model/quiz';
import App from './App.svelte';

async function start(): Promise<void> {
  const [first, ...logs] = takeData();
  if (first === undefined) throw new Error('no questions; expected a page that gw quiz wrote');
  const questions = readQuestions(await unpacked(first));
  mount(App, { target: document.getElementById('app')!, props: { questions, logs } });
}

start().catch((error: unknown) => {
  document.getElementById('app')!.textContent = String(error);
});
