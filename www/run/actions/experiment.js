// What is asked of the robot: start and goal, limits, and every other setting, with the way back.
/** @import { Posture, Preset } from '../../core/engine.js' */
/** @import { Value } from '../paths.js' */
/** @import { Next, Restart, State, Trial } from '../state.js' */
/** @import { Reached } from '../undo.js' */
/** @import { Basis } from './basis.js' */
import { Pending } from '../../core/pending.js';
import { isLost, messageOf } from '../../words/errors.js';
import { settings as words } from '../../words/index.js';
import { wayOf } from '../exercise.js';
import { noErrors } from '../first.js';
import { untilAhead } from '../pace.js';
import { valueAt, withValue } from '../paths.js';
import { unreachable } from '../prepared.js';
import { asked, endsOf, evolvedOf, noTrial } from '../state.js';
import { afterDrag, cameBackTo, isSame as isSameTask, redone, undone } from '../undo.js';
import { drawnFor } from '../variant.js';

/** @typedef {'start' | 'goal'} End */

/** @param {Posture} a @param {Posture} b */
const isSame = (a, b) => a.x === b.x && a.y === b.y && a.theta === b.theta;

/** @param {Posture | null} start @param {Trial} trial @returns {Trial} */
const trialFrom = (start, trial) => (start || trial.disturbance ? { ...trial, start } : noTrial);

/** @param {Basis} basis */
const createSettled =
  ({ attempt, tryToBegin, settle }) =>
  (/** @type {Next} */ next, /** @type {Restart} */ restart, /** @type {Partial<State>} */ patch = {}) =>
    attempt(
      () => {
        tryToBegin(next, restart, patch);
        settle();
      },
      { what: 'begin', next },
    );

/** @typedef {(newest: number, generation: number, goesOn?: boolean) => void} CatchUp */

/** A run that was there before is evolved again; what it drove counts once. @param {Basis} basis @param {CatchUp} catchUp */
const createResume =
  ({ store }, catchUp) =>
  (/** @type {Omit<Reached, 'restart'>} */ { newest, generation, counted, evolved }) => {
    const { evolving, catchingUp, work } = store.get();
    store.update({ work: { ...work, spent: work.spent - evolved, counted } });
    if (newest === 0) return;
    const goesOn = evolving && !catchingUp;
    catchUp(newest, generation, goesOn);
    if (goesOn && !store.get().catchingUp) store.update({ evolving: true, ...untilAhead(store.get()) });
  };

/** What an exercise has of its own. @param {Basis} basis @param {ReturnType<typeof createResume>} resume */
function createOwn({ engine, store }, resume) {
  /** The experiment of the exercise, as it was drawn. @param {State} state */
  const ownOf = ({ student: { base, who }, exercise }) =>
    base && engine.experiment(drawnFor(base.experiment, exercise.vary, who));

  /** Where nobody may evolve, the exercise as it was given has the generation that was prepared. */
  const prepare = () => {
    const state = store.get();
    const { exercise, experiment, generation, history, catchingUp, dragging, student, work } = state;
    const newest = student.base?.prepared.generation ?? work.opened;
    if (generation > 0 || catchingUp || dragging || newest === 0 || wayOf(exercise, 'run') === 'free') return;
    if (JSON.stringify(ownOf(state)) !== JSON.stringify(experiment)) return;
    const evolved = evolvedOf({ history, work: { ...work, counted: newest } });
    resume({ newest, generation: newest, counted: newest, evolved });
  };

  /** Who drives, where that is the exercise's to say, and somebody else does. @returns {Partial<State>} */
  const ownHand = () => {
    const { exercise, student, ...run } = store.get();
    const { prepared } = /** @type {NonNullable<typeof student.base>} */ (student.base);
    const { driver, gains } = prepared;
    const isOther = unreachable(run, exercise, prepared).some((name) => name !== 'generation');
    return isOther && driver ? { driver, handGains: gains, found: 'hand', gainErrors: noErrors } : {};
  };
  return { ownOf, ownHand, prepare };
}

/** Back to what was there before, and to what a gesture ends with. @param {Basis} basis @param {ReturnType<typeof createResume>} resume @param {() => void} prepare */
function createReturns(basis, resume, prepare) {
  const { store, settle, nextOf, onceBegun } = basis;
  const beginSettled = createSettled(basis);
  return {
    /** A posture or a setting is let go. @param {Restart} restart */
    release(restart) {
      const before = store.get();
      const { next } = before.computing ?? {};
      const back = cameBackTo(asked(before));
      store.update({ dragging: false, versions: afterDrag(before) });
      if (next?.dragging)
        beginSettled({ ...next, dragging: false, versions: afterDrag(asked(before)) }, restart);
      else settle();
      onceBegun(() => {
        if (back) {
          store.update({ restart: back.reached.restart });
          resume(back.reached);
        }
        prepare();
      });
    },

    /** @param {Restart} restart @param {typeof undone} stepOf */
    goTo(restart, stepOf) {
      const now = asked(store.get());
      const step = stepOf(now);
      if (!step || now.dragging) return;
      const { version, versions } = step;
      const { preset, experiment, hand, reached } = version;
      const patch = hand && { ...hand, gainErrors: noErrors };
      // Other gains alone begin nothing.
      if (patch && !store.get().computing?.next && isSameTask(now, version)) {
        // They have been driven, and counted.
        const work = { ...store.get().work, tried: String(version.hand?.handGains) };
        store.update({ ...patch, versions, work });
        return settle();
      }
      beginSettled({ ...nextOf(experiment, { preset, versions }), reached }, restart, patch);
      onceBegun(() => {
        resume(reached);
        prepare();
      });
    },
  };
}

