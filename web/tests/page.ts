// A page as the command writes it: the built player with the logs in it.
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

export function pageOf(logs: readonly string[]): string {
  const page = readFileSync('dist/index.html', 'utf8');
  const scripts = logs.map(
    (log) => `<script class="log" type="text/plain">${gzipSync(log).toString('base64')}</script>`,
  );
  const mark = '<!-- logs -->';
  if (!page.includes(mark)) throw new Error(`dist/index.html lacks ${mark}; run npm run build`);
  return page.replace(mark, scripts.join(''));
}
