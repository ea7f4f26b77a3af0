// The text of the lesson: paragraphs with *what matters*, {symbols}, {=values of the running program} and [words](that open a part).
import { create } from '../elements.js';
import { isSymbol, symbolInText } from './symbols.js';

const marks = /\*([^*]+)\*|\{(=?)(\w+)\}|\[([^\]]+)\]\(([^)]+)\)/g;

/**
 * @param {string} text @param {(link: string) => string} hrefOf
 * @returns {(Node | string)[]}
 */
export function inline(text, hrefOf) {
  /** @type {(Node | string)[]} */
  const nodes = [];
  let end = 0;
  for (const match of text.matchAll(marks)) {
    const [whole, strong, live, name, words, link] = match;
    nodes.push(text.slice(end, match.index));
    end = match.index + whole.length;
    if (strong) nodes.push(create('strong', '', ...inline(strong, hrefOf)));
    else if (words) nodes.push(Object.assign(create('a', '', words), { href: hrefOf(link) }));
    else if (live) {
      const value = create('span', 'live', '–');
      value.dataset.value = name;
      nodes.push(value);
    } else if (isSymbol(name)) nodes.push(symbolInText(name));
    else throw new Error(`lesson: {${name}} is no symbol`);
  }
  nodes.push(text.slice(end));
  return nodes;
}

/** Paragraphs, with an empty line between them. @param {string} text @param {(link: string) => string} hrefOf */
export const paragraphs = (text, hrefOf) =>
  text.split('\n\n').map((paragraph) => create('p', '', ...inline(paragraph, hrefOf)));

/** A list. @param {readonly string[]} texts @param {(link: string) => string} hrefOf */
export const list = (texts, hrefOf) =>
  create('ul', 'prose-list', ...texts.map((text) => create('li', '', ...inline(text, hrefOf))));
