// Whether one press meets what an exercise asks for: of whom else a student could let drive.
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { Driver, State } from '../../run/state.js' */
/** @import { SheetTools } from '../load.js' */
import { watch } from '../../kit/memo.js';
import { judged } from '../../run/aim.js';
import { gainsOf } from '../../run/drivers.js';
import { wayOf } from '../../run/exercise.js';
import { measure } from '../handin/measure.js';

/** Those that somebody else has found. @type {readonly Driver[]} */
const found = ['evolved', 'paper-ep', 'paper-arbitrary'];

/** @param {Exercise} draft */
const offeredBy = (draft) =>
  wayOf(draft, 'drives') === 'free'
    ? found.filter((driver) => driver === 'evolved' || wayOf(draft, 'paper') !== 'hidden')
    : [];

/** @param {Pick<SheetTools, 'engine' | 'paper'>} tools @param {() => void} onKnown @returns {(state: State, draft: Exercise) => readonly Driver[]} Those of whom it is known, in their order. */
export function createEasy({ engine, paper }, onKnown) {
  const channel = engine.surveys.channel();
  const changed = watch();
  /** @type {readonly Driver[]} */
  let easy = [];
  let questions = 0;

  /** @param {State} state @param {Exercise} draft @param {readonly Driver[]} offered @param {number} question */
  const ask = async (state, { aim }, offered, question) => {
    if (!aim) return;
    for (const driver of offered) {
      const gains = gainsOf(state, driver, paper);
      const { value } = await measure(engine, aim, state.experiment, gains, { channel });
      if (question !== questions) return;
      if (!judged({ ...aim, drives: null }, null, { value, drives: 0 }).isMet) continue;
      easy = [...easy, driver];
      onKnown();
    }
  };

  return (state, draft) => {
    const offered = offeredBy(draft);
    if (changed(state.experiment, state.preset, state.population, draft.aim, String(offered))) {
      easy = [];
      questions += 1;
      // It is only a hint: what cannot be measured is told where it is handed in.
      ask(state, draft, offered, questions).catch(() => {});
    }
    return easy;
  };
}
