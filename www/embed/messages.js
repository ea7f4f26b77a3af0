// What an embedded figure and the page around it say to each other with postMessage.
//
// Every message is an object with ep: 1, the version, and a type. The page around the figure may send
//
//   { ep: 1, type: 'set', link }                                  opens a link: an address of this page, or what follows its #
//   { ep: 1, type: 'set', experiment, gains, generation }         begins an experiment; fields left out are those of the figure's preset
//   { ep: 1, type: 'step', generations }                          so many generations on, at once; 1 when left out
//   { ep: 1, type: 'run' }   { ep: 1, type: 'pause' }             as the figure's own button does
//   { ep: 1, type: 'read' }
//
// and each is answered with a state, or with { ep: 1, type: 'error', message }; an id that was sent comes back in the answer.
// What is told of a drive belongs to the rest of the state: where the robot cannot be driven, the answer is an error. They are
// done and answered in the order in which they came. But what reads waits only until what was set before has begun, what is
// refused here waits for nothing, and a pause ends what was asked before it, the answers to which tell how far that came.
// To <ep-locomotion> the figure first says { type: 'loading' }, from frame.js, while the rest of it is still on its way, and
// { type: 'loading', hears: true } once it can be asked. Its own link is the first thing that it does: by itself the figure says
// { type: 'ready' } with its state once it has come as far as that says, or a pause has ended it, { type: 'generation' } with the
// statistics of each generation once it is there, and { type: 'height' } when it would like another height. A figure that
// cannot be ready says { type: 'error', message } in its place; where the core has failed, each question is answered by that.
// What its user does it tells as { type: 'drive', driver, gains, cost, arrived, finalTime, drives } when other gains drive,
// { type: 'answer', question, choice, right } when a question of the lesson is answered, and, when an exercise is handed in,
// { type: 'handin', who, exercise, link, text, gains, cost, parked, starts, drives, minutes, met, points, most }.
// told.js has the table of what may be sent, and what each field must be; acts.js does it.
// What a link locks is locked for who sits before the figure, not for the page around it: an experiment that it sets leaves
// the locks as they are, and a link that it opens brings its own, or none.
/** @import { Engine, Experiment, Run, Statistics, Triple } from '../core/engine.js' */
/** @import { Links } from '../link/link.js' */
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { Seen } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */
/** @import { Problems, Turn } from './acts.js' */
/** @import { Said, Type } from './told.js' */
import { isLost, messageOf } from '../words/errors.js';
import { drivesOf } from '../run/state.js';
import { pause } from '../kit/loop.js';
import { watch } from '../kit/memo.js';
import { createActs, sliceMilliseconds } from './acts.js';
import { idIn, isForFigure, messageIn, shortError } from './told.js';

/**
 * What a figure answers.
 * @typedef {object} Report
 * @property {string} link The run, as the address of the whole page has it after its #.
 * @property {Experiment} experiment
 * @property {number} generation The one that is shown.
 * @property {number} generations How many there are after generation 0.
 * @property {boolean} evolving
 * @property {Statistics} statistics Of the generation that is shown.
 * @property {{ gains: Triple, cost: Run['cost'], arrived: boolean, finalTime: number }} drive Of the robot in ink.
 * @property {string} hash Digits over the numbers that decide the history, the same wherever it ran.
 * @property {readonly string[]} problems What a link had wrong, in words.
 */

/** Predictions of the lesson by the names of their questions, and the right ones once they are known. @typedef {(state: State) => Readonly<Record<string, { choice: number, right: number | null }>>} AnswersOf */

/** @typedef {{ engine: Engine, store: Store, actions: Actions, links: Links, seen: () => Seen, answersOf: AnswersOf, whenSeen: () => Promise<void> }} Parts `seen`: what drives on screen; `whenSeen`: once all of it is there. */

