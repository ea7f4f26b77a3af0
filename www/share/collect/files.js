// Files and folders as they are dropped or chosen, read as text.
/** @import { Entry } from './entries.js' */
import { namesOfFiles } from './entries.js';

/** In bytes: a hand-in is a few hundred characters, the table of a whole course some megabytes. */
const mostOfFile = 2_000_000;
const mostOfTable = 40_000_000;
const mostFiles = 5000;

/** All files in what was dropped, those in folders too. @param {DataTransfer} dropped @returns {Promise<File[]>} */
export async function filesIn(dropped) {
  // Before the event is over, for then they are gone.
  const entries = [...dropped.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = [...dropped.files];
  if (!entries.some((entry) => entry?.isDirectory)) return plain;
  /** @type {File[]} */
  const files = [];
  const walk = async (/** @type {FileSystemEntry} */ entry) => {
    if (files.length >= mostFiles) return;
    if (entry.isFile) {
      const file = await new Promise((resolve, reject) =>
        /** @type {FileSystemFileEntry} */ (entry).file(resolve, reject),
      );
      // Where it lies names whose it is.
      Object.defineProperty(file, 'webkitRelativePath', { value: entry.fullPath.slice(1) });
      files.push(/** @type {File} */ (file));
      return;
    }
    const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader();
    for (;;) {
      /** @type {FileSystemEntry[]} */
      const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
      if (some.length === 0) return;
      for (const one of some) await walk(one);
    }
  };
  for (const entry of entries) if (entry) await walk(entry);
  return files;
}

/** @param {readonly File[]} files @param {ReturnType<typeof import('./entries.js').createReader>} reader @returns {Promise<Entry[]>} */
export async function readAll(files, reader) {
  /** @type {Entry[]} */
  const entries = [];
  const paths = files.slice(0, mostFiles).map((file) => file.webkitRelativePath || file.name);
  for (const [i, name] of namesOfFiles(paths).entries()) {
    const most = /\.(?:csv|tsv)$/i.test(paths[i]) ? mostOfTable : mostOfFile;
    if (files[i].size > most) entries.push(reader.tooLong(name));
    else entries.push(...(await reader.readFile(paths[i], await files[i].text(), name)));
  }
  return entries;
}
