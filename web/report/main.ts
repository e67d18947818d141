// Starts the page with the report in data.js, which calls gw_report; the scripts of histories call
// gw_history.
import { mount } from 'svelte';
import { takeTile } from '../model/pixel_history';
import type { Report } from '../model/report';
import App from './App.svelte';

const target = document.getElementById('app')!;
Object.assign(window, {
  gw_history: takeTile,
  gw_report: (report: Report) => mount(App, { target, props: { report } }),
});
const script = document.createElement('script');
script.src = 'data.js';
script.onerror = () =>
  (target.textContent = 'data.js could not be read; expected it beside this page');
document.head.append(script);