/** @param {Parts} parts @param {(message: object) => void} send To the page around. */
export function createMessages(parts, send) {
  const { tell, remember } = createNews(parts, send);
  const { hasFailed, unlessFailed, failAll } = createFailure();
  let isReady = false;

  const announce = () => {
    if (isReady && !hasFailed()) tell();
  };

  const { arrive, leaveOff, acts } = createActs(parts, { announce, remember, hasFailed });

  /** What an act comes to, once all of it is seen. @param {() => Problems} act */
  const reportOf = (act) =>
    unlessFailed(async () => {
      const problems = await act();
      await parts.whenSeen();
      return report(parts, problems);
    });

  /** @param {unknown} error @param {object} named */
  const refuse = (error, named) => send({ type: 'error', ...named, message: shortError(messageOf(error)) });

  /** @param {() => Problems} act @param {object} named */
  async function answer(act, named) {
    try {
      send({ type: 'state', ...named, ...(await reportOf(act)) });
    } catch (error) {
      refuse(error, named);
      // The page has to know of it, once.
      if (isLost(error) && !hasFailed()) reportError(error);
    }
  }

  const inOrder = inTurn();
  const reading = inTurn();
  /** How many were asked to do something, and which of them was the last pause. */
  let asked = 0;
  let paused = 0;
  /** Resolves once what was set last has begun, or was refused. */
  let hasBegun = Promise.resolve();

  /** @param {(turn: Turn) => Promise<void>} act @param {boolean} begins Whether what reads waits until it has begun. */
  function doInTurn(act, begins) {
    asked += 1;
    const own = asked;
    let begun = () => {};
    const beginning = new Promise((resolve) => (begun = () => resolve(undefined)));
    if (begins) hasBegun = beginning;
    return inOrder(() => act({ isEnded: () => paused > own, begun }).finally(begun));
  }

  /** @template {Type} T @param {{ type: T, said: Said[T] }} message @param {object} named */
  function take({ type, said }, named) {
    if (type === 'read') {
      const begun = hasBegun;
      return reading(() => begun.then(() => answer(() => [], named)));
    }
    if (type === 'pause') {
      paused = asked + 1;
      leaveOff();
    }
    return doInTurn((turn) => answer(() => acts[type](said, turn), named), type === 'set');
  }

  /** @param {readonly string[]} problems @param {Turn} turn */
  async function begin(problems, turn) {
    try {
      send({ type: 'ready', ...(await reportOf(() => arrive(turn).then(() => problems))) });
    } catch (error) {
      if (isLost(error)) reportError(error);
      // That it has failed is said.
      if (hasFailed()) return;
      refuse(error, {});
    }
    remember();
    isReady = true;
    announce();
  }

  return {
    announce,

    /** Once the run is there, or as much of it as a pause has left. @param {readonly string[]} [problems] of its link */
    ready: (problems = []) => doInTurn((turn) => begin(problems, turn), true),

    /** @param {unknown} message Whatever came. */
    hear(message) {
      if (!isForFigure(message)) return;
      const named = idIn(message);
      try {
        take(messageIn(message), named);
      } catch (error) {
        refuse(error, named);
      }
    },

    /** Nothing can be answered any more. @param {string} why */
    fail(why) {
      if (hasFailed()) return;
      failAll(why);
      if (!isReady) refuse(new Error(why), {});
    },
  };
}

/** What the figure says by itself. @param {Parts} parts @param {(message: object) => void} send */
function createNews({ store, seen, answersOf }, send) {
  /** @type {Statistics[]} */
  let announced = [];
  const drivesOther = watch();
  /** @type {ReturnType<AnswersOf>} */
  let answered = {};

  /** Tells what who sits before the figure has done. @param {boolean} isTold Else it is only remembered. */
  const tellWork = (isTold) => {
    const state = store.get();
    const { driver, work } = state;
    const { isComputing, failure } = seen();
    // What is still computed is told once it is there.
    const isThere = !isComputing && failure === null;
    if ((isThere || !isTold) && drivesOther(driver, work.tries) && isTold)
      send({ type: 'drive', driver, ...driveOf(seen()), drives: drivesOf(state) });
    const answers = answersOf(state);
    if (answers === answered) return;
    for (const [question, { choice, right }] of Object.entries(answers))
      if (isTold && right !== null && answered[question]?.right !== right)
        send({ type: 'answer', question, choice, right });
    answered = answers;
  };

  return {
    /** Tells what is new. */
    tell() {
      tellWork(true);
      const { history } = store.get();
      const known = history[0] === announced[0] ? announced.length : 0;
      announced = history;
      for (const statistics of history.slice(known)) send({ type: 'generation', ...statistics });
    },

    /** What was done is not told: it is the host's doing, or stood in the address. */
    remember: () => tellWork(false),
  };
}

/** Once the core has failed nothing can be answered any more, and who waits for an answer then waits in vain. */
function createFailure() {
  let failure = '';
  /** @type {Set<(reason: Error) => void>} */
  const waiting = new Set();
  return {
    hasFailed: () => failure !== '',

    /** @template T @param {() => Promise<T>} act @returns {Promise<T>} */
    unlessFailed: (act) =>
      new Promise((resolve, reject) => {
        if (failure) throw new Error(failure);
        waiting.add(reject);
        act()
          .then(resolve, reject)
          .finally(() => waiting.delete(reject));
      }),

    /** @param {string} why */
    failAll(why) {
      failure = why;
      for (const reject of waiting) reject(new Error(why));
    },
  };
}

/** Does one after the other, and however many they are, all else has its turn. */
function inTurn() {
  let end = 0;
  let done = Promise.resolve();
  const take = async (/** @type {() => Promise<void>} */ act) => {
    if (performance.now() > end) {
      await pause();
      end = performance.now() + sliceMilliseconds;
    }
    await act();
  };
  return (/** @type {() => Promise<void>} */ act) => {
    done = done.then(() => take(act));
    return done;
  };
}

/** Where a run goes on, its newest generation may still be driving: what is told is the one that is seen. @param {Parts} parts @param {readonly string[]} problems @returns {Report} */
function report({ engine, store, links, seen }, problems) {
  const { history, evolving } = store.get();
  const { state, ...driven } = seen();
  const { experiment, generation } = state;
  return {
    link: links.linkOf(state, engine.experiment),
    experiment,
    generation,
    generations: history.length - 1,
    evolving,
    statistics: state.history[generation],
    drive: driveOf(driven),
    hash: engine.hash(),
    problems,
  };
}

/** Of the robot in ink. @param {Pick<Seen, 'scene' | 'failure'>} seen @returns {Report['drive']} */
function driveOf({ scene, failure }) {
  if (failure) throw failure;
  const { cost, arrived, finalTime } = scene.driving;
  const [kx, ky, ktheta] = scene.gains;
  return { gains: [kx, ky, ktheta], cost, arrived, finalTime };
}
