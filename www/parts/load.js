// A part is loaded when it is opened first: its words, and after them its page, which finds them there (words/pick.js).
/** @import { Page, Part, Tools } from './part.js' */
import { byId } from '../kit/elements.js';
import { pause } from '../kit/loop.js';
import { rememberEach } from '../kit/memo.js';
import { createWaiting } from '../lab/waiting.js';
import { afterWords } from '../words/pick.js';

/** What makes the page of a part, once all of it is there. @param {readonly (() => Promise<unknown>)[]} words @param {() => Promise<{ createPage: (tools: Tools) => Page | Promise<Page> }>} module */
export async function makerFrom(words, module) {
  const { createPage } = await afterWords(words, module);
  return createPage;
}

const makerOf = rememberEach((/** @type {Part} */ part) => part.load());

/** Begins to load the part that an address opens; whether it can be loaded is seen when it is opened. @param {readonly Part[]} parts @param {string} hash */
export function askFor(parts, hash) {
  const part = parts.find(({ name }) => hash === `#${name}` || hash.startsWith(`#${name}&`));
  if (part) makerOf(part).catch(() => {});
}

/**
 * The pages of the parts. Where one cannot be loaded, its place says so, and all others go on.
 * @param {readonly Part[]} parts @param {Tools} tools @param {() => void} onLoaded
 */
export function createParts(parts, tools, onLoaded) {
  /** @type {Map<string, Page>} */
  const pages = new Map();
  /** @type {Map<string, Promise<void>>} */
  const loading = new Map();
  /** @type {Map<string, Place>} */
  const waiting = new Map();
  let opened = '';

  /** @param {Part} part */
  async function load(part) {
    const { name } = part;
    const place = createPlace(name, () => tools.store.redraw());
    waiting.set(name, place);
    try {
      const createPage = await makerOf(part);
      // Its file has just been read: both at once would hold the browser for long.
      await pause();
      const page = await createPage(tools);
      pages.set(name, page);
      waiting.delete(name);
      place.fill(page.element);
      onLoaded();
    } catch (error) {
      place.fail(error);
    }
  }

  return {
    /** How many are there. */
    get size() {
      return pages.size;
    },

    /** The page of a part, if it is there. @param {string} name */
    of: (name) => pages.get(name),

    /** Where a part will be that has been asked for and is not there. @param {string} name */
    waiting: (name) => waiting.get(name),

    /** Loads the page of a part, unless that is done or under way. Resolves when it is there or cannot be. @param {string} name */
    open(name) {
      if (name !== opened) pages.get(name)?.retry?.();
      opened = name;
      const part = parts.find((one) => one.name === name);
      if (part && !loading.has(name)) loading.set(name, load(part));
      return loading.get(name);
    },
  };
}

/** @typedef {ReturnType<typeof createPlace>} Place */

/** As long as this what was open stays: most often all is there by then, and nothing has moved meanwhile. */
export const unnoticed = 400;

/** So long the first picture waits for what is open: a file that never comes holds nothing else back. */
export const longest = 5000;

/** Where the page of a part, or the lesson, will be: it says what one waits for, or what went wrong. @param {string} name @param {() => void} onLate @param {string} [note] What else is said then. */
export function createPlace(name, onLate, note) {
  const { element, end, fail } = createWaiting(note);
  const tell = () => {
    place.isLate = true;
    onLate();
  };
  const timer = setTimeout(tell, unnoticed);
  element.dataset.page = name;
  element.hidden = true;
  // What an exercise hides stands nowhere: this does.
  byId('cost').after(element);
  const place = {
    name,
    isLate: false,
    /** @param {unknown} error */
    fail(error) {
      fail(error);
      tell();
    },
    /** @param {HTMLElement} [page] */
    fill(page) {
      clearTimeout(timer);
      end();
      if (page) {
        page.hidden = element.hidden;
        element.before(page);
      }
      element.remove();
    },
  };
  return place;
}
