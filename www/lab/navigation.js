// The parts of the page: links to all, and only what belongs to the open one in sight.
import { watch } from '../kit/memo.js';
import { lesson as lessonWords, lab as strings } from '../words/index.js';

/**
 * @param {readonly string[]} pages @param {HTMLElement} nav @param {HTMLElement} tagline @param {NodeListOf<HTMLElement>} parts Each names the pages it belongs to.
 * @param {(page: string) => void} onOpen @param {() => void} onLesson
 */
export function createPages(pages, nav, tagline, parts, onOpen, onLesson) {
  const links = ['lesson', ...pages].map((name) => {
    const link = document.createElement('a');
    const text = name === 'lesson' ? lessonWords.nav : strings.pages[name];
    Object.assign(link, { id: `page-${name}`, href: `#${name}`, textContent: text });
    link.addEventListener('click', (event) => {
      // With these keys a link opens elsewhere.
      if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
      event.preventDefault();
      if (name === 'lesson') onLesson();
      else onOpen(name);
    });
    return { name, link };
  });
  nav.replaceChildren(...links.map(({ link }) => link));
  const changed = watch();
  return {
    /** @param {string} open @param {number} lesson @param {number} population */
    draw(open, lesson, population) {
      if (!changed(open, lesson, population)) return;
      document.body.dataset.open = open;
      tagline.textContent = lesson ? lessonWords.tagline : strings.taglines(population)[open];
      for (const { name, link } of links) {
        if (name === (lesson ? 'lesson' : open)) link.setAttribute('aria-current', 'page');
        else link.removeAttribute('aria-current');
      }
      for (const part of parts) part.hidden = !part.dataset.page?.split(' ').includes(open);
    },
  };
}
