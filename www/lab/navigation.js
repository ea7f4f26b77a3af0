// The parts of the page: links to all, and only what belongs to the open one in sight.
import { html, nothing, render } from 'lit-html';
import { byId } from '../kit/elements.js';
import { followSize } from '../kit/size.js';
import { isEmbedded } from '../kit/host.js';
import { watch } from '../kit/memo.js';
import { lesson as lessonWords, lab as strings } from '../words/index.js';

/** Where the links have no room beside each other, the one of the open page is in sight. @param {HTMLElement} nav */
function showCurrent(nav) {
  showMore(nav);
  const link = nav.querySelector('[aria-current]');
  if (!link || nav.scrollWidth <= nav.clientWidth) return;
  const [at, all] = [link, nav].map((element) => element.getBoundingClientRect());
  nav.scrollLeft += at.left + at.width / 2 - (all.left + all.width / 2);
}

/** On which sides there are links out of sight: there the row fades. @param {HTMLElement} nav */
function showMore(nav) {
  const hidden = nav.scrollWidth - nav.clientWidth - nav.scrollLeft;
  nav.classList.toggle('more-before', nav.scrollLeft > 1);
  nav.classList.toggle('more-after', hidden > 1);
}

/** What is said of a page, and what it is laid out for. @typedef {{ name: string, purpose: (population: number) => string, room?: 'map' | 'plane' }} Named */

/** Of the window, which names first what is open. @param {string} name */
export const titleOf = (name) => `${name} · ${strings.texts.pageTitle}`;

/** Of those that name the pages they belong to. @param {Iterable<Element>} elements @param {string} page @param {string} [waiting] What is not there yet: then its place alone. */
export function showOn(elements, page, waiting) {
  for (const element of elements)
    if (element instanceof HTMLElement && element.dataset.page)
      element.hidden = waiting
        ? element.dataset.page !== waiting
        : !element.dataset.page.split(' ').includes(page);
}

/** For who comes by keyboard: over the head of the page, to what it is about. */
function showSkip() {
  const skip = byId('skip');
  skip.hidden = isEmbedded;
  skip.addEventListener('click', () => {
    const main = /** @type {HTMLElement} */ (document.querySelector('main'));
    // Not for ever: a press on the page would come to it.
    main.tabIndex = -1;
    main.addEventListener('blur', () => main.removeAttribute('tabindex'), { once: true });
    main.focus();
  });
}

/**
 * @param {readonly string[]} pages @param {Record<string, Named>} named @param {HTMLElement} nav @param {HTMLElement} tagline
 * @param {(page: string) => void} onOpen @param {() => void} onLesson
 */
export function createPages(pages, named, nav, tagline, onOpen, onLesson) {
  /** @param {string} name @param {boolean} isOpen */
  const linkTo = (name, isOpen) => {
    const onClick = (/** @type {MouseEvent} */ event) => {
      // With these keys a link opens elsewhere.
      if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
      event.preventDefault();
      if (name === 'lesson') onLesson();
      else onOpen(name);
    };
    const text = name === 'lesson' ? lessonWords.nav : named[name].name;
    return html`<a id="page-${name}" href="#${name}" aria-current=${isOpen ? 'page' : nothing} @click=${onClick}>${text}</a>`;
  };
  showSkip();
  const changed = watch();
  followSize(nav, () => showCurrent(nav));
  nav.addEventListener('scroll', () => showMore(nav), { passive: true });
  return {
    /** @param {string} open @param {number} lesson @param {number} population @param {string} [waiting] What of these is not there yet. */
    draw(open, lesson, population, waiting) {
      if (!changed(open, lesson, population, waiting)) return;
      // What it has no styles for yet stands as it stood.
      if (!waiting) {
        document.body.dataset.open = open;
        document.body.dataset.room = named[open].room ?? '';
      }
      // A step of the lesson has its own, once it is there.
      if (!lesson) document.title = titleOf(named[open].name);
      tagline.textContent = lesson ? lessonWords.tagline : named[open].purpose(population);
      const current = lesson ? 'lesson' : open;
      const links = pages.map((name) => linkTo(name, name === current));
      render(links, nav);
      // When the frame is laid out: before, that would be done twice.
      requestAnimationFrame(() => showCurrent(nav));
      // Parts are made while the page is open.
      showOn(document.querySelectorAll('[data-page]'), open, waiting);
    },
  };
}
