// What was handed in, found in whatever a learning platform gives: tables, online texts with their HTML, files, links. Nothing is
// believed here, and nothing of it becomes markup.
import { createTurns } from '../../kit/loop.js';
import { tidyText } from '../../kit/text.js';
import { mark } from '../handin/mark.js';
import { fromRow, partsOf, tableIn } from './columns.js';

/** One hand-in: who it is from as the platform says, how the platform knows them (column by column), a beginning of the text, and its link, or why there is none. @typedef {{ name: string, ident: Readonly<Record<string, string>>, text: string, link: string | null, why: 'none' | 'long' | 'more' | null, isReceipt: boolean, isOnes: boolean }} Entry `isReceipt`: it says that it is one; `isOnes`: it stands in a file of this student's, or in a row with this name. */

/** In characters. */
export const mostOfAll = 12_000_000;
const mostOfOne = 200_000;
/** Thousands of them are checked in a row. */
const mostOfLink = 50_000;
const mostOfName = 80;
/** So many are checked at once; the others are only counted. */
export const mostEntries = 5000;
/** So many receipts of one student's file, its last, so that it leaves room for the others. */
export const mostOfStudent = 20;
/** So many milliseconds in a row. */
const slice = 12;

/** @type {Entry} */
const unread = Object.freeze({
  name: '',
  ident: {},
  text: '',
  link: null,
  why: 'none',
  isReceipt: false,
  isOnes: false,
});

const entities = /** @type {Readonly<Record<string, string>>} */ ({
  amp: '&',
  lt: '<',
  gt: '>',
  quot: '"',
  apos: "'",
  nbsp: ' ',
});

