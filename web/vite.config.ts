// How each page is built: as one file without references. build.js names the pages.
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { licences } from './notices';

export default defineConfig({
  plugins: [svelte({ configFile: resolve('svelte.config.js') }), licences(), viteSingleFile()],
  build: { target: 'es2022', modulePreload: false },
});
