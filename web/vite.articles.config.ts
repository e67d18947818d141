// Builds the articles as one file, with the logs of their runs and the pictures of their films.
// GW is the command that makes them, GW_SCENES the folder of the scenes, GW_WEB_OUT that of the
// page.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig, type Plugin } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { argumentsOf, runs } from './articles/figures';
import { films } from './articles/films';
import { makeFilm } from './articles/make_film';
import { licences } from './notices';

const gw = resolve(process.env.GW ?? '../build/release/bin/gw');
const scenes = resolve(process.env.GW_SCENES ?? '../scenes');

function scriptsOfFilms(): string {
  return Object.entries(films)
    .map(([name, figure]) => {
      const film = JSON.stringify(makeFilm(figure, gw, scenes));
      return `<script id="film-${name}" type="application/json">${film}</script>`;
    })
    .join('');
}

function scriptsOfLogs(): string {
  const folder = mkdtempSync(join(tmpdir(), 'gw-articles-'));
  const scripts = Object.entries(runs).map(([name, run]) => {
    execFileSync(gw, argumentsOf(run, scenes, folder), { stdio: ['ignore', 'ignore', 'inherit'] });
    const log = gzipSync(readFileSync(join(folder, 'steps.jsonl')), { level: 9 });
    return `<script id="log-${name}" type="text/plain">${log.toString('base64')}</script>`;
  });
  rmSync(folder, { recursive: true });
  return scripts.join('');
}

const logs: Plugin = {
  name: 'gw-logs',
  transformIndexHtml: (page) =>
    page.replace('<!-- logs -->', () => scriptsOfLogs() + scriptsOfFilms()),
};

export default defineConfig({
  root: 'articles',
  plugins: [
    svelte({ configFile: resolve('svelte.config.js') }),
    licences(),
    viteSingleFile(),
    logs,
  ],
  build: {
    outDir: resolve(process.env.GW_WEB_OUT ?? 'dist/articles'),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: false,
  },
});
