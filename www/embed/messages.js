// What an embedded figure and the page around it say to each other with postMessage.
//
// Every message is an object with ep: 1, the version, and a type. The page around the figure may send
//
//   { ep: 1, type: 'set', link }                                  opens a link: an address of this page, or what follows its #
//   { ep: 1, type: 'set', experiment, gains, generation }         begins an experiment, in which any field may be left out
//   { ep: 1, type: 'step', generations }                          so many generations on, at once; 1 when left out
//   { ep: 1, type: 'run' }   { ep: 1, type: 'pause' }             as the figure's own button does
//   { ep: 1, type: 'read' }
//
// and each is answered in its turn with a state, or with { ep: 1, type: 'error', message }; an id that was sent comes back in
// the answer. What is told of a drive belongs to the rest of the state: where the robot cannot be driven, the answer is an error.
// To <ep-locomotion> the figure first says { type: 'loading' }, from loading.js, while the rest of it is still on its way.
// By itself the figure says { type: 'ready' } with its state when it can be spoken to, { type: 'generation' } with the
// statistics of each generation once it is there, and { type: 'height' } when it would like another height. A figure that
// cannot be ready says { type: 'error', message } in its place; where the core has failed, each question is answered by that.
// What its user does it tells as { type: 'drive', driver, gains, cost, arrived, finalTime, drives } when other gains drive,
// { type: 'answer', question, choice, right } when a question of the lesson is answered, and, when an exercise is handed in,
// { type: 'handin', who, exercise, link, text, gains, cost, parked, starts, drives, minutes, met, points, most }.
// told.js has the table of what may be sent, and what each field must be.
// What a link locks is locked for who sits before the figure, not for the page around it: an experiment that it sets leaves
// the locks as they are, and a link that it opens brings its own, or none.
/** @import { Engine, Experiment, Run, Statistics, Triple } from '../core/engine.js' */
/** @import { Links } from '../link/link.js' */
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { Seen } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */
import { isLost, messageOf } from '../words/errors.js';
import { embed as words } from '../words/index.js';
import { drivesOf, noTrial } from '../run/state.js';
import { pause } from '../kit/loop.js';
import { watch } from '../kit/memo.js';
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
 * @property {string} hash Digits over every number of the history, the same wherever it ran.
 * @property {readonly string[]} problems What a link had wrong, in words.
 */

/** As long as a frame that still looks smooth. */
const sliceMilliseconds = 12;

/** Predictions of the lesson by the names of their questions, and the right ones once they are known. @typedef {(state: State) => Readonly<Record<string, { choice: number, right: number | null }>>} AnswersOf */

/**
 * @param {{ engine: Engine, store: Store, actions: Actions, links: Links, seen: () => Seen, answersOf: AnswersOf, whenSeen: () => Promise<void> }} parts `seen`: what drives on screen; `whenSeen`: once all of it is there.
 * @param {(message: object) => void} send To the page around.
 */
