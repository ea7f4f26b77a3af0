// What was handed in, found in whatever a learning platform gives: tables, online texts with their HTML, files, links. Nothing is
// believed here, and nothing of it becomes markup.
/** @import { Whose } from './owners.js' */
import { createTurns } from '../../kit/loop.js';
import { tidyText } from '../../kit/text.js';
import { mark } from '../handin/mark.js';
import { fromRow, partsOf, tableIn } from './columns.js';
import { isTable, ownerOf, ownersOfFiles } from './owners.js';

/** One hand-in: who it is from as the platform says, how the platform knows them (column by column), a beginning of the text, and its link, or why there is none. @typedef {{ name: string, ident: Readonly<Record<string, string>>, text: string, link: string | null, why: 'none' | 'long' | 'more' | 'bytes' | null, isReceipt: boolean, isOnes: boolean }} Entry `isReceipt`: it says that it is one; `isOnes`: it stands in a file of this student's, or in a row with this name. */

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

/** A document, a zip or a picture: its bytes say nothing. @param {string} text */
const isNoText = (text) => /^%PDF-|(?!\s)\p{Cc}/u.test(text.slice(0, 100));

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

  /** That of an exercise in a frame's line, or before what ends a sentence; what is typed otherwise may hold what no link of the page has. @param {string} asked */
  function exerciseIn(asked) {
    const link = linkIn(asked);
    if (link === null) return asked;
    const [, ...behind] = asked.split(link);
    const isAlone = behind.length > 0 && /^[^\p{L}\p{N}_%]*$/u.test(behind.join());
    return isAlone || asked.startsWith('<') ? link : asked;
  }

  return { linksIn, linkIn, hasLink, holdsSeveral, exerciseIn };
}

/** @param {(text: string) => string | null} linkIn */
function createEntries(linkIn) {
  /** @param {string} text @param {string} name @param {Entry['ident']} [ident] @returns {Entry} */
  return (text, name, ident = {}) => {
    const said = beginning(saidIn(text.slice(0, 2000)));
    const about = {
      name: tidyText(name).slice(0, mostOfName),
      ident,
      text: said,
      isReceipt: text.includes(mark),
      isOnes: false,
    };
    /** @param {Entry['why']} why @returns {Entry} */
    const without = (why) => ({
      ...about,
      link: null,
      why: isNoText(text) ? 'bytes' : why,
    });
    if (text.length > mostOfOne) return without('long');
    const link = linkIn(text);
    if (link === null) return without('none');
    return link.length > mostOfLink ? without('long') : { ...about, link, why: null };
  };
}

/** @param {readonly Entry[]} entries @param {Entry['ident']} ident */
const asOnes = (entries, ident) => entries.map((entry) => ({ ...entry, ident, isOnes: true }));

/** @param {readonly string[]} pages */
export function createReader(pages) {
  const { linksIn, linkIn, hasLink, holdsSeveral, exerciseIn } = createFinder(pages);

  const entryOf = createEntries(linkIn);

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
    exerciseIn,

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

    /** A file is one hand-in, unless it is a table or holds several; who those are from, its name says only where they are one student's. @param {string} path @param {string} text @param {Whose} [whose] @returns {Promise<Entry[]>} */
    async readFile(path, text, { name, ident, isStudents } = ownersOfFiles([path])[0]) {
      if (isStudents)
        return asOnes(
          countOf(text, mark) > 1 ? await fromLines(text, name, true) : [entryOf(text, name)],
          ident,
        );
      if (!isTable(path) && !holdsSeveral(text)) return [entryOf(text, name)];
      const entries = await this.read(text);
      const whos = new Set(entries.map(({ link }) => link && whoIn(link)).filter(Boolean));
      const isOnes = ownerOf(path).number !== '' || entries.length === 1 || whos.size === 1;
      return entries.map((entry) => ({ ...entry, name: entry.name || (isOnes ? name : '') }));
    },

    /** @param {Pick<Whose, 'name' | 'ident'>} whose @returns {Entry} */
    tooLong: ({ name, ident }) => ({ ...unread, name, ident, why: 'long' }),
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
