// What the robots do: a film by hand or of evolution, and what follows it.
/** @import { Engine, PaperResult, Triple } from '../../core/engine.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Film } from './film.js' */
import { isLost, messageOf } from '../../words/errors.js';
import { isStill } from '../../kit/host.js';
import { createFrameLoop } from '../../kit/loop.js';
import { remember } from '../../kit/memo.js';
import { hidesPaper } from '../../run/exercise.js';
import { createBreeding, isDone } from './breeding.js';
import { filmOf, isOver, later, lengths } from './film.js';
import { parkSlice, reaching } from './state.js';
import { anyGains, firstGains, parkedOf } from './task.js';

/** @param {Engine} engine @param {Store} store @param {PaperResult[]} paper @param {ReturnType<typeof import('./task.js').createTask>} task */
export function createPlay(engine, store, paper, task) {
  const { now: slice, update } = parkSlice.at(store);
  const breeding = createBreeding(engine, task);
  const handFilm = createHand(task);
  const gainsNow = () => slice().gains ?? (hidesPaper(store.get()) ? anyGains : firstGains(paper));
  const foundNow = () => slice().between ?? slice().bred.at(-1);
  const filmNow = () => {
    const found = slice().bred.at(-1);
    return found ? filmOf(task.drive([found.gains])[0], [], 'hand') : handFilm(gainsNow());
  };
  const { film, show, request } = createProjector(filmNow(), store, ended);
  const isOf = (/** @type {Triple} */ gains) => film().drives === handFilm(gains).drives;

  /** One generation more, as a film. */
  function breed() {
    const { bred, seed } = slice();
    const next = breeding.next(bred.at(-1) ?? null, seed);
    if (!next) return;
    const { drives, others, robot } = next;
    const length = bred.length < 3 ? 'first' : robot.gains === bred.at(-1)?.gains ? 'same' : 'next';
    update({ bred: [...bred, robot] });
    show(filmOf(drives, others, length));
  }

  /** A hand may go from now on as far as evolution has gone. */
  function stop() {
    const { ends, bred } = slice();
    const found = bred.at(-1);
    update({ evolving: false, endsBefore: ends, ends: found ? reaching(ends, found.gains) : ends });
  }

  /** What the sliders' gains come to counts, also if it has not been seen to its end. */
  const tried = () => (isOf(gainsNow()) ? bestWith(slice(), parkedOf(film().drives)) : {});

  /** The film has come to its end. */
  function ended() {
    const { evolving, bred } = slice();
    if (!evolving) return update(tried());
    if (!isDone(bred, task.starts.length)) return breed();
    stop();
    show(filmOf(film().drives, [], 'hand'));
  }

  return {
    film,
    show,
    request,
    gains: gainsNow,
    /** Whether the robots drive with the sliders' gains. */
    isOwn: () => isOf(gainsNow()),
    /** The gains that they do drive with. */
    driven: () => (isOf(gainsNow()) ? gainsNow() : (foundNow()?.gains ?? gainsNow())),
    /** Other gains, of a link, or where an exercise hides the paper's. */
    follow() {
      const { bred, between } = slice();
      if (bred.length === 0 && !between && !isOf(gainsNow())) show(handFilm(gainsNow()));
    },

    on: {
      /** @param {number} index @param {number} value */
      slide(index, value) {
        const gains = /** @type {[number, number, number]} */ ([...gainsNow()]);
        gains[index] = value;
        show(handFilm(gains));
        update({ gains, evolving: false, between: null });
        if (isStill()) ended();
      },
      again: () => show({ ...film(), time: 0 }),
      evolve() {
        try {
          const { seed, bred } = slice();
          const next = bred.length > 0 ? seed + 1 : seed;
          breeding.begin(next);
          const afresh = { bred: [], message: '', between: null, looked: null };
          update({ ...tried(), ...afresh, seed: next, evolving: true });
          breed();
        } catch (error) {
          if (isLost(error)) throw error;
          update({ evolving: false, message: messageOf(error) });
        }
      },
      stop,
    },
  };
}

/** Films of gains, each once for the gains that were asked for last. @param {ReturnType<typeof import('./task.js').createTask>} task */
function createHand(task) {
  const byHand = remember(
    (/** @type {number} */ kx, /** @type {number} */ ky, /** @type {number} */ ktheta) =>
      filmOf(task.drive([[kx, ky, ktheta]])[0], [], 'hand'),
  );
  return (/** @type {Triple} */ [kx, ky, ktheta]) => byHand(kx, ky, ktheta);
}

/** The best by hand, with one try more. @param {import('./state.js').ParkState} before @param {number} parked */
const bestWith = ({ gains, best }, parked) =>
  gains && (!best || parked >= best.parked) ? { best: { gains, parked } } : {};

/** Runs a film while the part is open; `onEnd` is called at its end, and may begin the next. @param {Film} first @param {Store} store @param {() => void} onEnd */
function createProjector(first, store, onEnd) {
  const begun = (/** @type {Film} */ film) => (isStill() ? later(film, Number.POSITIVE_INFINITY) : film);
  const isEvolving = () => parkSlice.of(store.get()).evolving;
  /** Where nothing moves each generation stands for a while. */
  let stood = 0;
  let film = begun(first);
  const { request } = createFrameLoop((seconds) => {
    if (store.get().page !== 'park') return false;
    const wasOver = isOver(film);
    film = later(film, seconds);
    stood += seconds;
    store.redraw();
    if (isStill() && isEvolving() && stood < lengths.same) return true;
    if (isOver(film) && (!wasOver || isEvolving())) onEnd();
    return !isOver(film) || isEvolving();
  });
  request();
  return {
    film: () => film,
    request,
    /** @param {Film} next */
    show(next) {
      film = begun(next);
      stood = 0;
      request();
    },
  };
}