/** @param {string} text */
const withoutEntities = (text) =>
  text.replace(
    /&(?:#(\d{1,7})|#x([\da-f]{1,6})|(amp|lt|gt|quot|apos|nbsp));/gi,
    (whole, decimal, hex, name) => {
      if (name) return entities[name.toLowerCase()];
      const code = Number.parseInt(decimal ?? hex, decimal ? 10 : 16);
      return code > 0 && code <= 0x10ffff ? String.fromCodePoint(code) : whole;
    },
  );

/** What is said, line by line. @param {string} html */
const saidIn = (html) =>
  withoutEntities(
    html.replace(/<(?:br|\/p|\/div|\/li|\/tr|\/h\d)\b[^<>]*>/gi, '\n').replace(/<\/?[a-z!][^<>]*>/gi, ' '),
  );

/** @param {string} tag */
const hrefIn = (tag) => /\bhref=["']([^"'<>]*)["']/i.exec(tag)?.[1] ?? '';

/** @param {string} text @param {string} what */
const countOf = (text, what) => text.split(what).length - 1;

/** @param {string} text */
const beginning = (text) => tidyText(text).slice(0, 80);

/** A receipt to its last digits, without what a text has behind them; null if they are not there. @param {string} link */
function wholeIn(link) {
  const at = link.indexOf('handin=');
  const end = at < 0 ? null : /(?:~|%7E)[\da-f]{8}(?!~|%7E)/i.exec(link.slice(at));
  return end && link.slice(0, at + end.index + end[0].length);
}

/** A link without a receipt, without what ends a sentence or a bracket. A task may end so too. @param {string} link */
function withoutEnd(link) {
  if (/&task=[^&]*$/.test(link)) return link;
  let end = link.length;
  while (end > 0 && !/[\w%-]/.test(link[end - 1])) end -= 1;
  return link.slice(0, end);
}

/** A line that ends with the digits of a receipt. @param {string} line */
const endsReceipt = (line) => /^handin=\S*~[\da-f]{8}$/.test(line.slice(line.lastIndexOf('handin=')));

/** @param {string} link */
const whoIn = (link) => /&who=([^&\s]*)/.exec(link)?.[1];

/** A platform keeps behind a receipt what the same student did after it, each with the package's stamp: that is not handed in. @param {string} line @param {string} before */
const isLater = (line, before) =>
  before.includes('handin=') &&
  !line.includes('handin=') &&
  [line, before].every((one) => /^#\S+(?: [\da-f]{8})?$/.test(one)) &&
  whoIn(line) === whoIn(before);

/** @param {[text: string, whose: string][]} parts */
const lastReceipts = (parts) =>
  parts.filter(([one]) => one.includes(mark) || one.includes('handin=')).slice(-mostOfStudent);

/** Links of these pages. @param {readonly string[]} pages */
function createFinder(pages) {
  const pattern = new RegExp(`(?<![\\w%])(?:${pages.join('|')})&(?:amp;)*[\\w.]+=[^\\s"<>\\\\^\`{}|]*`, 'g');

  /** @param {string} text */
  const linksIn = (text) => withoutEntities(withoutEntities(text)).match(pattern) ?? [];

  const hasLink = (/** @type {string} */ text) => linksIn(text).length > 0;

  /** The one that counts: a receipt before others, and of several the last. @param {string} text */
  function linkIn(text) {
    const found = linksIn(text);
    const receipts = found.filter((link) => link.includes('handin='));
    const whole = receipts.map(wholeIn).filter((link) => link !== null);
    if (whole.length > 0) return whole[whole.length - 1];
    // One that was broken into lines.
    const joined = found.length > 0 && text.includes(mark) ? linksIn(text.replace(/[\s>]+/g, '')) : [];
    const [last] = found.slice(-1).map(withoutEnd);
    return joined.map(wholeIn).find(Boolean) ?? receipts.at(-1) ?? last ?? null;
  }

  /** Receipts, lines with links, or a table. @param {string} text */
  function holdsSeveral(text) {
    const lines = text.split('\n').map((line) => line.trim());
    const receipts = linksIn(text).map(wholeIn).filter(Boolean);
    const isMore = (/** @type {readonly unknown[]} */ all) => new Set(all).size > 1;
    return (
      countOf(text, mark) > 1 ||
      isMore(receipts) ||
      isMore(lines.filter(hasLink)) ||
      tableIn(text, hasLink) !== null
    );
  }

  return { linksIn, linkIn, hasLink, holdsSeveral };
}

/** @param {readonly Entry[]} entries */
const asOnes = (entries) => entries.map((entry) => ({ ...entry, isOnes: true }));

/** @param {readonly string[]} pages */
export function createReader(pages) {
  const { linksIn, linkIn, hasLink, holdsSeveral } = createFinder(pages);

  /** @param {string} text @param {string} name @param {Entry['ident']} [ident] @returns {Entry} */
  function entryOf(text, name, ident = {}) {
    const said = beginning(saidIn(text.slice(0, 2000)));
    const about = {
      name: tidyText(name).slice(0, mostOfName),
      ident,
      text: said,
      isReceipt: text.includes(mark),
      isOnes: false,
    };
    if (text.length > mostOfOne) return { ...about, link: null, why: 'long' };
    const link = linkIn(text);
    if (link === null) return { ...about, link, why: 'none' };
    return link.length > mostOfLink ? { ...about, link: null, why: 'long' } : { ...about, link, why: null };
  }

  /** Lines, of which each is a hand-in but for those of a receipt, which ends with its link. @param {string} text @param {string} name @param {boolean} [isStudents] @returns {Promise<Entry[]>} */
  async function fromLines(text, name, isStudents = false) {
    const isHtml = /<\/?(?:p|div|br|a|span|li|td|html|body|img|script)\b/i.test(text);
    if (isHtml && new Set(linksIn(text)).size < 2) return [entryOf(text, name)];
    const withLinks = text.replace(/<a\b[^<>]*>/gi, (tag) => ` ${hrefIn(tag)} `);
    const lines = (isHtml ? saidIn(withLinks) : text).split(/\r?\n/).map((line) => line.trim());
    /** @type {[text: string, whose: string][]} */
    const parts = [];
    /** @type {string[]} */
    let receipt = [];
    const end = () => {
      if (receipt.length > 0) parts.push([receipt.join('\n'), name]);
      receipt = [];
    };
    const turn = createTurns(slice);
    for (const [i, line] of lines.entries()) {
      await turn();
      if (i > 0 && isLater(line, lines[i - 1])) continue;
      if (line.includes(mark)) end();
      if (receipt.length > 0 || line.includes(mark)) {
        receipt.push(line);
        // What may still be of it: a link that was broken into lines.
        if (endsReceipt(line) || (line === '' && receipt.length > 3)) end();
      } else if (line !== '') parts.push([line, name || nameBefore(line)]);
    }
    end();
    const isMore = isStudents && parts.length > mostOfStudent;
    /** @type {Entry[]} */
    const entries = isMore ? [{ ...unread, name, why: 'more' }] : [];
    for (const [one, whose] of isMore ? lastReceipts(parts) : parts) {
      await turn();
      entries.push(entries.length < mostEntries ? entryOf(one, whose) : unread);
    }
    return entries;
  }

  return {
    /** @param {string} text @returns {Promise<Entry[]>} */
    async read(text) {
      const table = tableIn(text, hasLink);
      if (!table) return fromLines(text, '');
      const turn = createTurns(slice);
      const parts = partsOf(table.columns, table.rows, hasLink);
      const entries = [];
      for (const row of table.rows) {
        await turn();
        entries.push(entries.length < mostEntries ? fromRow(parts, row, entryOf) : unread);
      }
      return entries;
    },

    /** A file is one hand-in, unless it is a table or holds several; who those are from, its name says only where they are one student's. @param {string} path @param {string} text @param {{ name: string, isStudents: boolean }} [whose] @returns {Promise<Entry[]>} */
    async readFile(path, text, { name, isStudents } = ownersOfFiles([path])[0]) {
      if (isStudents)
        return asOnes(countOf(text, mark) > 1 ? await fromLines(text, name, true) : [entryOf(text, name)]);
      if (!isTable(path) && !holdsSeveral(text)) return [entryOf(text, name)];
      const entries = await this.read(text);
      const whos = new Set(entries.map(({ link }) => link && whoIn(link)).filter(Boolean));
      const isOnes = ownerOf(path).number !== '' || entries.length === 1 || whos.size === 1;
      return entries.map((entry) => ({ ...entry, name: entry.name || (isOnes ? name : '') }));
    },

    /** @param {string} name @returns {Entry} */
    tooLong: (name) => ({ ...unread, name, why: 'long' }),
  };
}

/** The name in a line such as “Kim, https://…”, without what lists and mail programs have beside a link. @param {string} line */
function nameBefore(line) {
  const [before] = line.split(/https?:|file:|#|(?:^|\s)[\w-]+\.html/, 1);
  if (before.length === line.length) return '';
  const name = before
    .slice(0, mostOfName)
    .replace(/\[[^\]]*\]\($/, '')
    .replace(/^(?:[\s"'*•-]|\d+[.)]\s)+/, '')
    .replace(/[\s,;:|"'<(–—-]+$/, '');
  return /[\p{L}\d]/u.test(name) ? name : '';
}

/** Whose it is in anonymous submissions of Moodle: nobody's name. */
const anybody = /^(?:participant|참가자|참여자)$/i;

/** Moodle names folders and files of submissions `Name_12345_assignsubmission_…`, Canvas `name_12345_67890_file`, and what was typed there `name_12345_text`: the first number is the student's. @param {string} path */
function ownerOf(path) {
  const parts = path.split('/');
  const moodle = parts.map((part) => /^(.+?)_(\d+)_assignsubmission_/.exec(part)).find(Boolean);
  const file = parts[parts.length - 1].replace(/\.\w+$/, '');
  const canvas = /^(\D+?|[^_]*\p{L}[^_]*)_(?:LATE_)?(\d+)_(?:\d+_|(?:text|link)$)/u.exec(file);
  const [, name, number] = moodle ?? canvas ?? ['', file, ''];
  return { name, number, isMoodle: Boolean(moodle) };
}

/** @param {string} path */
export const isTable = (path) => /\.(?:csv|tsv)$/i.test(path);

/** Who handed in each of these files, and whether it is that student's alone, whatever stands in it. What is no name, or that of several, has the number beside it. @param {readonly string[]} paths */
export function ownersOfFiles(paths) {
  const owners = paths.map(ownerOf);
  /** @type {Map<string, Set<string>>} */
  const numbers = new Map();
  for (const { name, number } of owners) numbers.set(name, (numbers.get(name) ?? new Set()).add(number));
  // Where all are tables, such as class_2026_11_all.csv, they are the lecturer's own.
  const isClass = owners.some(({ number }, i) => number !== '' && !isTable(paths[i]));
  return owners.map(({ name, number, isMoodle }) => ({
    name: anybody.test(name) || (numbers.get(name)?.size ?? 0) > 1 ? `${name} ${number}`.trim() : name,
    isStudents: number !== '' && (isMoodle || isClass),
  }));
}

/** @param {string} path */
export const nameOfFile = (path) => ownersOfFiles([path])[0].name;
