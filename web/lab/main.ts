// Starts the lab. The machine has begun in its worker; the page asks it for the first picture.
import { mount } from 'svelte';
import '../model/learning_platform';
import App from './App.svelte';
import { beginWorker } from './machine/begin_worker';
import { Machine } from './machine/machine';

const machine = new Machine(window.begun ?? beginWorker());
const target = document.getElementById('app')!;
// The tests of the same bits ask the machine itself.
Object.assign(window, { machine });
machine.started.then(
  (facts) => Object.assign(window, { facts }),
  (error: unknown) => {
    target.textContent = String(error);
  },
);
mount(App, { target, props: { machine } });
