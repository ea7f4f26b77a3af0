// A Vite plugin that lets a browser ask for the core, and for the page, while the words are still on their way.

/** @returns {import('vite').Plugin} */
export const hints = () => ({
  name: 'hints',
  apply: 'build',
  enforce: 'post',
  generateBundle(_, bundle) {
    const page = bundle['index.html'];
    const core = Object.keys(bundle).find((name) => name.endsWith('.wasm'));
    if (page?.type !== 'asset' || !core) return;
    const modules = Object.values(bundle).filter(
      (file) =>
        file.type === 'chunk' &&
        (file.name === 'shared' || file.moduleIds.some((id) => id.endsWith('/www/page.js'))),
    );
    const hint = [
      `<link rel="preload" href="./${core}" as="fetch" type="application/wasm" crossorigin>`,
      ...modules.map(({ fileName }) => `<link rel="modulepreload" href="./${fileName}">`),
    ].join('\n  ');
    page.source = String(page.source).replace('</head>', `  ${hint}\n</head>`);
  },
});
