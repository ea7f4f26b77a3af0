// Into which files the page is divided: few, and none that waits for itself. A file that awaits the words of a language
// must hold nothing that these words need, for they would wait for it in turn.

/** @typedef {{ getModuleInfo: (id: string) => { importers: readonly string[] } | null }} Graph */

const languages = /[\\/]words[\\/](en|ko)([\\/]|\.js$)/;

/** Whether a module is loaded together with one of these, however far from it. @param {string} id @param {(id: string) => boolean} isOne @param {Graph} graph */
function isLoadedWith(id, isOne, graph) {
  const seen = new Set([id]);
  for (const one of seen) {
    if (isOne(one)) return true;
    for (const importer of graph.getModuleInfo(one)?.importers ?? []) seen.add(importer);
  }
  return false;
}

/** By rank, for each takes what its modules need with it. @type {((id: string, graph: Graph) => string | null)[]} */
const files = [
  (id, graph) =>
    !languages.test(id) && isLoadedWith(id, (one) => languages.test(one), graph) ? 'symbols' : null,
  (id) => /[\\/]www[\\/]words[\\/](en|ko)[\\/]/.exec(id)?.[1] ?? null,
  (id, graph) =>
    !languages.test(id) && isLoadedWith(id, (one) => one.endsWith('/www/main.js'), graph) ? 'page' : null,
  // What several parts share; a part alone is in one file by itself, and so are the checks.
  (id) => (/[\\/]www[\\/](kit|core(?![\\/]checks))[\\/]/.test(id) ? 'shared' : null),
];

export const chunks = { groups: files.map((name, i) => ({ name, priority: files.length - i })) };
