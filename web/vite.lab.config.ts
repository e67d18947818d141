// Builds the lab as one file: page, worker, WebAssembly and scenes. GW_ENGINE is the folder of
// engine.js and engine.wasm, GW_SCALAR that of the engine without vectors, GW_SCENES the folder of the scenes, GW_WEB_OUT that of the page.
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig, type Plugin } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

const engine = process.env.GW_ENGINE ?? '../build/lab/engine';
const scalar = process.env.GW_SCALAR ?? '../build/lab/scalar';
const scenes = process.env.GW_SCENES ?? '../scenes';
const packed = (bytes: Uint8Array | string): string =>
  gzipSync(bytes, { level: 9 }).toString('base64');

function sceneFiles(): Record<string, string> {
  const names = readdirSync(scenes, { recursive: true })
    .map(String)
    .filter((name) => /\.(toml|obj|mtl|png)$/.test(name) && !name.includes('prices'))
    .sort();
  return Object.fromEntries(
    names.map((name) => [name, readFileSync(join(scenes, name)).toString('base64')]),
  );
}

/** The bytes stand in the page as text that no script reads before it is needed. */
function data(): Plugin {
  const block = (id: string, text: string) =>
    `<script id="${id}" type="text/plain">${text}</script>`;
  return {
    name: 'gw-data',
    transformIndexHtml: (page) =>
      page.replace(
        '<!-- engine -->',
        block('engine', packed(readFileSync(join(engine, 'engine.wasm')))) +
          block('scalar', packed(readFileSync(join(scalar, 'engine.wasm')))) +
          block('scenes', packed(JSON.stringify(sceneFiles()))),
      ),
  };
}

/** Emscripten's script names a file beside it, which Vite would put into the page again. */
function withoutFile(): Plugin {
  return {
    name: 'gw-engine',
    enforce: 'pre',
    transform: (code, id) =>
      id.endsWith('engine.js')
        ? code.replace('new URL("engine.wasm",import.meta.url).toString()', '""')
        : undefined,
  };
}

const alias = {
  'gw-engine': resolve(engine, 'engine.js'),
  'gw-scalar': resolve(scalar, 'engine.js'),
};

export default defineConfig({
  root: 'lab',
  resolve: { alias },
  plugins: [svelte({ configFile: resolve('svelte.config.js') }), viteSingleFile(), data()],
  worker: { format: 'iife', plugins: () => [withoutFile()] },
  build: {
    outDir: process.env.GW_WEB_OUT ?? '../dist-lab',
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 8192,
  },
});
