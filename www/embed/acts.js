// What each message to a figure does. It resolves to what was wrong with it, in words.
/** @import { Experiment, Triple } from '../core/engine.js' */
/** @import { Opened } from '../run/actions/page.js' */
/** @import { State } from '../run/state.js' */
/** @import { Parts } from './messages.js' */
/** @import { Said, Type } from './told.js' */
import { embed as words } from '../words/index.js';
import { lastGeneration } from '../run/pace.js';
import { preparedAs } from '../run/prepared.js';
import { noTrial, spentOf } from '../run/state.js';
import { pause } from '../kit/loop.js';
import { linkIn } from './link-in.js';

/** @typedef {readonly string[] | Promise<readonly string[]>} Problems */

/** As long as a frame that still looks smooth. */
export const sliceMilliseconds = 12;

/** Of one message: whether a pause has ended it, and what is done once what it sets has begun. @typedef {{ isEnded: () => boolean, begun: () => void }} Turn */

/**
 * @param {Parts} parts
 * @param {{ announce: () => void, remember: () => void, hasFailed: () => boolean }} figure It announces what is new, or remembers it as told, until the core has failed.
 */
export function createActs({ engine, store, actions, links }, { announce, remember, hasFailed }) {
  /** What goes on by itself, or a generation that is waited for, does so no longer. */
  const leaveOff = () => {
    const { evolving, computing } = store.get();
    if (evolving || computing?.what === 'generation') actions.pauseEvolution();
  };

  /** Lets a run begin, and come as far as its link says, without the frames of the page: where nobody sees it there are none. */
  const arrive = async (/** @type {Turn} */ { isEnded, begun }) => {
    await actions.whenIdle();
    begun();
    while (store.get().catchingUp && store.get().evolving && !hasFailed() && !isEnded()) {
      const end = performance.now() + sliceMilliseconds;
      actions.evolve(() => performance.now() < end);
      await actions.whenIdle();
      await pause();
    }
    if (isEnded()) leaveOff();
  };

  /** @param {Opened} opened @param {Turn} turn */
  const open = async (opened, turn) => {
    // What stood in the way before is no answer to this.
    actions.say('');
    actions.openLinked(opened, []);
    await actions.whenIdle();
    if (store.get().experiment !== opened.experiment) throw new Error(store.get().message || words.givenUp);
    // It is the host's doing.
    remember();
    await arrive(turn);
    actions.standAt(Number.POSITIVE_INFINITY);
    announce();
  };

  const evolving = (/** @type {boolean} */ wanted) => {
    if (store.get().evolving !== wanted) actions.toggleEvolution();
    return [];
  };

  /** @type {{ [T in Type]: (said: Said[T], turn: Turn) => Problems }} */
  const acts = {
    async set({ link, experiment, gains, generation }, turn) {
      if (link !== null) {
        const { opened, problems } = links.openLink(linkIn(link), engine);
        await open(opened, turn);
        return problems;
      }
      const whole = engine.changed(store.get().preset, /** @type {Experiment} */ (experiment));
      // The core knows which gains cannot be driven.
      if (gains) engine.check(whole, gains);
      await open(openedWith(store.get(), whole, gains, generation), turn);
      return [];
    },

    async step({ generations }, { isEnded }) {
      // What was set before begins first.
      await actions.whenIdle();
      const { history } = store.get();
      actions.showGeneration(history.length - 1);
      let end = performance.now() + sliceMilliseconds;
      for (let i = 0; i < generations && !isEnded(); i += 1) {
        const before = store.get().generation;
        actions.forward();
        await actions.whenIdle();
        if (store.get().generation === before) {
          announce();
          if (isEnded()) return [];
          if (before === lastGeneration) throw new Error(store.get().message);
          // Somebody has stopped what was computed.
          return [store.get().message];
        }
        if (performance.now() < end) continue;
        announce();
        await pause();
        // Someone has begun anew, or goes on by hand, or nothing goes on.
        if (hasFailed() || store.get().history[0] !== history[0] || store.get().evolving) break;
        end = performance.now() + sliceMilliseconds;
      }
      announce();
      return [];
    },

    run: () => evolving(true),
    pause: () => evolving(false),
    read: () => [],
  };

  return { arrive, leaveOff, acts };
}

/** The page as it is, with another experiment; where drives are counted, with those that were made. @param {State} state @param {Experiment} experiment @param {Triple | null} handGains @param {number} generation @returns {Opened} */
function openedWith(state, experiment, handGains, generation) {
  const { page, lesson, preset, pins, exercise, student } = state;
  const spent = exercise.aim?.drives ? spentOf({ ...state, generation: 0 }) : student.spent;
  // Of an exercise it is a new one; what is drawn for a student stays drawn.
  /** @type {Pick<Opened, 'driver' | 'handGains' | 'generation'>} */
  const drive = { driver: handGains ? 'hand' : 'evolved', handGains, generation };
  const given = exercise.vary.length === 0 ? { preset, experiment } : student.base;
  const base = student.base && given && { ...given, prepared: preparedAs(drive, exercise) };
  const own = { ...student, base, spent, handin: '', of: '' };
  const kept = { page, lesson, preset, pins, exercise, student: own };
  return { ...kept, ...drive, experiment, found: 'hand', trial: noTrial, parts: {} };
}
