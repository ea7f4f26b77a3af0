// Whether one press meets what an exercise asks for: of whom else a student could let drive.
/** @import { Aim } from '../../run/aim.js' */
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { Driver, State } from '../../run/state.js' */
/** @import { SheetTools } from '../load.js' */
import { watch } from '../../kit/memo.js';
import { aimText } from '../../link/exercise.js';
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
  const runChanged = watch();
  const aimChanged = watch();
  /** @type {readonly Driver[]} */
  let easy = [];
  let questions = 0;

  /** @param {State} state @param {Aim} aim @param {readonly Driver[]} offered @param {number} question */
  const ask = async (state, aim, offered, question) => {
    /** @type {Driver[]} */
    const meeting = [];
    for (const driver of offered) {
      const gains = gainsOf(state, driver, paper);
      const { value } = await measure(engine, aim, state.experiment, gains, { channel });
      if (question !== questions) break;
      if (judged({ ...aim, drives: null }, null, { value, drives: 0 }).isMet) meeting.push(driver);
    }
    return meeting;
  };

  /** @param {number} question @param {readonly Driver[]} known */
  const tell = (question, known) => {
    if (question !== questions) return;
    easy = known;
    onKnown();
  };

  return (state, draft) => {
    const { aim } = draft;
    const offered = offeredBy(draft);
    const isOther = runChanged(state.experiment, state.preset, state.population, String(offered));
    // Who types the points gives the same aim again and again.
    const isOtherAim = aimChanged(aim && aimText({ ...aim, drives: null }));
    // While one types the aim, what is known stays: what comes and goes would move what one is about to press.
    if (isOther || !aim) easy = [];
    if (isOther || isOtherAim) {
      questions += 1;
      const question = questions;
      // It is only a hint: what cannot be measured is told where it is handed in.
      if (aim)
        ask(state, aim, offered, question)
          .catch(() => [])
          .then((known) => tell(question, known));
    }
    return easy;
  };
}
