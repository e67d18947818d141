// Starts the machine in its worker while the browser still reads the page. vite.lab.config.ts puts
// it behind the engine with vectors and the scenes.
import { hasVectors } from './data';
import { beginWorker } from './begin_worker';

if (hasVectors()) window.begun = beginWorker();
