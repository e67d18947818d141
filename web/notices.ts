// The licences of the npm packages whose code stands in a page, as the packages have them. A page
// carries them as text, after the project's own; components/texts/Licence.svelte shows it. The
// build fails for a package without one.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

/** GW_SCENES is a folder of the project. */
const project = join(process.env['GW_SCENES'] ?? '../scenes', '..');

/** .../node_modules/NAME, of a file in it: Rollup puts \0 before CommonJS. */
const folderOf = (file: string): string | undefined =>
  /[^\0]*\bnode_modules\/(?:@[^/]+\/)?[^/]+/.exec(file.replaceAll('\\', '/'))?.[0];

/** In its folder, or in notices/ if the package has none. */
function licenceOf(folder: string, name: string): string {
  const given = join('notices', `${name.replace('/', '+')}.txt`);
  const files = [
    ...readdirSync(folder)
      .filter((file) => /^(licen[cs]e|copying|notice)\b/i.test(file))
      .sort()
      .map((file) => join(folder, file)),
    ...(existsSync(given) ? [given] : []),
  ];
  if (files.length === 0) throw new Error(`${name} has no licence; write it to web/${given}`);
  return files.map((file) => readFileSync(file, 'utf8').trim()).join('\n\n');
}

/** "NAME VERSION" and the licence, of each package with a file among these. */
export function noticesOf(files: Iterable<string>): string[] {
  const folders = new Set([...files].flatMap((file) => folderOf(file) ?? []));
  const notices = [...folders].map((folder) => {
    const { name, version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as {
      name: string;
      version: string;
    };
    return `${name} ${version}\n\n${licenceOf(folder, name)}`;
  });
  return [...new Set(notices)].sort();
}

/**
 * Replaces <!-- licences --> by all licences of a page. `more` are the files of scripts that stand
 * in it as text, `others` the licences of what is not from npm.
 */
export function licences(more: ReadonlySet<string> = new Set(), others = ''): Plugin {
  return {
    name: 'gw-licences',
    transformIndexHtml: {
      order: 'post',
      handler(page, { bundle }) {
        const files = Object.values(bundle ?? {}).flatMap((part) =>
          part.type === 'chunk'
            ? Object.entries(part.modules).flatMap(([file, { renderedLength }]) =>
                renderedLength > 0 ? [file] : [],
              )
            : [],
        );
        const line = `\n\n${'-'.repeat(72)}\n\n`;
        const text = [
          readFileSync(join(project, 'LICENSE'), 'utf8').trim(),
          ...noticesOf([...files, ...more]),
          ...(others ? [others.trim()] : []),
        ].join(line);
        const safe = text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
        return page.replace(
          '<!-- licences -->',
          () => `<script id="licences" type="text/plain">${safe}</script>`,
        );
      },
    },
  };
}
