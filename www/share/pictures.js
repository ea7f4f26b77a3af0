// The pictures that are on screen: elements of the page with the same data-picture are one picture.
/** @import { Drawing } from './marks.js' */
import { marksOf } from './screen.js';
import words from './words/index.js';

/** @typedef {{ key: string, name: string, drawn: string, elements: HTMLElement[] }} Picture `drawn`: what of it, where it can be one thing or another. */

/** Pixels of paper around. */
const margin = 12;
/** Pixels between its parts. */
const widestGap = 24;

/** @returns {Picture[]} */
export function picturesOnScreen() {
  /** @type {Map<string, Picture>} */
  const found = new Map();
  for (const element of /** @type {NodeListOf<HTMLElement>} */ (
    document.querySelectorAll('[data-picture]')
  )) {
    const seen = boxesOf(element).filter(isSeen);
    if (seen.length === 0) continue;
    const { picture: key = '', name, drawn } = element.dataset;
    const before = found.get(key) ?? { key, name: words.pictures[key], drawn: '', elements: [] };
    found.set(key, {
      key,
      name: name ?? before.name,
      drawn: drawn ?? before.drawn,
      elements: [...before.elements, ...seen],
    });
  }
  return [...found.values()];
}

/** What stands in its place, where it has no box of its own. @param {HTMLElement} element @returns {HTMLElement[]} */
const boxesOf = (element) =>
  getComputedStyle(element).display === 'contents'
    ? [...element.children].flatMap((child) => boxesOf(/** @type {HTMLElement} */ (child)))
    : [element];

const isSeen = (/** @type {HTMLElement} */ element) => {
  const { width, height } = element.getBoundingClientRect();
  return width > 0 && height > 0;
};

/** What the picture shows now. @param {Picture} picture @returns {Drawing} */
export function drawingOf({ elements }) {
  const pieces = stacked(elements);
  const boxes = pieces.map(({ box }) => box);
  const x = Math.min(...boxes.map(({ left }) => left)) - margin;
  const y = Math.min(...pieces.map(({ top }) => top)) - margin;
  return {
    width: Math.ceil(Math.max(...boxes.map(({ right }) => right)) + margin - x),
    height: Math.ceil(Math.max(...pieces.map(({ top, box }) => top + box.height)) + margin - y),
    paper: getComputedStyle(document.body).backgroundColor,
    marks: pieces.flatMap(({ element, box, top }) => marksOf(element, { x, y: y + box.top - top, alpha: 1 })),
  };
}

/** The elements from the top; where other things stand between them, they move together. @param {HTMLElement[]} elements */
function stacked(elements) {
  const boxes = elements.map((element) => ({ element, box: element.getBoundingClientRect() }));
  let bottom = Math.min(...boxes.map(({ box }) => box.top));
  let closed = 0;
  return boxes
    .sort((a, b) => a.box.top - b.box.top)
    .map(({ element, box }) => {
      closed += Math.max(0, box.top - closed - bottom - widestGap);
      const top = box.top - closed;
      bottom = Math.max(bottom, top + box.height);
      return { element, box, top };
    });
}

/** What the page says of a picture to those who cannot see it. @param {Picture} picture */
export function descriptionOf({ elements }) {
  const described = elements.flatMap((element) => [
    element,
    ...element.querySelectorAll('[role], [aria-describedby]'),
  ]);
  const ids = described.flatMap((element) => element.getAttribute('aria-describedby')?.split(' ') ?? []);
  return [
    ...described.flatMap((element) => element.getAttribute('aria-label') ?? []),
    ...ids.map((id) => document.getElementById(id)?.textContent ?? ''),
  ]
    .map((text) => text.trim())
    .filter(Boolean)
    .join(' ');
}
