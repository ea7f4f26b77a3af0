// The page as a figure in a frame of another page: its foot, the height it asks for, and what it says to its host.
/** @import { State } from '../run/state.js' */
import { byId, create, svg, write } from '../kit/elements.js';
import { asksSomething, noExercise } from '../run/exercise.js';
import { caughtUp } from '../run/state.js';
import { watch } from '../kit/memo.js';
import { embed as words, texts } from '../words/index.js';
import { addressOf, isHeldByElement } from '../kit/host.js';
import { version, wantedHeight } from './frame.js';
import { listen, post } from './post.js';
import { createMessages } from './messages.js';

/** What is handed in: the receipt, with what it comes to where it is judged, the address that opens it, and its text. @typedef {{ receipt: { who: string, exercise: string, gains: readonly number[], there: { cost: number, parked: number, starts: number }, drives: number, minutes: number, judged: { isMet: boolean, points: number | null, most: number | null } | null }, address: string, text: string }} HandedIn */
/** @typedef {Parameters<typeof createMessages>[0] & { shapes: Parameters<typeof wantedHeight>[0] }} Parts `shapes` of the parts of the page. */

/** No bar that scrolls is wider, in pixels of a page that is shown at half its size. */
const widestBar = 35;
const notAsked = { width: 0, height: 0 };

/** @param {Parts} parts */
export function createEmbed(parts) {
  const { engine, store, links, shapes } = parts;
  const messages = createMessages(parts, (message) => post({ ep: version, ...message }));
  // The whole page is one in which nothing is locked.
  const wholeLink = () => links.linkOf({ ...caughtUp(store.get()), exercise: noExercise }, engine.experiment);
  const foot = createFoot(() => addressOf(location.href, wholeLink(), false));
  const linkChanged = watch();
  const shapeChanged = watch();
  const heightChanged = watch();

  document.body.append(foot.element);
  listen(messages.hear);

  // Nothing is said before it can be spoken to.
  let hasBegun = false;
  /** For its picture. */
  let asked = notAsked;
  const tellHeight = () => {
    const { page, lesson } = store.get();
    if (innerWidth === 0 || !hasBegun) return;
    const task = byId('exercise');
    const wanted = wantedHeight(shapes, page, lesson, innerWidth);
    // With its height the bar comes and goes by which its host scrolls, and with that its width: the greater of two heights stands.
    if (wanted > asked.height || Math.abs(innerWidth - asked.width) > widestBar)
      asked = { width: innerWidth, height: wanted };
    const height = asked.height + (task.hidden ? 0 : task.offsetHeight + 6);
    if (!heightChanged(height)) return;
    post({ ep: version, type: 'height', height });
    // The same for Canvas, whose frames know this one.
    post({ subject: 'lti.frameResize', height });
  };
  addEventListener('resize', tellHeight);
  // What it says of an exercise comes later, and changes.
  new ResizeObserver(tellHeight).observe(byId('exercise'));

  return {
    /** Once the address is opened. @param {readonly string[]} problems What it has wrong. */
    async begin(problems) {
      const ready = messages.ready(problems);
      if (isHeldByElement) post({ ep: version, type: 'loading', hears: true });
      await ready;
      hasBegun = true;
      tellHeight();
    },

    fail: messages.fail,

    /** An exercise is handed in. @param {HandedIn} handed */
    handIn({ receipt, address, text }) {
      const { who, exercise, gains, there, drives, minutes, judged } = receipt;
      const { cost, parked, starts } = there;
      const { isMet = null, points = null, most = null } = judged ?? {};
      const result = { gains: [...gains], cost, parked, starts, drives, minutes, met: isMet, points, most };
      post({ ep: version, type: 'handin', who, exercise, link: address, text, ...result });
    },

    /** @param {State} state */
    draw(state) {
      if (shapeChanged(state.page, state.lesson, state.exercise)) {
        asked = notAsked;
        tellHeight();
        foot.name(asksSomething(state.exercise) ? words.openFree : words.openFull);
      }
      messages.announce();
      if (!state.evolving && !state.dragging && linkChanged(state.experiment, state.generation, state.page))
        foot.follow();
    },
  };
}

/** The way to the whole page, and to a larger figure. @param {() => string} fullAddress */
function createFoot(fullAddress) {
  const link = /** @type {HTMLAnchorElement} */ (create('a', '', words.openFull));
  Object.assign(link, { id: 'embed-full', target: '_blank', rel: 'noopener' });
  const follow = () => link.setAttribute('href', fullAddress());
  // What moves is written into no address: only who is about to press takes it along as it is now.
  for (const type of ['pointerdown', 'focus', 'click']) link.addEventListener(type, follow);
  const element = create('footer', 'embed-foot', create('h1', '', texts.pageTitle), link);
  if (document.fullscreenEnabled) element.append(createFullScreen());
  return { element, follow, name: (/** @type {string} */ text) => write(link, text) };
}

const icons = {
  enter: 'M2 2h5v2H4v3H2zM9 2h5v5h-2V4H9zM2 9h2v3h3v2H2zM12 9h2v5H9v-2h3z',
  leave: 'M5 2h2v5H2V5h3zM9 2h2v3h3v2H9zM2 9h5v5H5v-3H2zM9 9h5v2h-3v3H9z',
};

function createFullScreen() {
  const button = /** @type {HTMLButtonElement} */ (create('button', 'icon'));
  Object.assign(button, { type: 'button', id: 'embed-screen' });
  const path = svg('path', {});
  button.append(svg('svg', { viewBox: '0 0 16 16', width: 14, height: 14, 'aria-hidden': 'true' }, path));
  const draw = () => {
    const isFull = document.fullscreenElement !== null;
    path.setAttribute('d', isFull ? icons.leave : icons.enter);
    button.setAttribute('aria-label', isFull ? words.leaveFullScreen : words.fullScreen);
    button.title = isFull ? words.leaveFullScreen : words.fullScreen;
  };
  draw();
  document.addEventListener('fullscreenchange', draw);
  button.addEventListener('click', () => {
    // A host may forbid it, and then nothing changes.
    const done = document.fullscreenElement
      ? document.exitFullscreen()
      : document.documentElement.requestFullscreen();
    done.catch(() => {});
  });
  return button;
}
