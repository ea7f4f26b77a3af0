// A Vite plugin that lets a browser ask for the core while the page's script is still on its way.

/** @returns {import('vite').Plugin} */
export const hints = () => ({
  name: 'hints',
  apply: 'build',
  enforce: 'post',
  generateBundle(_, bundle) {
    const page = bundle['index.html'];
    const core = Object.keys(bundle).find((name) => name.endsWith('.wasm'));
    if (page?.type !== 'asset' || !core) return;
    const hint = `<link rel="preload" href="./${core}" as="fetch" type="application/wasm" crossorigin>`;
    page.source = String(page.source).replace('</head>', `  ${hint}\n</head>`);
  },
});
