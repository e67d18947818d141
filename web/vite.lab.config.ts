// Builds the lab as one file: page, worker, WebAssembly and scenes. GW_ENGINE is the folder of
// engine.js and engine.wasm, GW_SCALAR that of the engine without vectors, GW_SCENES the folder of
// the scenes in the project, GW_WEB_OUT that of the page.
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { buildSync } from 'esbuild';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig, type Plugin } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { licences } from './notices';

const engine = process.env.GW_ENGINE ?? '../build/lab/engine';
const scalar = process.env.GW_SCALAR ?? '../build/lab/scalar';
const scenes = process.env.GW_SCENES ?? '../scenes';
const project = resolve(scenes, '..');
const micropython = 'node_modules/@micropython/micropython-webassembly-pyscript';
const packed = (bytes: Uint8Array | string): string =>
  gzipSync(bytes, { level: 9 }).toString('base64');

/** Documents that Help shows. */
const texts = (): string =>
  execFileSync('/usr/bin/python3', [join(project, 'scripts/site'), '--texts'], {
    encoding: 'utf8',
  });

/** What is compiled into the engine, and Emscripten's own. */
const ofEngine = (): string =>
  execFileSync('/usr/bin/python3', [join(project, 'scripts/licences'), '--others', 'emscripten'], {
    encoding: 'utf8',
  });

function sceneFiles(): Record<string, string> {
  const names = readdirSync(scenes, { recursive: true })
    .map(String)
    .filter((name) => /\.(toml|obj|mtl|png)$/.test(name) && !name.includes('prices'))
    .sort();
  return Object.fromEntries(
    names.map((name) => [name, readFileSync(join(scenes, name)).toString('base64')]),
  );
}

const alias = {
  'gw-engine': resolve(engine, 'engine.js'),
  'gw-scalar': resolve(scalar, 'engine.js'),
};

/** Files whose code stands in the page as text of a script. */
const inScripts = new Set<string>();

/** A script as text, in one piece. */
function scriptText(file: string, format: 'iife' | 'esm'): string {
  const built = buildSync({
    entryPoints: [resolve(file)],
    bundle: true,
    write: false,
    metafile: true,
    minify: true,
    format,
    target: 'es2022',
    alias,
    external: ['module', 'url', 'path', 'fs', 'crypto', 'worker_threads'], // of Node, never reached
    define: { 'import.meta.url': '""' }, // of Emscripten's scripts, which get their bytes from the page
  });
  for (const { inputs } of Object.values(built.metafile.outputs))
    for (const [file, { bytesInOutput }] of Object.entries(inputs))
      if (bytesInOutput > 0) inScripts.add(resolve(file));
  return built.outputFiles[0]!.text.replaceAll('</script', '<\\/script').replaceAll(
    '<!--',
    '<\\!--',
  );
}

/**
 * Bytes and scripts stand in the page as text that nobody reads before it is needed. What the first
 * picture needs comes first.
 */
function data(): Plugin {
  const block = (id: string, text: string) =>
    `<script id="${id}" type="text/plain">${text}</script>`;
  return {
    name: 'gw-data',
    transformIndexHtml: (page) =>
      page.replace(
        '<!-- engine -->',
        () =>
          block('worker', scriptText('lab/machine/worker.ts', 'iife')) +
          block('scenes', packed(JSON.stringify(sceneFiles()))) +
          block('engine', packed(readFileSync(join(engine, 'engine.wasm')))) +
          `<script>${scriptText('lab/machine/early.ts', 'iife')}</script>` +
          block('scalar', packed(readFileSync(join(scalar, 'engine.wasm')))) +
          block('editor', scriptText('components/code_editor.ts', 'esm')) +
          block('python', `(async () => {${scriptText('lab/own/python_worker.ts', 'esm')}})()`) +
          block('micropython', packed(readFileSync(join(micropython, 'micropython.wasm')))) +
          block('texts', packed(texts())),
      ),
  };
}

/** What may be wrong with a program, by language. */
function messages(): Record<string, unknown> {
  const folder = join(project, 'hiddensurface/run');
  const files = readdirSync(folder).filter((name) => /^messages\..*\.json$/.test(name));
  return Object.fromEntries(
    files.map((name) => [
      name.split('.')[1],
      JSON.parse(readFileSync(join(folder, name), 'utf8')) as unknown,
    ]),
  );
}

const version = /^project\(gw VERSION ([\d.]+)/m.exec(
  readFileSync(join(project, 'CMakeLists.txt'), 'utf8'),
)![1];

export default defineConfig({
  root: 'lab',
  define: { __GW_VERSION__: JSON.stringify(version), __GW_MESSAGES__: JSON.stringify(messages()) },
  plugins: [
    svelte({ configFile: resolve('svelte.config.js') }),
    data(),
    licences(inScripts, ofEngine()),
    viteSingleFile(),
  ],
  build: {
    outDir: process.env.GW_WEB_OUT ?? '../dist-lab',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 8192,
  },
});
