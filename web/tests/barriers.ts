// What keeps people from using a page, by axe-core: the rules of WCAG 2.2 A and AA and its best
// practice.
import { source } from 'axe-core';
import type { Frame, Page } from 'puppeteer-core';

interface Axe {
  run(options: object): Promise<{
    violations: { id: string; nodes: { target: unknown[]; failureSummary?: string }[] }[];
  }>;
}

/** The rule that is broken, and where. */
export async function barriersOf(page: Page | Frame): Promise<string[]> {
  await page.evaluate(source);
  return page.evaluate(async () => {
    const { axe } = window as unknown as { axe: Axe };
    const { violations } = await axe.run({
      resultTypes: ['violations'],
      iframes: false, // they cannot be asked from outside
      rules: { 'label-content-name-mismatch': { enabled: true } }, // experimental: else not asked
    });
    return violations.flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${String(target)}: ${failureSummary}`),
    );
  });
}