export function createMessages({ engine, store, actions, links, seen, answersOf, whenSeen }, send) {
  /** @type {Statistics[]} */
  let announced = [];

  let isReady = false;

  /** Why nothing can be answered any more. */
  let failure = '';
  /** Those who wait for an answer then wait in vain. @type {Set<(reason: Error) => void>} */
  const waiting = new Set();

  const drivesOther = watch();
  /** @type {ReturnType<AnswersOf>} */
  let answered = {};

  const driven = () => {
    const { scene, failure: refused } = seen();
    if (refused) throw refused;
    const { driving, gains } = scene;
    const { cost, arrived, finalTime } = driving;
    const [kx, ky, ktheta] = gains;
    return { gains: /** @type {Triple} */ ([kx, ky, ktheta]), cost, arrived, finalTime };
  };

  /** Tells what who sits before the figure has done. @param {boolean} isTold Else it is only remembered. */
  const announceWork = (isTold) => {
    const state = store.get();
    const { driver, work } = state;
    const { isComputing, failure: refused } = seen();
    // What is still computed is told once it is there.
    const isThere = !isComputing && refused === null;
    if ((isThere || !isTold) && drivesOther(driver, work.tries) && isTold)
      send({ type: 'drive', driver, ...driven(), drives: drivesOf(state) });
    const answers = answersOf(state);
    if (answers === answered) return;
    for (const [question, { choice, right }] of Object.entries(answers))
      if (isTold && right !== null && answered[question]?.right !== right)
        send({ type: 'answer', question, choice, right });
    answered = answers;
  };

  /** Tells the generations that are new. */
  const announce = () => {
    if (!isReady || failure) return;
    announceWork(true);
    const { history } = store.get();
    const known = history[0] === announced[0] ? announced.length : 0;
    announced = history;
    for (const statistics of history.slice(known)) send({ type: 'generation', ...statistics });
  };

  /** @param {readonly string[]} problems @returns {Report} */
  const report = (problems) => {
    const state = store.get();
    const { experiment, generation, history, evolving } = state;
    return {
      link: links.linkOf(state, engine.experiment),
      experiment,
      generation,
      generations: history.length - 1,
      evolving,
      statistics: history[generation],
      drive: driven(),
      hash: engine.hash(),
      problems,
    };
  };

  /** Lets a run begin, and come as far as its link says, without the frames of the page: where nobody sees it there are none. */
  const arrive = async () => {
    await actions.whenIdle();
    while (store.get().catchingUp && store.get().evolving && !failure) {
      const end = performance.now() + sliceMilliseconds;
      actions.evolve(() => performance.now() < end);
      await actions.whenIdle();
      await pause();
    }
  };

  /** @param {Parameters<Actions['openLinked']>[0]} opened */
  const open = async (opened) => {
    // What stood in the way before is no answer to this.
    actions.say('');
    actions.openLinked(opened, []);
    await actions.whenIdle();
    if (store.get().experiment !== opened.experiment) throw new Error(store.get().message || words.givenUp);
    // It is the host's doing.
    announceWork(false);
    await arrive();
    actions.standAt(Number.POSITIVE_INFINITY);
    announce();
  };

  /** @type {{ [T in import('./told.js').Type]: (said: import('./told.js').Said[T]) => readonly string[] | Promise<readonly string[]> }} */
  const answers = {
    async set({ link, experiment, gains: handGains, generation }) {
      if (link !== null) {
        const { opened, problems } = links.openLink(link.slice(link.indexOf('#') + 1), engine);
        await open(opened);
        return problems;
      }
      const { page, lesson, preset, pins, exercise: own, student } = store.get();
      const whole = engine.experiment(/** @type {Experiment} */ (experiment));
      // The core knows which gains cannot be driven.
      if (handGains) engine.check(whole, handGains);
      await open({
        page,
        lesson,
        preset,
        experiment: whole,
        generation,
        driver: handGains ? 'hand' : 'evolved',
        handGains,
        found: 'hand',
        trial: noTrial,
        pins,
        exercise: own,
        student,
        parts: {},
      });
      return [];
    },

    async step({ generations }) {
      // What was set before begins first.
      await actions.whenIdle();
      const { history } = store.get();
      actions.showGeneration(history.length - 1);
      let end = performance.now() + sliceMilliseconds;
      for (let i = 0; i < generations; i += 1) {
        const before = store.get().generation;
        actions.forward();
        await actions.whenIdle();
        // Somebody has stopped what was computed.
        if (store.get().generation === before) return [store.get().message];
        if (performance.now() < end) continue;
        announce();
        await pause();
        // Someone has begun anew, or goes on by hand, or nothing goes on.
        if (failure || store.get().history[0] !== history[0] || store.get().evolving) break;
        end = performance.now() + sliceMilliseconds;
      }
      announce();
      return [];
    },

    run: () => evolving(true),
    pause: () => evolving(false),
    read: () => [],
  };

  const evolving = (/** @type {boolean} */ wanted) => {
    if (store.get().evolving !== wanted) actions.toggleEvolution();
    return [];
  };

  /** What an act comes to, once all of it is seen. @param {() => readonly string[] | Promise<readonly string[]>} act @returns {Promise<Report>} */
  const reportOf = (act) =>
    new Promise((resolve, reject) => {
      if (failure) throw new Error(failure);
      waiting.add(reject);
      const done = async () => {
        const problems = await act();
        await whenSeen();
        return report(problems);
      };
      done()
        .then(resolve, reject)
        .finally(() => waiting.delete(reject));
    });

  /** @param {unknown} error @param {object} named */
  const refuse = (error, named) => send({ type: 'error', ...named, message: shortError(messageOf(error)) });

  /** @param {unknown} message */
  async function answer(message) {
    if (!isForFigure(message)) return;
    const named = idIn(message);
    try {
      const { type, said } = messageIn(message);
      const act = /** @type {(said: object) => readonly string[] | Promise<readonly string[]>} */ (
        answers[type]
      );
      send({ type: 'state', ...named, ...(await reportOf(() => act(said))) });
    } catch (error) {
      refuse(error, named);
      // The page has to know of it.
      if (isLost(error)) reportError(error);
    }
  }

  let end = 0;
  /** One after the other, and however many they are, all else has its turn. @param {unknown} message */
  async function take(message) {
    if (performance.now() > end) {
      await pause();
      end = performance.now() + sliceMilliseconds;
    }
    await answer(message);
  }

  let heard = Promise.resolve();

  return {
    announce,

    /** Once the run is there. */
    async ready() {
      try {
        send({ type: 'ready', ...(await reportOf(() => arrive().then(() => []))) });
      } catch (error) {
        if (isLost(error)) reportError(error);
        // That it has failed is said.
        if (failure) return;
        refuse(error, {});
      }
      announceWork(false);
      isReady = true;
      announce();
    },

    /** In the order in which they came: many generations take a while. @param {unknown} message Whatever came. */
    hear(message) {
      heard = heard.then(() => take(message));
    },

    /** Nothing can be answered any more. @param {string} why */
    fail(why) {
      if (failure) return;
      failure = why;
      if (!isReady) refuse(new Error(why), {});
      for (const reject of waiting) reject(new Error(why));
    },
  };
}
