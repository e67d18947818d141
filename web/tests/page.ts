// A page as the command writes it: a built page with data in it.
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

export function pageOf(name: string, data: readonly string[], folder = 'dist'): string {
  const page = readFileSync(`${folder}/${name}.html`, 'utf8');
  const scripts = data.map(
    (text) =>
      `<script class="data" type="text/plain">${gzipSync(text).toString('base64')}</script>`,
  );
  const mark = '<!-- data -->';
  if (!page.includes(mark)) throw new Error(`dist/${name}.html lacks ${mark}; run npm run build`);
  return page.replace(mark, scripts.join(''));
}
