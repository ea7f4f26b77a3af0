// A Vite plugin that writes what there is to read and to see where the page cannot run: a sentence and a picture into the
// page, and the lesson as a page of its own in each language, or, where there is one file alone, into it too.
import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { languageNames, languages } from '../www/words/language.js';

/** @typedef {import('../www/words/language.js').Language} Language */
/** @typedef {{ lang: Language } & Record<'page' | 'why' | 'caption' | 'title' | 'note' | 'lesson', string>} Texts */

const run = promisify(execFile);
const writer = fileURLToPath(new URL('article.mjs', import.meta.url));

/** The words choose their language when they are loaded: so each is written by a process of its own. @param {Language} lang @returns {Promise<Texts>} */
async function textsIn(lang) {
  const { stdout } = await run(process.execPath, [writer, lang], { maxBuffer: 1e7 });
  return { lang, ...JSON.parse(stdout) };
}

/** @param {Language} lang */
const fileOf = (lang) => `lesson.${lang}.html`;

/** All of it: what the site's page has, what the one file has, and the pages of the lesson; `styles` are their elements. */
export async function writeInstead() {
  const { picture } = await import('./picture.mjs');
  const all = await Promise.all(languageNames.map(textsIn));
  const each = (/** @type {(texts: Texts) => string} */ write) => all.map(write).join('\n');
  const above = [
    `<div class="instead-why">${each(({ lang, why }) => `<p lang="${lang}">${why}</p>`)}</div>`,
    `<figure>${picture}<figcaption>${each(({ lang, caption }) => `<p lang="${lang}">${caption}</p>`)}</figcaption></figure>`,
  ].join('\n');
  return {
    linked: `${above}\n${each(({ lang, title }) => `<p lang="${lang}"><a href="./${fileOf(lang)}">${title}</a></p>`)}`,
    inside: `${above}\n${each(({ lang, title, note, lesson }) => `<details lang="${lang}"><summary>${title}</summary><p>${note}</p>${lesson}</details>`)}`,
    pages: all.map((texts) => ({
      fileName: fileOf(texts.lang),
      html: (/** @type {string} */ styles) => pageOf(texts, picture, styles),
    })),
  };
}

/** The lesson, to read, as a page. @param {Texts} texts @param {string} picture @param {string} styles */
function pageOf({ lang, page, title, note, caption, lesson }, picture, styles) {
  const others = languageNames.filter((name) => name !== lang);
  const links = others.map(
    (name) =>
      `<a class="language" lang="${name}" hreflang="${name}" href="./${fileOf(name)}">${languages[name]}</a>`,
  );
  return `<!doctype html>
<html lang="${lang}">
<head>
  <meta charset="utf-8">
  <meta name="viewport" content="width=device-width, initial-scale=1">
  <meta name="color-scheme" content="light dark">
  <meta name="description" content="${note}">
  <title>${title} – ${page}</title>
  ${styles}
</head>
<body class="to-read">
  <header>
    <a href="./#lesson&amp;lang=${lang}">${page}</a>
    ${links.join('\n    ')}
  </header>
  <main class="instead">
    <h1>${title}</h1>
    <p>${note}</p>
    <figure>${picture}<figcaption><p>${caption}</p></figcaption></figure>
    ${lesson}
  </main>
</body>
</html>
`;
}

const place = /(<div id="instead"[^>]*>).*?(<\/div>)/s;
/** What the built page says of its looks. */
const looks = /<link rel="(?:stylesheet|icon)"[^>]*>/g;

/** @param {{ isOneFile: boolean }} options @returns {import('vite').Plugin} */
export const instead = ({ isOneFile }) => ({
  name: 'instead',
  apply: 'build',
  enforce: 'post',
  async generateBundle(_, bundle) {
    const page = bundle['index.html'];
    // A page of somebody else's has no place for them.
    if (page?.type !== 'asset' || !place.test(String(page.source))) return;
    const { linked, inside, pages } = await writeInstead();
    // From a disk a browser loads no style that asks for the rights of another site.
    const html = String(page.source).replace(/<link rel="stylesheet" crossorigin/g, '<link rel="stylesheet"');
    page.source = html.replace(place, (_, begin, end) => begin + (isOneFile ? inside : linked) + end);
    if (isOneFile) return;
    // Those of the lesson are loaded with it, so that no page names them.
    const more = Object.values(bundle)
      .filter((file) => file.type === 'chunk' && file.moduleIds.some((id) => id.endsWith('/lesson/page.js')))
      .flatMap((file) => [.../** @type {any} */ (file.viteMetadata?.importedCss ?? [])])
      .map((name) => `<link rel="stylesheet" href="./${name}">`);
    const styles = [...(html.match(looks) ?? []), ...more].join('\n  ');
    for (const { fileName, html } of pages) this.emitFile({ type: 'asset', fileName, source: html(styles) });
  },
});
