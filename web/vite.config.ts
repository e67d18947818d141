// Builds the player as one file without references: it opens from disk. GW_WEB_OUT names the folder.
import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

export default defineConfig({
  root: 'player',
  plugins: [svelte(), viteSingleFile()],
  build: {
    outDir: process.env.GW_WEB_OUT ?? '../dist',
    emptyOutDir: true,
    target: 'es2022',
  },
});
