// Who turns a telephone or a tablet goes on reading where they were: the words are then laid out anew, under the figure or beside it.
import { isSeen } from '../kit/elements.js';

/** What is read as one. */
const pieces = 'p, li, h2, h3, tr, button, .formula';
/** Of a line of words. */
const halfHeight = 12;
/** So many frames after the last in which something scrolled, or the window had another size. */
const rest = 6;

/** @param {HTMLElement} article */
export function keepPlaceInTurning(article) {
  /** What stands first, which share of it is above the words in sight, or how far below their top it begins. @type {{ piece: Element, share: number, gap: number } | null} */
  let place = null;
  let width = innerWidth;
  let isTurning = false;
  /** Frames until the place is noted, or gone back to. */
  let left = 0;

  /** Where in the window words are seen first: the head of the page or the figure may lie over them. */
  function topOfWords() {
    const box = article.getBoundingClientRect();
    for (let y = 0; y < innerHeight; y += halfHeight)
      if (article.contains(document.elementFromPoint(box.left + box.width / 2, y))) return y;
    return null;
  }

  function note() {
    const top = topOfWords();
    if (top === null) return;
    const all = [...article.querySelectorAll(pieces)];
    const piece = all.find((one) => one.getBoundingClientRect().bottom > top + 1);
    place = null;
    if (!piece || scrollY === 0) return;
    const box = piece.getBoundingClientRect();
    const gap = Math.max(0, box.top - top);
    place = { piece, gap, share: gap > 0 ? 0 : (top - box.top) / box.height };
  }

  function goBack() {
    // Under a sheet nothing is found.
    const sheet = document.querySelector('dialog[open]');
    if (sheet) return sheet.addEventListener('close', goBack, { once: true });
    isTurning = false;
    // Only after the first time the head is where it will be.
    for (let time = 0; time < 2; time += 1) {
      const top = topOfWords();
      if (!place || !isSeen(place.piece) || top === null) return;
      const box = place.piece.getBoundingClientRect();
      scrollBy({ top: box.top + place.share * box.height - place.gap - top, behavior: 'instant' });
    }
  }

  function wait() {
    left -= 1;
    if (left > 0) requestAnimationFrame(wait);
    else if (isTurning) goBack();
    else note();
  }
  const begin = () => {
    if (left === 0) requestAnimationFrame(wait);
    left = rest;
  };

  // A browser that lays the page out anew scrolls by itself.
  addEventListener('scroll', () => isTurning || begin(), { passive: true });
  addEventListener('resize', () => {
    // The height alone changes when a bar of the browser comes or goes.
    if (innerWidth === width && !isTurning) return;
    width = innerWidth;
    isTurning = true;
    begin();
  });
}
