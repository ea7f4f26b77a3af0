// Keeps the address and the state in step: the address always holds the link of what is on screen.
/** @import { Engine } from '../core/engine.js' */
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */
/** @import { Slice } from '../run/store.js' */
/** @import { Links } from './link.js' */
/** @import { Language } from '../words/language.js' */
import { canLoad, isEmbedded, leaving } from '../kit/host.js';
import { pause } from '../kit/loop.js';
import { watch } from '../kit/memo.js';
import { tidyText } from '../kit/text.js';
import { takeAlong, takeUp } from './crossing.js';
import { createLanguageSwitch } from './language-switch.js';
import { inLanguage, withExercise } from './link.js';
import { keepLeft, takeLeft, takeWork } from './reload.js';
import { isEmpty } from '../run/exercise.js';
import { asked, caughtUp, noTrial, trialIn } from '../run/state.js';
import { mostOfWho } from '../run/variant.js';
import { link as words } from '../words/index.js';
import { language, languageOfAddress } from '../words/language.js';

/** The host's “back” is not for what happens within a frame. */
const onward = isEmbedded ? 'replaceState' : 'pushState';

/** Of a browser that refuses an address, as some do after many, the page has no more than it had. @param {'replaceState' | 'pushState'} how @param {string} link */
function put(how, link) {
  try {
    history[how](null, '', `#${link}`);
    return true;
  } catch {
    return false;
  }
}

/** In milliseconds, after which a change is written: browsers refuse an address that changes more often. */
const pauses = { atRest: 400, evolving: 2000 };

/** As fast, and until when, as before the page was loaded again. @param {import('./crossing.js').Kept} kept @param {Actions} actions */
function goOnAs({ pace, until, speed, draft }, actions) {
  actions.setPace(pace);
  actions.setUntil(until.kind, String(until.value));
  actions.setSpeed(speed);
  if (!isEmpty(draft)) actions.makeExercise({ draft });
}

/** @param {{ engine: Engine, store: Store, links: Links, firstPage: string }} parts */
function createLinkTo({ engine, store, links, firstPage }) {
  const linkFor = (/** @type {State} */ state, to = language) =>
    links.linkOf(caughtUp(state), engine.experiment, to);
  /** What a press tries. @param {State} state @param {string} name */
  const trialThere = ({ page, trial, tried }, name) =>
    name === page ? trial : trialIn(links.places, name, null, tried);
  return {
    linkFor,
    /** The link of what is asked for by now. @param {string | null} written The address, which is what is being opened, if something is. */
    linkNow: (written, read = language) =>
      isOpening(store.get()) && written !== null
        ? inLanguage(written || firstPage, read)
        : linkFor(begun(store.get()), read),
    /** @param {State} state @param {string} name */
    wayTo: (state, name) =>
      name === 'lesson'
        ? withExercise(links.linkOfStep(state.lastStep), state, engine.experiment)
        : linkFor({ ...state, page: name, lesson: 0, trial: trialThere(state, name) }),
  };
}

/** @param {{ engine: Engine, store: Store, actions: Actions, links: Links, slices: readonly Slice<any>[], firstPage: string, onWrite: () => void }} parts `slices`: of all parts; `firstPage`: what is opened where an address asks for nothing. */
export function createAddress({ engine, store, actions, links, slices, firstPage, onWrite }) {
  const { linkFor, linkNow, wayTo } = createLinkTo({ engine, store, links, firstPage });
  const changed = watch();
  /** The page is about to be loaded again, and what is laid beside its address stays there; `replaced`: the address before. */
  const away = { leaves: false, replaced: '' };
  takeLeft();
  /** None where the address still tells of the run before. @type {string | null} */
  let written = location.hash.slice(1);
  /** @type {Place} */
  let place = { page: '', lesson: 0, trial: noTrial };

  const open = (asked = location.hash.slice(1)) => {
    const spoken = languageOfAddress();
    // The words are chosen when the page loads.
    if (spoken !== language) {
      const isThisRun = asked === other.pressed() || asked === linkFor(store.get(), spoken);
      speak({ store, actions, slices }, away, isThisRun, (read) => linkNow(written, read));
      return [];
    }
    written = asked;
    const { opened: run, problems } = links.openLink(asked || firstPage, engine, whoAsked());
    const { opened, newest, evolving, kept } = takeUp(takeWork(run));
    place = placeOf(opened);
    if (kept) goOnAs(kept, actions);
    actions.openLinked(opened, problems, newest, evolving);
    if (evolving && !store.get().catchingUp) actions.toggleEvolution();
    return problems;
  };

  const write = () => {
    const state = store.get();
    // Then it is asked for anew once it is due again.
    if (away.leaves || !isDue(state, place)) return changed();
    const link = linkFor(state);
    if (link === written) return;
    const isStep = isElsewhere(state, place) && written;
    // One that "back" takes back: to all that the part before has come to.
    if (isStep) put('replaceState', linkFor({ ...state, ...place }));
    const replaced = isStep ? '' : location.href;
    if (!put(isStep ? onward : 'replaceState', link)) return soon.ask('evolving');
    away.replaced = replaced;
    [written, place] = [link, placeOf(state)];
    onWrite();
  };

  const soon = createPause(write);
  const other = createLanguageSwitch((read) => linkNow(written, read));
  const lead = createWays(wayTo, [...links.pages, 'lesson'], other.follow);

  addEventListener(leaving, () => {
    put('replaceState', linkNow(written));
    crossOver(store.get(), slices);
    away.leaves = true;
  });
  addEventListener('popstate', () => location.hash.slice(1) !== written && open());
  const problems = open();
  // What has not begun, and may be what somebody flees from, is not opened again.
  keepLeft(() => (away.leaves || !isDue(store.get(), place) ? null : linkFor(store.get())), away, store.get);

  return {
    /** What was wrong with the first link, in words. */
    problems,

    /** Opens a link of this page, as if it had been followed. An exercise goes on. @param {string} link */
    go(link) {
      put('replaceState', linkNow(written));
      const next = withExercise(link, store.get(), engine.experiment);
      open(put(onward, next) ? undefined : next);
    },

    /** A run that is opened from elsewhere takes the place of this one: a step that "back" takes back. @param {Place} next */
    keepPlace(next) {
      put('replaceState', linkNow(written));
      put(onward, location.hash.slice(1));
      [written, place] = [null, placeOf(next)];
    },

    /** Writes what has changed, soon. @param {State} state */
    follow(state) {
      if (!isElsewhere(state, place)) place = placeOf(state);
      if (away.leaves || !isDue(state, place) || (state.evolving && soon.waits && !isElsewhere(state, place)))
        return;
      if (!changed(...links.carried(state))) return;
      lead(state);
      // Another part, or a run from elsewhere, at once, so that "back" is there when it is wanted.
      if (isElsewhere(state, place) || written === null) write();
      else soon.ask(state.evolving ? 'evolving' : 'atRest');
    },
  };
}

