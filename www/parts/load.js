// A part is loaded when it is opened first: its words and its page, side by side.
/** @import { Page, Part, Tools } from './part.js' */
import { byId, create } from '../kit/elements.js';
import { fillTexts } from '../kit/texts.js';
import { opening as words } from '../words/index.js';

/**
 * What makes the page of a part, once all of it is there.
 * @template M
 * @param {Promise<{ texts: Readonly<Record<string, string>> }>[]} words @param {Promise<M>} module
 * @param {(module: M) => (tools: Tools) => Page} pick
 */
export async function partOf(words, module, pick) {
  const [page, ...all] = await Promise.all([module, ...words]);
  for (const { texts } of all) fillTexts(texts);
  return pick(page);
}

/** Begins to load the part that an address opens; whether it can be loaded is seen when it is opened. @param {readonly Part[]} parts @param {string} hash */
export const askFor = (parts, hash) =>
  parts
    .find(({ name }) => hash === `#${name}` || hash.startsWith(`#${name}&`))
    ?.load()
    .catch(() => {});

/**
 * The pages of the parts. Where one cannot be loaded, its place says so, and all others go on.
 * @param {readonly Part[]} parts @param {Tools} tools @param {() => void} onLoaded
 */
export function createParts(parts, tools, onLoaded) {
  /** @type {Map<string, Page>} */
  const pages = new Map();
  /** @type {Map<string, Promise<void>>} */
  const loading = new Map();

  /** @param {Part} part */
  async function load({ name, load }) {
    const place = createPlace(name);
    try {
      const createPage = await load();
      const page = createPage(tools);
      pages.set(name, page);
      place.fill(page.element);
      onLoaded();
    } catch (error) {
      console.warn(error);
      place.fail();
    }
  }

  return {
    /** How many are there. */
    get size() {
      return pages.size;
    },

    /** The page of a part, if it is there. @param {string} name */
    of: (name) => pages.get(name),

    /** Loads the page of a part, unless that is done or under way. Resolves when it is there or cannot be. @param {string} name */
    open(name) {
      const part = parts.find((one) => one.name === name);
      if (part && !loading.has(name)) loading.set(name, load(part));
      return loading.get(name);
    },
  };
}

/** Where the page of a part will be: it says what one waits for, or what went wrong. @param {string} name */
function createPlace(name) {
  const waits = createWaits();
  const place = create('div', '', waits.element);
  place.dataset.page = name;
  byId('evolving').before(place);
  return {
    /** @param {HTMLElement} [element] */
    fill(element) {
      if (element) {
        element.hidden = place.hidden;
        place.before(element);
      }
      place.remove();
    },
    fail: waits.fail,
  };
}

/** Says that something is being loaded, and, where it cannot be, that. */
export function createWaits() {
  const element = create('p', 'part-waits', words.waits);
  element.setAttribute('role', 'status');
  return {
    element,
    fail() {
      const again = create('button', '', words.again);
      again.setAttribute('type', 'button');
      again.addEventListener('click', loadPageAgain);
      const box = create('div', 'message part-failed', create('p', '', words.failed), again);
      box.setAttribute('role', 'alert');
      element.replaceWith(box);
    },
  };
}

/** A browser may remember that a module could not be loaded, and after a new version its file has another name: so the whole page is loaded again, but only if it can be. */
async function loadPageAgain() {
  const { ok } = await fetch(location.href, { cache: 'no-store' }).catch(() => ({ ok: false }));
  if (ok) location.reload();
}
