// Files and folders as they are dropped or chosen, read as text.
/** @import { Entry } from './entries.js' */
import { mostEntries } from './entries.js';
import { isTable, ownersOfFiles } from './owners.js';

/** In bytes: a hand-in is a few hundred characters, the table of a whole course some megabytes. */
const mostOfFile = 2_000_000;
const mostOfTable = 40_000_000;

/** All files in what was dropped, those in folders too. @param {DataTransfer} dropped @returns {Promise<File[]>} */
export async function filesIn(dropped) {
  // Before the event is over, for then they are gone.
  const entries = [...dropped.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = [...dropped.files];
  if (!entries.some((entry) => entry?.isDirectory)) return plain;
  /** @type {File[]} */
  const files = [];
  const walk = async (/** @type {FileSystemEntry} */ entry) => {
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

const pathOf = (/** @type {File} */ file) => file.webkitRelativePath || file.name;

/** Files that were chosen, and more of them: one that is there already, to the last letter, is not there twice. @param {readonly File[]} files @param {readonly File[]} more */
export async function joined(files, more) {
  const keyOf = (/** @type {File} */ file) => `${pathOf(file)} ${file.size} ${file.lastModified}`;
  /** @type {Map<string, File[]>} */
  const known = new Map();
  for (const file of files) known.set(keyOf(file), [...(known.get(keyOf(file)) ?? []), file]);
  const isThere = async (/** @type {File} */ file) => {
    const alike = known.get(keyOf(file)) ?? [];
    const texts = await Promise.all([file, ...alike].map((one) => one.text()));
    return texts.indexOf(texts[0], 1) > 0;
  };
  const all = [...files];
  for (const file of more) if (!known.has(keyOf(file)) || !(await isThere(file))) all.push(file);
  return all;
}

/** Spreadsheets save tables in UTF-16 with its mark, or in what their system is in, Korean or western. @param {File} file */
async function textOf(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const [first, second] = bytes;
  if (first === 0xff && second === 0xfe) return new TextDecoder('utf-16le').decode(bytes);
  if (first === 0xfe && second === 0xff) return new TextDecoder('utf-16be').decode(bytes);
  for (const one of ['utf-8', 'euc-kr'])
    try {
      return new TextDecoder(one, { fatal: true }).decode(bytes);
    } catch {
      // Bytes that it does not have: the next one.
    }
  return new TextDecoder('windows-1252').decode(bytes);
}

/** @param {readonly File[]} files @param {ReturnType<typeof import('./entries.js').createReader>} reader @returns {Promise<Entry[]>} */
export async function readAll(files, reader) {
  /** @type {Entry[]} */
  const entries = [];
  const paths = files.map(pathOf);
  for (const [i, whose] of ownersOfFiles(paths).entries()) {
    if (entries.length >= mostEntries) {
      // Of what is not checked, a file counts as one.
      entries.push(reader.tooLong(whose));
      continue;
    }
    const most = isTable(paths[i]) && !whose.isStudents ? mostOfTable : mostOfFile;
    if (files[i].size > most) entries.push(reader.tooLong(whose));
    else
      for (const entry of await reader.readFile(paths[i], await textOf(files[i]), whose)) entries.push(entry);
  }
  return entries;
}