/** Loads the page in the language that its address has by now, unless there is no network, or it has another address meanwhile. @param {{ store: Store, actions: Actions, slices: readonly Slice<any>[] }} parts @param {{ leaves: boolean }} away @param {boolean} isThisRun @param {(language: Language) => string} linkNow */
async function speak({ store, actions, slices }, away, isThisRun, linkNow) {
  const asked = location.hash;
  away.leaves = true;
  const isThere = await canLoad();
  if (location.hash !== asked) {
    // Pressed once more, it is left from there.
    away.leaves = languageOfAddress() !== language;
    return;
  }
  if (isThere) {
    if (isThisRun) {
      // With what was done while one waited.
      put('replaceState', linkNow(languageOfAddress()));
      crossOver(store.get(), slices);
    }
    return location.reload();
  }
  away.leaves = false;
  put('replaceState', linkNow(language));
  actions.say(words.notLoaded);
}

/** Whether something is being opened, or being set, which is in sight only once it has begun. @param {State} state */
const isBeginning = ({ computing }) => computing?.what === 'begin';

/** Nothing of it is in the state yet. @param {State} state */
const isOpening = (state) => isBeginning(state) && !state.computing?.next;

/** As it will begin, where that is known. @param {State} state */
const begun = (state) => (state.computing?.next ? { ...asked(state), generation: 0 } : state);

/** What has not begun has evolved nowhere, and no part has found anything in it. @param {State} state @param {readonly Slice<any>[]} slices */
function crossOver(state, slices) {
  if (!isBeginning(state)) return takeAlong(state, slices);
  takeAlong({ ...state, history: state.history.slice(0, 1), catchingUp: null, evolving: false }, []);
}

/** Calls it once after the pause that was asked for last. @param {() => void} act */
function createPause(act) {
  /** @type {keyof typeof pauses | null} */
  let asked = null;
  let timer = 0;
  return {
    get waits() {
      return asked !== null;
    },

    /** @param {keyof typeof pauses} pause */
    ask(pause) {
      if (asked === pause) return;
      clearTimeout(timer);
      asked = pause;
      timer = window.setTimeout(() => {
        asked = null;
        act();
      }, pauses[pause]);
    },
  };
}

/**
 * To the parts and the lesson: an exercise may have taken them out of the document. They are written after the frame, in which
 * enough is drawn.
 * @param {(state: State, name: string) => string} linkTo @param {readonly string[]} names @param {() => void} andThen
 */
function createWays(linkTo, names, andThen) {
  /** @type {Map<string, HTMLElement | null>} */
  const ways = new Map();
  /** The newest, until they lead from it. @type {State | null} */
  let newest = null;
  return async (/** @type {State} */ state) => {
    const isAsked = newest !== null;
    newest = state;
    if (isAsked) return;
    await pause();
    const from = newest;
    newest = null;
    for (const name of names) {
      const way = ways.get(name) ?? document.getElementById(`page-${name}`);
      ways.set(name, way);
      way?.setAttribute('href', `#${linkTo(from, name)}`);
    }
    andThen();
  };
}

/** Who works here, where the address says so before its #, as learning platforms write it. */
const whoAsked = () => tidyText(new URLSearchParams(location.search).get('who') ?? '').slice(0, mostOfWho);

/** Where an address is: the part, the step of the lesson, and what is tried there. @typedef {Pick<State, 'page' | 'lesson' | 'trial'>} Place */

/** @param {Place} at @returns {Place} */
const placeOf = ({ page, lesson, trial }) => ({ page, lesson, trial });

/** @param {State} state @param {Place} place */
const isElsewhere = (state, place) => state.page !== place.page || state.lesson !== place.lesson;

/** Another part does not wait until a drag has ended: one goes back from there too. @param {State} state @param {Place} place */
const isDue = (state, place) =>
  !isBeginning(state) && !state.catchingUp && (!state.dragging || isElsewhere(state, place));
