// Who handed in a file, by the names that learning platforms give to folders and files.
/** @import { Entry } from './entries.js' */

/** @typedef {Pick<Entry, 'name' | 'ident'> & { isStudents: boolean }} Whose */

/** Whose it is in anonymous submissions of Moodle: nobody's name. */
const anybody = /^(?:participant|참가자|참여자)$/i;

/** Moodle names folders and files of submissions `Name_12345_assignsubmission_…`, Canvas `name_12345_67890_file`, and what was typed there `name_12345_text`: the first number is the student's. @param {string} path */
export function ownerOf(path) {
  const parts = path.split('/');
  const moodle = parts.map((part) => /^(.+?)_(\d+)_assignsubmission_/.exec(part)).find(Boolean);
  const file = parts[parts.length - 1].replace(/\.\w+$/, '');
  const canvas = /^(\D+?|[^_]*\p{L}[^_]*)_(?:LATE_)?(\d+)_(?:\d+_|(?:text|link)$)/u.exec(file);
  const [, name, number] = moodle ?? canvas ?? ['', file, ''];
  // As its English worksheet has it, or the table of its gradebook.
  const ident = moodle ? { Identifier: `Participant ${number}` } : { ID: number };
  return { name, number, ident, isMoodle: Boolean(moodle) };
}

/** @param {string} path */
export const isTable = (path) => /\.(?:csv|tsv)$/i.test(path);

/** Who handed in each of these files, and whether it is that student's alone, whatever stands in it. What is no name, or that of several, has the number beside it. @param {readonly string[]} paths @returns {Whose[]} */
export function ownersOfFiles(paths) {
  const owners = paths.map(ownerOf);
  /** @type {Map<string, Set<string>>} */
  const numbers = new Map();
  for (const { name, number } of owners) numbers.set(name, (numbers.get(name) ?? new Set()).add(number));
  // Where all are tables, such as class_2026_11_all.csv, they are the lecturer's own.
  const isClass = owners.some(({ number }, i) => number !== '' && !isTable(paths[i]));
  return owners.map(({ name, number, ident, isMoodle }) => {
    const isStudents = number !== '' && (isMoodle || isClass);
    return {
      name: anybody.test(name) || (numbers.get(name)?.size ?? 0) > 1 ? `${name} ${number}`.trim() : name,
      ident: isStudents ? ident : {},
      isStudents,
    };
  });
}
