// From phase to phase of a generation, and over its last one into the next: by hand, or by a clock.
/** @import { State } from '../../run/state.js' */
/** @import { Anatomy, GenerationState, Phase } from './record.js' */
import { generationSlice } from './state.js';
import { forgets } from '../../core/methods.js';
import { whenThere } from '../../core/pending.js';
import { watch } from '../../kit/memo.js';
import { pausesAt, playsPhases } from '../../run/pace.js';
import { orSay } from '../../words/errors.js';
import { chosenOf, phaseAfter, phaseOf } from './record.js';
import words from './words/index.js';

/** Long enough to read what happens in a phase, and for a screen reader to say it. */
const secondsOfPhase = 2;

/** @param {{ store: import('../../run/store.js').Store, actions: import('../../run/actions/actions.js').Actions, anatomyOf: (state: State) => Anatomy }} parts */
export function createSteps({ store, actions, anatomyOf }) {
  const pause = () => actions.pauseEvolution();
  /** While nothing goes on by itself. @param {() => void} act */
  const paused = (act) => () => {
    pause();
    act();
  };
  /** In the generation that is shown now; of what no record can be had is said. @param {() => void} act @param {() => boolean} [isWanted] */
  const whenRecorded = (act, isWanted) => {
    const before = store.get();
    whenThere(orSay(act, actions.say), isWanted ?? (() => isAfter(store.get(), before, 0)));
  };
  const shown = () => {
    const state = store.get();
    const anatomy = anatomyOf(state);
    return { state, anatomy, phase: phaseOf(anatomy, generationSlice.of(state).phase) };
  };

  /** Now, or once the generation that was asked for is there, or what was set has begun. @param {() => void} act */
  const afterwards = (act) => {
    const { computing } = store.get();
    if (!computing) return act();
    const { next } = computing;
    actions.whenIdle().then(() => {
      if (!next || store.get().experiment === next.experiment) act();
    });
  };

  /** @param {Phase} phase @param {Partial<GenerationState>} [more] */
  const turnTo = (phase, more) => {
    generationSlice.update(store, { phase, ...more });
    actions.driveAgain();
  };

  const fall = createFall();

  /** To the next generation, with whoever is shown, if it stays. @param {Phase} first */
  const onward = (first) => {
    const { state, anatomy } = shown();
    const own = generationSlice.of(state);
    actions.forward();
    afterwards(() => {
      if (!isAfter(store.get(), state, 1)) return;
      const place = anatomy.record.survivors.indexOf(chosenOf(anatomy, own));
      fall.note(state, place < 0 ? words.nameOf(anatomy, chosenOf(anatomy, own)) : null);
      turnTo(first, { chosen: place >= 0 && isFollowed(anatomy, own) ? place : null });
    });
  };

  /** The next phase, or the next generation. */
  const goOn = () => {
    const { anatomy, phase } = shown();
    const following = phaseAfter(anatomy, phase, 1);
    if (following) turnTo(following);
    else onward('parents');
  };

  /** @param {Phase} phase */
  const show = (phase) => {
    pause();
    turnTo(phase);
  };

  const goBack = () => {
    const { state, anatomy, phase } = shown();
    const before = phaseAfter(anatomy, phase, -1);
    if (before) return show(before);
    const own = generationSlice.of(state);
    const chosen = chosenOf(anatomy, own);
    const atLastPhase = () => {
      const { survivors } = shown().anatomy.record;
      turnTo('survivors', { chosen: isFollowed(anatomy, own) ? survivors[chosen] : null });
    };
    actions.oneBack();
    afterwards(() => {
      if (isAfter(store.get(), state, -1)) whenRecorded(atLastPhase);
    });
  };

  const play = createPlaying({ store, shown, afterwards, whenRecorded, goOn, pause });

  return {
    show,

    // In what was set before, once that has begun.
    next: paused(() => afterwards(() => whenRecorded(goOn))),
    back: paused(() => whenRecorded(goBack)),

    /** From generation 0, which goes through nothing, into the phases of the next. */
    begin: paused(() => afterwards(() => whenRecorded(() => onward('mutation')))),

    fallenBefore: fall.before,

    /** To be called at every frame: goes on when a phase has had its time. */
    tick: createPhaseClock(play, anatomyOf),
  };
}

/**
 * Goes on by itself, and where evolution is to pause, it does so after the last phase.
 * @param {{ store: import('../../run/store.js').Store, shown: () => { state: State, anatomy: Anatomy, phase: Phase }, afterwards: (act: () => void) => void, whenRecorded: (act: () => void, isWanted: () => boolean) => void, goOn: () => void, pause: () => void }} parts
 */
function createPlaying({ store, shown, afterwards, whenRecorded, goOn, pause }) {
  /** The generation that was played from its first phase on. @type {State['history'][number] | null} */
  let played = null;
  /** @param {State['history'][number]} statistics */
  const follow = (statistics) => {
    const { state, anatomy, phase } = shown();
    if (phase === 'parents') played = statistics;
    if (!phaseAfter(anatomy, phase, 1) && played === statistics && pausesAt(state.until, statistics)) pause();
  };

  return () => {
    goOn();
    afterwards(() => {
      const { history, generation } = store.get();
      const isPlayed = () =>
        playsPhases(store.get()) && store.get().history[generation] === history[generation];
      whenRecorded(() => follow(history[generation]), isPlayed);
    });
  };
}

/** Whether it is so many generations after another, of the same evolution. @param {State} now @param {State} before @param {number} more */
const isAfter = (now, { history, generation }, more) =>
  now.history[0] === history[0] && now.generation === generation + more;

/** Where all is forgotten nobody stays whom one could follow but by name. @param {Anatomy} anatomy @param {GenerationState} own */
const isFollowed = ({ method }, { chosen }) => chosen !== null || !forgets(method);

/** Who was shown, and did not survive that generation. */
function createFall() {
  /** @type {State['history'][number] | null} */
  let last = null;
  /** @type {string | null} */
  let fallen = null;
  return {
    /** @param {State} state @param {string | null} name */
    note({ history, generation }, name) {
      [last, fallen] = [history[generation], name];
    },

    /** Its name; none once another was chosen, or in other generations. @param {State} state */
    before: (state) =>
      state.history[state.generation - 1] === last && generationSlice.of(state).chosen === null
        ? (fallen ?? '')
        : '',
  };
}

/** @param {() => void} goOn @param {(state: State) => unknown} look Throws a Pending as long as there is nothing to see. */
function createPhaseClock(goOn, look) {
  let waited = 0;
  const changed = watch();
  return (/** @type {State} */ state, /** @type {number} */ seconds) => {
    const plays = playsPhases(state) && !state.dragging;
    waited = changed(plays, state.generation, generationSlice.of(state)) ? 0 : waited + seconds;
    if (!plays || state.computing) return;
    const since = waited;
    // Who has nothing to see yet has not begun to read.
    waited = 0;
    look(state);
    waited = since;
    if (waited >= secondsOfPhase) goOn();
  };
}
