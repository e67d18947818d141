// A learning platform that runs one package in a frame: scorm-again's SCORM 1.2 interface, which
// checks every call against the standard's data model. Keeps the calls.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Frame, Page } from 'puppeteer-core';

/** A call, its arguments and the platform's error code after it. */
export type Call = readonly [name: string, args: readonly string[], error: string];

interface PlatformWindow {
  calls: Call[];
  API: Record<string, (...args: string[]) => string>;
}

const page = (data: object): string => `<!doctype html><meta charset="utf-8"><title>Platform</title>
<script>${readFileSync('node_modules/scorm-again/dist/scorm12.min.js', 'utf8')}</script>
<script>
const real = new Scorm12API({ autocommit: false, logLevel: 5 });
real.loadFromJSON(${JSON.stringify(data)}, 'cmi');
window.calls = [];
window.API = Object.fromEntries(['LMSInitialize', 'LMSFinish', 'LMSGetValue', 'LMSSetValue',
  'LMSCommit', 'LMSGetLastError'].map((name) => [name, (...args) => {
    const answer = real[name](...args);
    calls.push([name, args, String(real.LMSGetLastError())]);
    return answer;
  }]));
</script>
<iframe src="package/index.html" width="1200" height="680" title="package"></iframe>`;

/** The packages of these pages, by scripts/scorm. */
export function packagesOf(folder: string, lab: string, articles: string, ...options: string[]) {
  const scripts = join(process.env['GW_SCENES'] ?? '../scenes', '../scripts');
  execFileSync(join(scripts, 'scorm'), [folder, lab, articles, ...options], { stdio: 'pipe' });
}

export class LearningPlatform {
  constructor(
    private readonly folder: string,
    private readonly opened: Page,
  ) {}

  /** `data`: what the platform keeps of an earlier visit. */
  async run(zip: string, data: object = {}): Promise<Frame> {
    mkdirSync(join(this.folder, 'package'), { recursive: true });
    execFileSync('cmake', ['-E', 'tar', 'xf', zip], { cwd: join(this.folder, 'package') });
    const file = join(this.folder, 'platform.html');
    writeFileSync(file, page(data));
    await this.opened.setViewport({ width: 1280, height: 720 });
    await this.opened.goto(`file://${file}`);
    const frame = await (await this.opened.waitForSelector('iframe'))!.contentFrame();
    await frame.waitForSelector('main');
    return frame;
  }
  calls(): Promise<Call[]> {
    return this.opened.evaluate(() => (window as unknown as PlatformWindow).calls);
  }
  value(element: string): Promise<string> {
    return this.opened.evaluate(
      (element) => (window as unknown as PlatformWindow).API['LMSGetValue']!(element),
      element,
    );
  }
  /** The learner leaves the page. */
  async leave(): Promise<void> {
    await this.opened.$eval('iframe', (e) => {
      (e as HTMLIFrameElement).src = 'about:blank';
    });
    await this.opened.waitForFunction(() =>
      (window as unknown as PlatformWindow).calls.some(([name]) => name === 'LMSFinish'),
    );
  }
}
