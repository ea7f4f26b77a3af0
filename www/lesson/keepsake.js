// Answers and drives outlast a reload of the tab.
import { isBack, withStorage } from '../kit/tab.js';
import { language } from '../words/language.js';
import { mostTallies } from './duel/tally.js';
import { noProgress, noTally, progressSlice } from './state.js';

/** @import { Engine } from '../core/engine.js' */
/** @import { Store } from '../run/store.js' */
/** @import { Answer, Progress, Tally } from './state.js' */

const key = 'ep-locomotion lesson';
const placeKey = 'ep-locomotion place';
const mostCharacters = 200_000;

/** What outlasts: answers that are there, with the language in which they were said, and what was driven. @param {Progress} progress */
export function textOf({ answers, tallies, duel }) {
  const settled = Object.entries(answers).filter(([, { right }]) => right !== null);
  const said = settled.map(([key, answer]) => [key, { said: language, ...answer }]);
  return JSON.stringify({
    answers: Object.fromEntries(said),
    tallies,
    duel: duel && { ...duel, rounds: [] },
  });
}

/** @param {unknown} gains */
const areGains = (gains) => Array.isArray(gains) && gains.length === 3 && gains.every(Number.isFinite);

/** What a text says of it; nothing of it is trusted. @param {string} text @param {Pick<Engine, 'experiment'>} engine @returns {Progress} */
export function progressOf(text, engine) {
  const { answers, tallies = [], duel } = JSON.parse(text);
  const isAnswer = (/** @type {Answer} */ one) =>
    Number.isInteger(one.choice) && Number.isInteger(one.right) && typeof one.why === 'string';
  const isDriven = (/** @type {{ costs: unknown }} */ one) =>
    Array.isArray(one.costs) && one.costs.every((cost) => cost === null || typeof cost === 'number');
  const isBest = (/** @type {any} */ one) => !one || (areGains(one.gains) && Number.isFinite(one.cost));
  const isTally = (/** @type {any} */ one) =>
    isDriven(one) && typeof one.experiment === 'string' && [one.best, one.lowest].every(isBest);
  if (!Object.values(answers).every(isAnswer)) return noProgress;
  const heard = Object.entries(answers).map(([key, { choice, right, why, said }]) => [
    key,
    said === language ? { choice, right, why } : { choice, right, why, said: String(said) },
  ]);
  /** JSON knows no infinity. @template {{ costs: readonly number[] }} T @param {T} one @returns {T} */
  const whole = (one) => ({ ...one, costs: one.costs.map((cost) => cost ?? Number.POSITIVE_INFINITY) });
  return {
    ...noProgress,
    answers: Object.fromEntries(heard),
    tallies: tallies
      .slice(0, mostTallies)
      .filter(isTally)
      .map((/** @type {Tally} */ one) => whole({ ...noTally, ...one })),
    duel:
      duel && isDriven(duel) && (duel.gains === null || areGains(duel.gains))
        ? whole({ ...duel, experiment: engine.experiment(duel.experiment), rounds: [] })
        : null,
  };
}

/** Where one reads: a tab that is loaded again, as telephones do by themselves, opens the step at that place. @param {HTMLElement} article @param {() => number} lesson */
export function createPlace(article, lesson) {
  const scrolled = [document.documentElement, article];
  addEventListener('pagehide', () =>
    withStorage((storage) =>
      storage.setItem(placeKey, JSON.stringify([lesson(), ...scrolled.map(({ scrollTop }) => scrollTop)])),
    ),
  );
  /** @type {readonly number[]} */
  let before =
    (isBack() &&
      withStorage((storage) => JSON.parse(storage.getItem(placeKey) ?? '[]').filter(Number.isFinite))) ||
    [];
  /** To the place where one was in this step, once, or to its beginning. @param {number} step */
  return (step) => {
    const [kept, ...tops] = before;
    before = [];
    for (const [i, one] of scrolled.entries()) one.scrollTop = kept === step ? (tops[i] ?? 0) : 0;
  };
}

/** What is kept; nothing where somebody else has written it. @param {Pick<Engine, 'experiment'>} engine */
function keptByNow(engine) {
  const text = withStorage((storage) => storage.getItem(key));
  try {
    return text && text.length <= mostCharacters ? progressOf(text, engine) : noProgress;
  } catch {
    return noProgress;
  }
}

/** Brings back what there was, and keeps what comes. @param {Store} store @param {Pick<Engine, 'experiment'>} engine */
export function createKeepsake(store, engine) {
  let kept = progressSlice.of(store.get());
  const before = keptByNow(engine);
  if (before !== noProgress && kept === noProgress) {
    progressSlice.update(store, before);
    kept = progressSlice.of(store.get());
  }
  return {
    /** @param {Progress} progress */
    follow(progress) {
      if (progress === kept) return;
      // Other figures of the same tab keep theirs there too; what was of this one, and is no more, is gone.
      const others = keptByNow(engine);
      const answers = { ...others.answers };
      for (const name of Object.keys(kept.answers)) delete answers[name];
      Object.assign(answers, progress.answers);
      const byOthers = (/** @type {Tally} */ { experiment }) =>
        others.tallies.find((one) => one.experiment === experiment);
      // What stands as it did here may have gone on there.
      const own = progress.tallies.map((one) => (kept.tallies.includes(one) && byOthers(one)) || one);
      const known = [...own, ...kept.tallies].map(({ experiment }) => experiment);
      const driven = others.tallies.filter(({ experiment }) => !known.includes(experiment));
      const tallies = [...own, ...driven].slice(0, mostTallies);
      const duel = (progress.duel === kept.duel && others.duel) || progress.duel;
      kept = progress;
      withStorage((storage) => storage.setItem(key, textOf({ ...progress, answers, tallies, duel })));
    },
  };
}
