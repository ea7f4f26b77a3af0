// The tables of learning platforms: which columns say whose a hand-in is, and in which it stands.
/** @import { Entry } from './entries.js' */
import Papa from 'papaparse';

const names = {
  whole:
    /^(full name|name|student|student name|display name|성명|전체 이름|사용자 성명|이름|학생|nom complet|vollständiger name)$/i,
  first: /^(first name|given name|vorname|prénom)$/i,
  last: /^(surname|last name|family name|nachname|nom)$/i,
  ident:
    /^(identifier|id|id number|student id|id-nummer|email|email address|e-mail|e-mail-adresse|username|login id|sis user id|sis login id|integration id|section|학번|식별자|id 번호|이메일(?: 주소)?|전자 ?우편(?: 주소)?|아이디|사용자 이름|(?:sis )?(?:사용자|로그인|통합) ?(?:id|아이디)|섹션|분반)$/i,
};
/** What the platform or a teacher says of a submission: not of who made it, and nothing that was handed in. */
const aboutIt =
  /^(?:status|grade|maximum grade|grade can be changed|last modified\b.*|(?:채점 |표시 진행 )?상태|(?:최대 |최고 )?성적|마지막 수정됨.*|bewertung(?: kann geändert werden)?|bestwertung|zuletzt geändert .*)$|\bfeedback\b|피드백|rétroaction|retroaliment|retroacci|återkoppling|zwrotn|отзыв|phản hồi|フィードバック|反馈|回饋/i;
/** By longer ones nobody is known. In characters. */
const mostOfIdent = 100;
const mostIdents = 20;

/** The column of what a student wrote: a row without a hand-in says how that begins. */
const written =
  /^(online text|submission text|text|온라인 ?텍스트|texte en ligne|texteingabe online|texto en línea|texto online|testo online|オンラインテキスト|在线文本|線上文字)$/i;

/** Without long runs of white space: Papa looks through what stands before a comma or a line's end anew from each quote before it. Where lines end, and what the next one begins with, stays. @param {string} text */
const withoutRuns = (text) =>
  text.replace(/(?<!\s)\s{200,}/g, (run) => {
    const [end] = /\r?\n|\r/.exec(run) ?? [''];
    const next = run.replace(/^.*[\r\n]/s, '').replace(/[^\S\t]+/g, ' ');
    return end + next.slice(-99);
  });

/** A table with a head, if it is one. @param {string} text @param {(cell: string) => boolean} hasLink */
export function tableIn(text, hasLink) {
  // A mark that some programs put before a text.
  const whole = withoutRuns(text.replace(/^\ufeff/, ''));
  const first = Papa.parse(whole.slice(0, 100_000), { preview: 2, skipEmptyLines: 'greedy' });
  const [head, next] = /** @type {string[][]} */ (first.data);
  if (!head || !next || head.length < 2 || next.length < head.length - 1 || head.some(hasLink)) return null;
  const isName = (/** @type {string} */ cell) => Object.values(names).some((name) => name.test(cell.trim()));
  // “Name, Kim” before a link is no head.
  if (!head.some((cell, i) => isName(cell) && !hasLink(next[i] ?? ''))) return null;
  const [columns, ...rows] = /** @type {string[][]} */ (Papa.parse(whole, { skipEmptyLines: 'greedy' }).data);
  return { columns: columns.map((column) => column.trim()), rows };
}

/** Which columns say what. Whatever is not what a student wrote may be that by which the platform knows its students. @param {readonly string[]} columns @param {readonly (readonly string[])[]} rows @param {(cell: string) => boolean} hasLink */
export function partsOf(columns, rows, hasLink) {
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
export function fromRow({ columns, named, texts, idents }, row, entryOf) {
  const [whole, first, last] = named.map((i) => row[i]?.trim() ?? '');
  const ident = Object.fromEntries(idents.map((i) => [columns[i], row[i] ?? '']));
  const text = texts.map((i) => row[i] ?? '').join('\n');
  const name = whole || [first, last].filter(Boolean).join(' ');
  return { ...entryOf(text, name, ident), isOnes: name !== '' };
}
