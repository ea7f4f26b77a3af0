// What was handed in, found in whatever a learning platform gives: tables, online texts with their HTML, files, links. Nothing is
// believed here, and nothing of it becomes markup.
import Papa from 'papaparse';
import { createTurns } from '../../kit/loop.js';
import { mostCharacters } from '../../link/link.js';
import { mark } from '../handin/mark.js';

/** One hand-in: who it is from as the platform says, how the platform knows them (column by column), a beginning of the text, and its link, or why there is none. @typedef {{ name: string, ident: Readonly<Record<string, string>>, text: string, link: string | null, why: 'none' | 'long' | null, isReceipt: boolean }} Entry `isReceipt`: it says that it is one. */

/** In characters. */
export const mostOfAll = 12_000_000;
const mostOfOne = 200_000;
const mostOfName = 80;
/** So many are checked at once; the others are only counted. */
export const mostEntries = 5000;
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

/** @param {string} text */
const beginning = (text) => text.replace(/\s+/g, ' ').trim().slice(0, 80);

/** A receipt to its last digits, without what a text has behind them; null if they are not there. @param {string} link */
function wholeIn(link) {
  const at = link.indexOf('handin=');
  const end = at < 0 ? null : /(?:~|%7E)[\da-f]{8}(?!~|%7E)/i.exec(link.slice(at));
  return end && link.slice(0, at + end.index + end[0].length);
}

/** A line that ends with the digits of a receipt. @param {string} line */
const endsReceipt = (line) => /^handin=\S*~[\da-f]{8}$/.test(line.slice(line.lastIndexOf('handin=')));

/** Links of these pages. @param {readonly string[]} pages */
function createFinder(pages) {
  const pattern = new RegExp(`(?<![\\w%])(?:${pages.join('|')})&(?:amp;)*[\\w.]+=[^\\s"<>\\\\^\`{}|]*`, 'g');

  /** @param {string} text */
  const linksIn = (text) => withoutEntities(withoutEntities(text)).match(pattern) ?? [];

  /** The one that counts: a receipt before others, and of several the last. @param {string} text */
  function linkIn(text) {
    const found = linksIn(text);
    const receipts = found.filter((link) => link.includes('handin='));
    const whole = receipts.map(wholeIn).filter((link) => link !== null);
    if (whole.length > 0) return whole[whole.length - 1];
    // One that was broken into lines.
    const joined = found.length > 0 && text.includes(mark) ? linksIn(text.replace(/[\s>]+/g, '')) : [];
    return joined.map(wholeIn).find(Boolean) ?? receipts.at(-1) ?? found.at(-1) ?? null;
  }

  return { linksIn, linkIn };
}

