import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['tests/{,messages/}*.test.ts'],
    server: { deps: { inline: ['@gamestdio/scorm'] } }, // it keeps a state, which tests begin anew
  },
});
