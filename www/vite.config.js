import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

export default defineConfig({
  root: fileURLToPath(new URL('..', import.meta.url)),
  base: './',
  publicDir: false,
  server: { watch: { ignored: ['**/target/**', '**/dist/**', '**/.tools/**'] } },
  build: {
    target: 'es2022',
    // Nothing inline, so that the strictest content security policy lets the page run.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  worker: { format: 'es' },
});