/** @param {readonly string[]} pages */
export function createReader(pages) {
  const { linksIn, linkIn } = createFinder(pages);

  /** @param {string} text @param {string} name @param {Entry['ident']} [ident] @returns {Entry} */
  function entryOf(text, name, ident = {}) {
    const said = beginning(saidIn(text.slice(0, 2000)));
    const about = { name: name.slice(0, mostOfName), ident, text: said, isReceipt: text.includes(mark) };
    if (text.length > mostOfOne) return { ...about, link: null, why: 'long' };
    const link = linkIn(text);
    if (link === null) return { ...about, link, why: 'none' };
    return link.length > mostCharacters
      ? { ...about, link: null, why: 'long' }
      : { ...about, link, why: null };
  }

  /** Lines, of which each is a hand-in but for those of a receipt, which ends with its link. @param {string} text @param {string} name @returns {Promise<Entry[]>} */
  async function fromLines(text, name) {
    const isHtml = /<\/?(?:p|div|br|a|span|li|td|html|body|img|script)\b/i.test(text);
    if (isHtml && new Set(linksIn(text)).size < 2) return [entryOf(text, name)];
    const withLinks = text.replace(/<a\b[^<>]*>/gi, (tag) => ` ${hrefIn(tag)} `);
    const lines = (isHtml ? saidIn(withLinks) : text).split(/\r?\n/).map((line) => line.trim());
    /** @type {Entry[]} */
    const entries = [];
    const add = (/** @type {string} */ one, /** @type {string} */ whose) =>
      entries.push(entries.length < mostEntries ? entryOf(one, whose) : unread);
    /** @type {string[]} */
    let receipt = [];
    const end = () => {
      if (receipt.length > 0) add(receipt.join('\n'), name);
      receipt = [];
    };
    const turn = createTurns(slice);
    for (const line of lines) {
      await turn();
      if (line.includes(mark)) end();
      if (receipt.length > 0 || line.includes(mark)) {
        receipt.push(line);
        // What may still be of it: a link that was broken into lines.
        if (endsReceipt(line) || (line === '' && receipt.length > 3)) end();
      } else if (line !== '') add(line, name || nameBefore(line));
    }
    end();
    return entries;
  }

  return {
    /** @param {string} text @returns {Promise<Entry[]>} */
    async read(text) {
      const hasLink = (/** @type {string} */ cell) => linksIn(cell).length > 0;
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

    /** A file is one hand-in, unless it is a table or holds several. @param {string} path @param {string} text @param {string} [name] @returns {Promise<Entry[]>} */
    async readFile(path, text, name = nameOfFile(path)) {
      if (/\.(?:csv|tsv)$/i.test(path))
        return (await this.read(text)).map((entry) => ({ ...entry, name: entry.name || name }));
      if (text.length > mostOfOne) return [entryOf(text, name)];
      const marks = text.split(mark).length - 1;
      return marks > 1 ? fromLines(text, name) : [entryOf(text, name)];
    },

    /** @param {string} name @returns {Entry} */
    tooLong: (name) => ({ ...unread, name, why: 'long' }),
  };
}

/** The name in a line such as “Kim, https://…”. @param {string} line */
function nameBefore(line) {
  const [before] = line.split(/https?:|file:|#|(?:^|\s)[\w-]+\.html/, 1);
  return before.length < line.length
    ? before
        .slice(0, mostOfName)
        .replace(/[\s,;:|\t]+$/, '')
        .replace(/^["']/, '')
    : '';
}

/** Whose it is in anonymous submissions of Moodle: nobody's name. */
const anybody = /^(?:participant|참가자|참여자)$/i;

/** Moodle names folders and files of submissions `Name_12345_assignsubmission_…`, Canvas `name_12345_67890_file`, and what was typed there `name_12345_text`: the first number is the student's. @param {string} path */
function ownerOf(path) {
  const parts = path.split('/');
  const moodle = parts.map((part) => /^(.+?)_(\d+)_assignsubmission_/.exec(part)).find(Boolean);
  const file = parts[parts.length - 1].replace(/\.\w+$/, '');
  const canvas = /^(\D+?)_(?:LATE_)?(\d+)_(?:\d+_|(?:text|link)$)/.exec(file);
  const [, name, number] = moodle ?? canvas ?? ['', file, ''];
  return { name, number };
}

/** Who handed in each of these files. What is no name, or that of several, has the number beside it. @param {readonly string[]} paths */
export function namesOfFiles(paths) {
  const owners = paths.map(ownerOf);
  /** @type {Map<string, Set<string>>} */
  const numbers = new Map();
  for (const { name, number } of owners) numbers.set(name, (numbers.get(name) ?? new Set()).add(number));
  return owners.map(({ name, number }) =>
    anybody.test(name) || (numbers.get(name)?.size ?? 0) > 1 ? `${name} ${number}`.trim() : name,
  );
}

/** @param {string} path */
export const nameOfFile = (path) => namesOfFiles([path])[0];

const names = {
  whole:
    /^(full name|name|student|student name|display name|성명|이름|학생|nom complet|vollständiger name)$/i,
  first: /^(first name|given name|vorname|prénom)$/i,
  last: /^(surname|last name|family name|nachname|nom)$/i,
  ident:
    /^(identifier|id|id number|student id|email|email address|e-mail|username|login id|sis user id|sis login id|integration id|section|학번|이메일|아이디|사용자 이름)$/i,
};
/** What the platform or a teacher says of a submission: not of who made it, and nothing that was handed in. */
const aboutIt =
  /^(?:status|grade|maximum grade|grade can be changed|last modified\b.*|상태|성적)$|\bfeedback\b|피드백|rétroaction|retroaliment|retroacci|återkoppling|zwrotn|отзыв|phản hồi|フィードバック|反馈|回饋/i;
/** By longer ones nobody is known. In characters. */
const mostOfIdent = 100;
const mostIdents = 20;

/** The column of what a student wrote: a row without a hand-in says how that begins. */
const written =
  /^(online text|submission text|text|온라인 ?텍스트|texte en ligne|texteingabe online|texto en línea|texto online|testo online|オンラインテキスト|在线文本|線上文字)$/i;

/** A table with a head, if it is one. @param {string} text @param {(cell: string) => boolean} hasLink */
function tableIn(text, hasLink) {
  // A mark that some programs put before a text.
  const whole = text.replace(/^\ufeff/, '');
  const first = Papa.parse(whole.slice(0, 100_000), { preview: 2, skipEmptyLines: 'greedy' });
  const [head, next] = /** @type {string[][]} */ (first.data);
  if (!head || !next || head.length < 2 || next.length < head.length - 1 || head.some(hasLink)) return null;
  if (!head.some((cell) => Object.values(names).some((name) => name.test(cell.trim())))) return null;
  const [columns, ...rows] = /** @type {string[][]} */ (Papa.parse(whole, { skipEmptyLines: 'greedy' }).data);
  return { columns: columns.map((column) => column.trim()), rows };
}

/** Which columns say what. Whatever is not what a student wrote may be that by which the platform knows its students. @param {readonly string[]} columns @param {readonly (readonly string[])[]} rows @param {(cell: string) => boolean} hasLink */
function partsOf(columns, rows, hasLink) {
  const of = (/** @type {RegExp} */ name) => columns.findIndex((column) => name.test(column));
  const named = [of(names.whole), of(names.first), of(names.last)];
  const known = columns.map((_, i) => i).filter((i) => !named.includes(i) && !aboutIt.test(columns[i]));
  const isIdent = (/** @type {number} */ i) => names.ident.test(columns[i]);
  const longs = known.filter((i) => !isIdent(i) && rows.some((row) => isLong(row[i] ?? '', hasLink)));
  const own = known.filter((i) => written.test(columns[i]));
  // Where students wrote, what stands elsewhere may be another's.
  const isThere = rows.some((row) => own.some((i) => hasLink(row[i] ?? '')));
  const texts = isThere ? own : [...new Set([...own, ...longs])];
  const idents = known.filter((i) => !own.includes(i) && !longs.includes(i) && columns[i] !== '');
  return {
    columns,
    named,
    // A row without a hand-in says what else stands in it.
    texts: [...texts, ...idents.filter((i) => !isIdent(i))],
    idents: idents.slice(0, mostIdents),
  };
}

/** By this nobody is known. @param {string} cell @param {(cell: string) => boolean} hasLink */
const isLong = (cell, hasLink) => cell.length > mostOfIdent || (cell.includes('&') && hasLink(cell));

/** @param {ReturnType<typeof partsOf>} parts @param {readonly string[]} row @param {(text: string, name: string, ident: Entry['ident']) => Entry} entryOf */
function fromRow({ columns, named, texts, idents }, row, entryOf) {
  const [whole, first, last] = named.map((i) => row[i]?.trim() ?? '');
  const ident = Object.fromEntries(idents.map((i) => [columns[i], row[i] ?? '']));
  const text = texts.map((i) => row[i] ?? '').join('\n');
  return entryOf(text, whole || [first, last].filter(Boolean).join(' '), ident);
}
