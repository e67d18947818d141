// Runs while the browser still reads the page, before its large script: the machine begins in its
// worker meanwhile. vite.lab.config.ts puts it behind the engine with vectors and the scenes.
import { hasVectors } from './data';
import { beginWorker } from './begin_worker';

if (hasVectors()) window.begun = beginWorker();
