// The text of the lesson: paragraphs with *what matters*, {symbols}, {=values of the running program} and [words](that open a part).
import { create } from '../kit/elements.js';
import { isSymbol, symbolInText } from './formulas/symbols.js';

const marks = /\*([^*]+)\*|\{(=?)(\w+)\}|\[([^\]]+)\]\(([^)]+)\)/g;

/** What is read as one stays on one line: a number and its unit, a word and its number, an equation. @param {string} text */
const tied = (text) =>
  text
    .replace(/(?<=[\d}]) (?=(?:m|s|cm|ms|rad|%|m\/s|rad\/s)(?![A-Za-z]))/g, '\u00a0')
    .replace(/(?<=Theorem|Figure|step|Step|generation|Generation|seed|Seed|정리|그림|시드) (?=\d)/g, '\u00a0')
    .replace(/(?<=[}σ]) = (?=[−\d{])/g, '\u00a0=\u00a0')
    // A posture, and a Korean number before what it counts.
    .replace(/(?<=\d(?:\u00a0m)?,) (?=−?\d+(?:\u00a0m\b|°))/g, '\u00a0')
    .replace(/(?<=여섯|스무|백|몇) (?=대)/g, '\u00a0')
    // A Korean particle and what it belongs to.
    .replace(/(?<=[)”°}%]\*?)(?=[가-힣])/g, '\u2060')
    .replace(/(?<=[가-힣]\*?)(?=\()/g, '\u2060')
    // A word of two parts.
    .replace(/(?<=\b(?:CMA|[Ss]elf|log)-)(?=[A-Za-z])/g, '\u2060');

/**
 * @param {string} text @param {(link: string) => string} hrefOf
 * @returns {(Node | string)[]}
 */
export function inline(text, hrefOf) {
  /** @type {(Node | string)[]} */
  const nodes = [];
  let end = 0;
  const joined = tied(text);
  /** A symbol stays on the line of what opens a bracket around it, or of its sine. @param {Node} symbol */
  const addSymbol = (symbol) => {
    const before = String(nodes.pop() ?? '');
    const [open] = /(?:\(|\b(?:sin|cos) )$/.exec(before) ?? [''];
    nodes.push(before.slice(0, before.length - open.length));
    nodes.push(open ? create('span', 'on-one-line', open, symbol) : symbol);
  };
  /** And so does what follows it without a space that breaks, a comma or a Korean particle. @param {string} words */
  const add = (words) => {
    const last = nodes[nodes.length - 1];
    const [close] = (last instanceof Element &&
      last.matches('math, .on-one-line') &&
      /^[^ \n]+/.exec(words)) || [''];
    if (close) nodes.push(create('span', 'on-one-line', /** @type {Node} */ (nodes.pop()), close));
    nodes.push(words.slice(close.length));
  };
  for (const match of joined.matchAll(marks)) {
    const [whole, strong, live, name, words, link] = match;
    add(joined.slice(end, match.index));
    end = match.index + whole.length;
    if (strong) nodes.push(create('strong', '', ...inline(strong, hrefOf)));
    else if (words) nodes.push(create('a', { href: hrefOf(link) }, words));
    else if (live) nodes.push(create('span', { class: 'live', 'data-value': name }, '–'));
    else if (isSymbol(name)) addSymbol(symbolInText(name));
    else throw new Error(`lesson: {${name}} is no symbol`);
  }
  add(joined.slice(end));
  return nodes;
}

/** Paragraphs, with an empty line between them. @param {string} text @param {(link: string) => string} hrefOf */
export const paragraphs = (text, hrefOf) =>
  text.split('\n\n').map((paragraph) => create('p', '', ...inline(paragraph, hrefOf)));

/** A list. @param {readonly string[]} texts @param {(link: string) => string} hrefOf */
export const list = (texts, hrefOf) =>
  create('ul', 'prose-list', ...texts.map((text) => create('li', '', ...inline(text, hrefOf))));
