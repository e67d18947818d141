// No page of the site has barriers that axe-core finds: every document, the lists of folders.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { barriersOf } from '../barriers';
import { describePages } from './browser';

const scenes = process.env['GW_SCENES'] ?? '';
const python = '/usr/bin/python3'; // Debian's has markdown-it
const hasParser = spawnSync(python, ['-c', 'import markdown_it']).status === 0;

describePages('axe-core finds nothing', (pages) => {
  it.skipIf(scenes === '' || !hasParser)(
    'in the pages of the site',
    async () => {
      const site = join(pages.folder, 'site');
      const given = ['lab.html', 'articles.html'].map((name) => join(pages.folder, name));
      for (const file of given) writeFileSync(file, '<title>GW</title>');
      const programs = join(pages.folder, 'programs');
      mkdirSync(programs);
      for (const name of ['hidden', 'flight']) writeFileSync(join(programs, `${name}.html`), '');
      execFileSync(python, [join(scenes, '../scripts/site'), site, ...given, programs], {
        stdio: 'ignore',
      });
      const found: Record<string, string[]> = {};
      for (const file of readdirSync(site, { recursive: true }).map(String).sort()) {
        if (!file.endsWith('.html') || /^(lab|articles|programs.*)\.html$/.test(file)) continue;
        await pages.openFile(join(site, file));
        const barriers = await barriersOf(pages.page);
        if (barriers.length > 0) found[file] = barriers;
      }
      expect(found).toEqual({});
    },
    600_000,
  );
});
