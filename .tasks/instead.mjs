// A Vite plugin that writes into the built page what there is to read and to see where it cannot run.
import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { languageNames } from '../www/words/language.js';

/** @typedef {Record<'why' | 'caption' | 'article', string>} Texts */

const run = promisify(execFile);
const writer = fileURLToPath(new URL('article.mjs', import.meta.url));

/** The words choose their language when they are loaded: so each is written by a process of its own. @param {string} language @returns {Promise<Texts>} */
const textsIn = async (language) =>
  JSON.parse((await run(process.execPath, [writer, language], { maxBuffer: 1e7 })).stdout);

/** All of it, as the built page has it. */
export async function writeInstead() {
  const { picture } = await import('./picture.mjs');
  const all = await Promise.all(languageNames.map(async (lang) => ({ lang, ...(await textsIn(lang)) })));
  const each = (/** @type {string} */ tag, /** @type {keyof Texts} */ part) =>
    all.map((texts) => `<${tag} lang="${texts.lang}">${texts[part]}</${tag}>`).join('\n');
  return [
    `<div class="instead-why">${each('p', 'why')}</div>`,
    `<figure>${picture}<figcaption>${each('p', 'caption')}</figcaption></figure>`,
    each('details', 'article'),
  ].join('\n');
}

const place = /(<div id="instead"[^>]*>).*?(<\/div>)/s;

/** @returns {import('vite').Plugin} */
export const instead = () => ({
  name: 'instead',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    async handler(html) {
      if (!place.test(html)) return html;
      const written = await writeInstead();
      return html.replace(place, (_, begin, end) => begin + written + end);
    },
  },
});
