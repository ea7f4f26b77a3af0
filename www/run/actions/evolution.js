// Evolution goes on, back, and over again.
/** @import { State } from '../state.js' */
/** @import { Until } from '../pace.js' */
/** @import { Basis } from './basis.js' */
import { embed, lab as words } from '../../words/index.js';
import { atEnd, fromStart } from '../clock.js';
import { canStop, isFree } from '../guard.js';
import { asked } from '../state.js';
import { lastGeneration, paces, pausesAt, playsPhases, untilAhead, usualUntil } from '../pace.js';

/** Milliseconds of a frame in which a run catches up. */
const atOnce = 30;

/** @param {Basis} basis @param {(page: string) => void} openPage */
export function createEvolution(basis, openPage) {
  const { onceBegun, driveAgain } = basis;
  const { forward, ...generations } = createGenerations(basis);
  const play = createPlay(basis, openPage);

  return {
    ...generations,
    ...play,
    ...createSeeds(basis, generations.catchUp),

    forward: () => onceBegun(() => forward()),

    oneGeneration() {
      play.pauseEvolution();
      onceBegun(() => {
        forward();
        driveAgain();
      });
    },
  };
}

/** From one generation to another. @param {Basis} basis */
function createGenerations({ engine, store, attempt, forget }) {
  /** One generation on: the next that is recorded, or a new one. @param {State['history']} [known] A copy of the history, which takes the new one: whoever goes on and on makes only one, for it may be long. */
  const forward = (known = [...store.get().history]) =>
    attempt(
      () => {
        const generation = store.get().generation + 1;
        if (generation === known.length) {
          // What has come further no link and no file could say.
          if (generation > lastGeneration)
            throw new Error(embed.wholeNumber('generation', 0, lastGeneration, String(generation)));
          known.push(engine.step());
        }
        const population = engine.population(generation);
        // What is wrong with a link stays in sight while its generation is still to come.
        const said = store.get().catchingUp ? null : { message: '' };
        store.update({ history: known, generation, population, ...said });
        // Who plays phases pauses after the last of them.
        if (store.get().evolving && !playsPhases(store.get())) arrive();
      },
      { what: 'generation' },
    );

  /** Another generation that is recorded. @param {number} generation @param {{ message: string } | null} [said] */
  const showGeneration = (generation, said = { message: '' }) => {
    forget();
    store.update({ evolving: false, catchingUp: null });
    attempt(() => store.update({ generation, population: engine.population(generation), ...said }), {
      what: 'recorded',
      generation,
    });
  };

  /** Pauses where the run has to. */
  const arrive = () => {
    const { until, history, generation, catchingUp } = store.get();
    if (generation === catchingUp?.newest) {
      showGeneration(catchingUp.generation, null);
      if (catchingUp.goesOn) store.update({ evolving: true, ...untilAhead(store.get()) });
    } else if (!catchingUp && pausesAt(until, history[generation])) store.update({ evolving: false });
  };

  return {
    forward,

    showGeneration,

    /** Goes on while `more` says so, or until the run has to pause. @param {() => boolean} more */
    evolve(more) {
      if (store.get().computing) return;
      const known = [...store.get().history];
      while (store.get().evolving && !store.get().computing && more()) forward(known);
    },

    /** Evolves as far as a run has come: at once if that is soon done, else while the page looks on. @param {number} newest @param {number} generation The one that is shown then. @param {boolean} [goesOn] */
    catchUp(newest, generation, goesOn = false) {
      const end = performance.now() + atOnce;
      const known = [...store.get().history];
      while (store.get().generation < newest && !store.get().computing && performance.now() < end)
        forward(known);
      if (store.get().generation < newest)
        store.update({ evolving: true, catchingUp: { newest, generation, goesOn } });
      else showGeneration(generation);
    },

    oneBack() {
      const { generation, computing } = store.get();
      const from = computing?.generation ?? generation;
      if (from > 0) showGeneration(from - 1);
    },
  };
}

/** Evolution goes on by itself, at its pace, or pauses. @param {Basis} basis @param {(page: string) => void} openPage */
function createPlay({ store, places, isStill, forget }, openPage) {
  /** No generation is waited for; what was set or opened begins all the same, and evolution goes on or rests there. */
  const leaveOff = () => {
    if (store.get().computing?.what !== 'begin') forget();
  };

  /** Where phases are played they are seen, from the first one on. */
  const seePhases = () => {
    const state = store.get();
    if (!playsPhases(state) || state.page === places.phases) return;
    // Who may not go there sees whole generations.
    if (!isFree(state, 'parts')) return store.update({ pace: paces[1] });
    const { [places.phases]: _, ...slices } = state.slices;
    store.update({ slices });
    openPage(places.phases);
  };

  return {
    pauseEvolution() {
      leaveOff();
      store.update({ evolving: false, catchingUp: null });
    },

    /** @param {number} pace */
    setPace(pace) {
      store.update({ pace, catchingUp: null, ...(store.get().evolving && untilAhead(store.get())) });
      seePhases();
    },

    /** @param {Until['kind']} kind @param {string} text */
    setUntil(kind, text) {
      if (kind === 'every') return store.update({ until: usualUntil, untilError: '' });
      const value = words.numberOf(text);
      const wrong = words.untilRefused(kind, value, text, generationNow(store.get()) + 1, lastGeneration);
      store.update(wrong ? { untilError: wrong } : { until: { kind, value }, untilError: '' });
    },

    toggleEvolution() {
      const evolving = !store.get().evolving;
      leaveOff();
      store.update({ evolving, catchingUp: null, ...(evolving && untilAhead(store.get())) });
      seePhases();
      const { robot } = store.get();
      if (evolving && !isStill())
        store.update({ robot: robot.time === atEnd.time ? fromStart : { ...robot, playing: true } });
    },

    /** What is under way is given up, and what is done stays. */
    stopComputing() {
      const { computing, catchingUp, generation } = store.get();
      if ((!computing && !catchingUp) || !canStop(store.get())) return;
      forget();
      const message = words.stoppedText(computing?.what === 'begin' ? null : generation);
      store.update({ catchingUp: null, evolving: false, message });
    },
  };
}

/** Over again. @param {Basis} basis @param {(newest: number, generation: number) => void} catchUp */
function createSeeds({ engine, store, attempt, begin, onceBegun, shown }, catchUp) {
  /** @param {number} seed */
  const useSeed = (seed) => {
    store.update({ evolving: false });
    attempt(() => {
      const { experiment } = asked(store.get());
      const next = engine.experiment({ ...experiment, evolution: { ...experiment.evolution, seed } });
      begin(next, 'seed', { robot: shown() });
    });
  };

  return {
    useSeed,

    /** A generation of the evolution with a seed, which may be the one that is there. @param {number} seed @param {number} generation */
    showSeed(seed, generation) {
      if (asked(store.get()).experiment.evolution.seed !== seed) useSeed(seed);
      onceBegun(() => catchUp(generation, generation));
    },

    newSeed: () => useSeed(engine.randomSeed()),

    reset() {
      store.update({ evolving: false });
      begin(asked(store.get()).experiment, 'reset', { robot: shown() });
    },
  };
}

/** From where evolution goes on. @param {State} state */
const generationNow = ({ computing, generation }) => (computing?.next ? 0 : generation);
