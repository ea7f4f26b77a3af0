// Into which files the page is divided: few, and none that is run too soon. A file that needs the words of a language must hold
// nothing that these words need, nor what loads them.

import { languageNames } from '../www/words/language.js';

/** @typedef {{ getModuleInfo: (id: string) => { importers: readonly string[] } | null }} Graph */

const anyLanguage = `(${languageNames.join('|')})`;
const languages = new RegExp(String.raw`[\\/]words[\\/](?:[a-z]+-)?${anyLanguage}([\\/]|\.js$)`);
const commonWords = new RegExp(String.raw`[\\/]www[\\/]words[\\/]${anyLanguage}[\\/]`);

/** Whether a module is loaded together with one of these, however far from it. @param {string} id @param {(id: string) => boolean} isOne @param {Graph} graph */
function isLoadedWith(id, isOne, graph) {
  const seen = new Set([id]);
  for (const one of seen) {
    if (isOne(one)) return true;
    for (const importer of graph.getModuleInfo(one)?.importers ?? []) seen.add(importer);
  }
  return false;
}

/** It asks for the words. @param {string} id */
const isFirst = (id) => id.endsWith('/www/main.js');

/** By rank, for each takes what its modules need with it. @type {((id: string, graph: Graph) => string | null)[]} */
const files = [
  (id, graph) =>
    !isFirst(id) &&
    !languages.test(id) &&
    isLoadedWith(id, (one) => isFirst(one) || languages.test(one), graph)
      ? 'symbols'
      : null,
  (id) => commonWords.exec(id)?.[1] ?? null,
  (id, graph) =>
    !languages.test(id) && isLoadedWith(id, (one) => one.endsWith('/www/page.js'), graph) ? 'page' : null,
  // What several parts share; a part alone is in one file by itself, and so are the checks.
  (id) => (/[\\/]www[\\/](kit|core(?![\\/]checks))[\\/].*\.js$/.test(id) ? 'shared' : null),
];

export const chunks = { groups: files.map((name, i) => ({ name, priority: files.length - i })) };
