// Which tests a mode runs: of the models, of pages in a browser, of the lab.
import { defineConfig } from 'vitest/config';

const inPages = (include: string, milliseconds: number) => ({
  include: [include],
  testTimeout: milliseconds,
  hookTimeout: milliseconds,
});

export default defineConfig(({ mode }) => {
  if (mode === 'browser') return { test: inPages('tests/browser/*.test.ts', 60_000) };
  if (mode === 'lab') return { test: inPages('tests/lab/*.test.ts', 120_000) };
  return {
    test: {
      include: ['tests/{,messages/}*.test.ts'],
      server: { deps: { inline: ['@gamestdio/scorm'] } }, // it keeps a state, which tests begin anew
    },
  };
});