/** @param {Basis} basis @param {CatchUp} catchUp */
export function createExperiments(basis, catchUp) {
  const { engine, store, attempt, nextOf, tryToBegin, shown, settle, onceBegun } = basis;

  const resume = createResume(basis, catchUp);
  const { ownOf, ownHand, prepare } = createOwn(basis, resume);
  const { release, goTo } = createReturns(basis, resume, prepare);
  const beginSettled = createSettled(basis);
  /** @type {Basis['begin']} */
  const begin = (...what) => {
    basis.begin(...what);
    onceBegun(prepare);
  };

  /** @param {string} path @param {string} text */
  const refuseSetting = (path, text) =>
    store.update({ settings: { ...store.get().settings, error: { path, text } } });

  return {
    ...createPostures({ ...basis, begin }),

    releasePosture: () => release('moved'),

    /** Other limits; start, goal and seed stay, so that only the limits differ. @param {Preset} preset */
    choosePreset(preset) {
      store.update({ evolving: false });
      attempt(() => {
        const { limits } = engine.experiment(preset);
        const next = engine.experiment({ ...asked(store.get()).experiment, limits });
        begin(next, 'limits', { preset, robot: shown() });
      });
    },

    /** @param {string} path @param {Value} value @param {boolean} dragging */
    changeSetting(path, value, dragging) {
      const { experiment, settings } = asked(store.get());
      if (valueAt(experiment, path) === value) {
        if (settings.error) store.update({ settings: { ...settings, error: null } });
        return;
      }
      const next = nextOf(withValue(experiment, path, value), { dragging });
      attempt(
        () => {
          try {
            tryToBegin(next, 'setting');
          } catch (error) {
            if (error instanceof Pending || isLost(error)) throw error;
            return refuseSetting(path, words.named(messageOf(error)));
          }
          if (!dragging) settle();
        },
        { what: 'begin', next },
      );
      onceBegun(prepare);
    },

    releaseSetting: () => release('setting'),

    refuseSetting,

    backToPreset() {
      attempt(() => beginSettled(nextOf(engine.experiment(asked(store.get()).preset)), 'setting'));
      onceBegun(prepare);
    },

    /** The experiment becomes the exercise's own again, and what drives in it, where nobody can choose that. */
    backToExercise() {
      const { base } = store.get().student;
      if (!base) return;
      attempt(() => {
        const own = /** @type {State['experiment']} */ (ownOf(store.get()));
        beginSettled(nextOf(own, { preset: base.preset }), 'given', ownHand());
      });
      onceBegun(prepare);
    },

    undo: () => goTo('undone', undone),

    redo: () => goTo('redone', redone),
  };
}

/** @param {Basis} basis */
function createPostures({ engine, store, places, begin, onceBegun, shown, refitBox, newBox }) {
  const ranges = new Map(engine.fields().map((field) => [field.path, field]));
  /** The nearest that may be, for a plane shows more. @param {string} path @param {Posture} posture @returns {Posture} */
  const allowed = (path, { x, y, theta }) => {
    const within = (/** @type {string} */ axis, /** @type {number} */ value) => {
      const { min, max } = /** @type {{ min: number, max: number }} */ (ranges.get(`${path}.${axis}`));
      return Math.min(Math.max(value, min), max);
    };
    return { x: within('x', x), y: within('y', y), theta };
  };

  /** Drives from a start that evolution does not see, or again from its own. @param {Posture | null} wanted */
  const tryStart = (wanted) => {
    const { trial } = store.get();
    const start = wanted && allowed('starts[]', wanted);
    store.update({ trial: trialFrom(start, trial), robot: shown() });
    refitBox();
  };

  return {
    /** @param {End} end */
    postureOf: (end) => endsOf(asked(store.get()))[end],

    tryStart,

    /** @param {End} end @param {Posture} wanted @param {boolean} dragging */
    movePosture(end, wanted, dragging) {
      const now = asked(store.get());
      const { experiment, trial, page } = now;
      const posture = allowed(end === 'start' ? 'starts[]' : 'goal', wanted);
      if (isSame(endsOf(now)[end], posture)) return;
      if (end === 'start' && places.triesStarts(page)) {
        const start = isSame(experiment.starts[0], posture) ? null : posture;
        store.update({ trial: trialFrom(start, trial), dragging });
      } else {
        const moved =
          end === 'goal' ? { goal: posture } : { starts: [posture, ...experiment.starts.slice(1)] };
        begin({ ...experiment, ...moved }, 'moved', { dragging });
      }
      if (!dragging) refitBox();
    },

    /** Start and goal of the paper. */
    restorePostures() {
      const { experiment, preset, trial } = asked(store.get());
      if (trial.start) return tryStart(null);
      const { starts, goal } = engine.experiment(preset);
      begin({ ...experiment, starts, goal }, 'moved');
      onceBegun(() => {
        store.update({ robot: shown() });
        newBox();
      });
    },
  };
}
