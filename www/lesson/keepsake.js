// Answers and drives outlast a reload of the tab.
import { withStorage } from '../kit/tab.js';
import { language } from '../words/language.js';
import { noProgress, noTally, progressSlice } from './state.js';

/** @import { Store } from '../run/store.js' */
/** @import { Answer, Progress } from './state.js' */

const key = 'ep-locomotion lesson';
const placeKey = 'ep-locomotion place';
const mostCharacters = 200_000;

/** What outlasts: answers that are there, with the language in which they were said, and what was driven. @param {Progress} progress */
export function textOf({ answers, tally, duel }) {
  const settled = Object.entries(answers).filter(([, { right }]) => right !== null);
  const said = settled.map(([key, answer]) => [key, { said: language, ...answer }]);
  return JSON.stringify({
    answers: Object.fromEntries(said),
    tally,
    duel: duel && { ...duel, rounds: [] },
  });
}

/** What a text says of it; nothing of it is trusted. @param {string} text @returns {Progress} */
export function progressOf(text) {
  const { answers, tally, duel } = JSON.parse(text);
  const isAnswer = (/** @type {Answer} */ one) =>
    Number.isInteger(one.choice) && Number.isInteger(one.right) && typeof one.why === 'string';
  const isDriven = (/** @type {{ costs: unknown }} */ one) =>
    Array.isArray(one.costs) && one.costs.every((cost) => cost === null || typeof cost === 'number');
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
    tally:
      isDriven(tally) && typeof tally.experiment === 'string' ? whole({ ...noTally, ...tally }) : noTally,
    duel: duel && isDriven(duel) && duel.experiment ? whole({ ...duel, rounds: [] }) : null,
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
  const [entry] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType('navigation'));
  let before = entry?.type === 'navigate' ? null : withStorage((storage) => storage.getItem(placeKey));
  /** To the place where one was in this step, once, or to its beginning. @param {number} step */
  return (step) => {
    const [kept, ...tops] = /^\[[\d.,]+\]$/.test(before ?? '') ? JSON.parse(before ?? '') : [];
    before = null;
    for (const [i, one] of scrolled.entries()) one.scrollTop = kept === step ? (tops[i] ?? 0) : 0;
  };
}

/** What is kept; nothing where somebody else has written it. */
function keptByNow() {
  const text = withStorage((storage) => storage.getItem(key));
  try {
    return text && text.length <= mostCharacters ? progressOf(text) : noProgress;
  } catch {
    return noProgress;
  }
}

/** Brings back what there was, and keeps what comes. @param {Store} store */
export function createKeepsake(store) {
  let kept = progressSlice.of(store.get());
  const before = keptByNow();
  if (before !== noProgress && kept === noProgress) progressSlice.update(store, before);
  return {
    /** @param {Progress} progress */
    follow(progress) {
      if (progress === kept) return;
      // Other figures of the same tab keep their answers there too.
      const answers = { ...keptByNow().answers };
      for (const name of Object.keys(kept.answers)) delete answers[name];
      Object.assign(answers, progress.answers);
      kept = progress;
      withStorage((storage) => storage.setItem(key, textOf({ ...progress, answers })));
    },
  };
}
