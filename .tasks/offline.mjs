// A Vite plugin that makes one HTML file of the whole page, which works from a disk without a network.
import { gzipSync } from 'node:zlib';

/** The file reaches nothing outside of itself, whatever is in it, but the server that it comes from, if it does: to ask whether that is there. */
const policy = [
  "default-src 'none'",
  "script-src 'unsafe-inline' 'wasm-unsafe-eval'",
  "style-src 'unsafe-inline'",
  'img-src data: blob:',
  "connect-src 'self'",
  'worker-src blob:',
  // Itself, as the preview of an exercise.
  "frame-src 'self' file:",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** @returns {import('vite').Plugin} */
export function oneFile() {
  return {
    name: 'one-file',
    enforce: 'post',
    config: () => ({
      // Instead of the address of the worker's file, its text.
      resolve: { alias: [{ find: /^(.*\?worker)$/, replacement: '$1&inline' }] },
      build: {
        assetsInlineLimit: Number.POSITIVE_INFINITY,
        cssCodeSplit: false,
        // The site is there already.
        emptyOutDir: false,
        rolldownOptions: { output: { codeSplitting: false } },
      },
    }),
    generateBundle(_, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') this.error('there is no index.html to put everything into');
      const meta = `<meta http-equiv="Content-Security-Policy" content="${policy}">`;
      let html = String(page.source).replace('<head>', `<head>\n  ${meta}`);
      for (const [name, file] of Object.entries(bundle)) {
        if (file === page) continue;
        const tag = new RegExp(`<(script|link)[^>]*"\\./${name}"[^>]*>(</script>)?`);
        const element = elementOf(name, file.type === 'chunk' ? standalone(file.code) : String(file.source));
        if (element === null || !tag.test(html)) this.error(`${name} would stay outside of the one file`);
        html = html.replace(tag, () => element);
        delete bundle[name];
      }
      page.source = html;
      page.fileName = 'ep-locomotion.html';
    },
  };
}

/** Where something was to be loaded on demand, Vite leaves a name in which no file is listed: nothing is to be loaded first. @param {string} code */
const standalone = (code) => packed(code.replaceAll('__VITE_PRELOAD__', '[]'));

/** The core in less than half of its length, as the page expects it where it has it within. @param {string} code */
const packed = (code) =>
  code.replace(
    /data:application\/wasm;base64,([\w+/=]+)/,
    (_, core) =>
      `data:application/gzip;base64,${gzipSync(Buffer.from(core, 'base64'), { level: 9 }).toString('base64')}`,
  );

/** What takes the place of the tag that names a file; null if it is of no kind that we have. @param {string} name @param {string} text */
function elementOf(name, text) {
  // What would end the element before its time is written otherwise, which only strings have in them.
  if (name.endsWith('.js'))
    return `<script type="module">${text.replaceAll(/<(?=\/script|!--)/gi, '\\x3C')}</script>`;
  if (name.endsWith('.css')) return `<style>${text.replaceAll('</', '<\\/')}</style>`;
  if (name.endsWith('.svg')) return `<link rel="icon" href="data:image/svg+xml,${encodeURIComponent(text)}">`;
  return null;
}
