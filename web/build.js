// Builds pages, each as one file without references, so that it opens from disk: node build.js
// player compare writes dist/player.html and dist/compare.html.
import { renameSync, rmSync } from 'node:fs';
import { resolve } from 'node:path';
import { build } from 'vite';

for (const page of process.argv.slice(2)) {
  const outDir = resolve('dist', page);
  const configFile = resolve('vite.config.ts');
  await build({ root: page, configFile, build: { outDir, emptyOutDir: true }, logLevel: 'error' });
  renameSync(`${outDir}/index.html`, `${outDir}.html`);
  rmSync(outDir, { recursive: true });
}
