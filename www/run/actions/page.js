// Which part of the page is open, what stands beside it, and what a link opens.
/** @import { MakerState } from '../exercise.js' */
/** @import { State } from '../state.js' */
/** @import { Basis } from './basis.js' */
import { isHiddenWithPaper, noExercise, shownExercise, wayOf, workId } from '../exercise.js';
import { noErrors, usualTried } from '../first.js';
import { isFree } from '../guard.js';
import { playsPhases } from '../pace.js';
import { preparedAs } from '../prepared.js';
import { asked, endsOf, newWork, noTrial, spentOf, trialIn } from '../state.js';
import { afterHand, noVersions } from '../undo.js';
import { drawnFor } from '../variant.js';

/** @typedef {Pick<State, 'page' | 'lesson' | 'preset' | 'experiment' | 'generation' | 'driver' | 'handGains' | 'found' | 'trial' | 'pins' | 'exercise' | 'student'>} LinkedRun What defines a run. */
/** What a link opens: a run, and of each part what the link says of it. @typedef {LinkedRun & { parts: Readonly<Record<string, object>> }} Opened */

/** @param {Basis} basis */
export const createOpenPage =
  ({ store, places, shown, refitBox }) =>
  (/** @type {string} */ page) => {
    const before = store.get();
    if (page === before.page) return;
    const trial = trialIn(places, page, null, before.tried);
    store.update({ page, trial, ...(trial !== noTrial && { robot: shown() }) });
    // Phases that nobody sees need not be played.
    if (page !== places.phases && playsPhases(store.get())) store.update({ evolving: false });
    if (before.trial !== noTrial) refitBox();
  };

/** Whether others’ gains take the place of those that drive by hand, which in a step of the lesson may be the step's own. @param {State} before @param {Pick<LinkedRun, 'driver' | 'handGains'>} run */
const takesHand = ({ driver, handGains, lesson, work }, run) =>
  driver === 'hand' &&
  (lesson === 0 || work.tries > 0) &&
  (run.driver !== 'hand' || String(run.handGains) !== String(handGains));

/** Whether a step of the lesson is opened, from another or from elsewhere. @param {State} before @param {Pick<LinkedRun, 'lesson'>} run */
const entersStep = (before, { lesson }) => lesson > 0 && lesson !== before.lesson;

/**
 * The work on an exercise that is opened again, as by the way back, goes on: its time and its drives.
 * @param {State | undefined} left @param {Pick<LinkedRun, 'experiment' | 'handGains' | 'student'>} run @param {number} generation
 */
function workOf(left, { handGains, student, experiment }, generation) {
  const work = newWork(String(handGains), generation, student.spent);
  // What was handed in is looked at.
  if (student.handin) return work;
  if (!left)
    return {
      ...work,
      begun: student.begun ?? work.begun,
      spent: Math.max(work.spent, student.made ?? 0),
    };
  const { begun, tries } = left.work;
  // The link may come from where more was done.
  const least = Math.max(work.spent, tries * left.experiment.starts.length);
  if (spentOf({ ...left, generation }) < least) return { ...work, begun, spent: least };
  // What has evolved here and is evolved again counts once.
  const isSame = JSON.stringify(experiment) === JSON.stringify(left.experiment);
  const counted = isSame ? Math.max(generation, left.history.length - 1, left.work.counted) : generation;
  return { ...work, begun, counted, spent: spentOf({ ...left, generation: counted }) };
}

/** What a link holds takes the place of the run, or what is drawn for a student. @param {Basis} basis @param {(newest: number, generation: number, goesOn?: boolean) => void} catchUp */
export function createOpening(basis, catchUp) {
  const { engine, store, places, attempt, forget, nextOf, tryToBegin, shown, newBox } = basis;
  const nearEnd = createNearEnd(basis);
  /** Nobody has seen what was there before. */
  let isFirst = true;
  /** Each exercise as it was left, not a step of the lesson meanwhile. @type {Map<string, State>} */
  const left = new Map();

  return {
    /**
     * Begins what a link holds, and evolves to its generation or further.
     * @param {Opened} opened @param {readonly string[]} problems @param {number} [newest] @param {boolean} [goesOn] Whether it evolves on from there.
     */
    openLinked({ parts, experiment, generation, ...run }, problems, newest = generation, goesOn = false) {
      const hasNoPast = isFirst;
      isFirst = false;
      forget();
      store.update({ evolving: false });
      attempt(() => {
        const before = store.get();
        const id = workId(before);
        if (id && !before.student.handin && (before.lesson === 0 || left.get(id)?.lesson !== 0))
          left.set(id, before);
        const kept = places.triesDisturbance(run.page) ? usualTried : before.tried;
        const tried = run.trial.disturbance ?? kept;
        const slices = places.slices.map((slice) => [slice.name, slice.opened(before, parts[slice.name])]);
        /** @type {Partial<State>} */
        const patch = {
          ...run,
          lastStep: run.lesson || before.lastStep,
          gainErrors: noErrors,
          untilError: '',
          work: workOf(left.get(workId(run)), { ...run, experiment }, generation),
          trial: trialIn(places, run.page, run.trial.start, tried),
          tried,
          slices: { ...before.slices, ...Object.fromEntries(slices) },
          robot: shown(),
          // Nothing leads back out of an exercise, or before the step of the lesson that is opened; and what is locked is not open.
          ...(hasNoPast || run.exercise !== noExercise || entersStep(before, run)
            ? { versions: noVersions }
            : takesHand(before, run) && { versions: afterHand(asked(before)) }),
          settings: {
            open: before.settings.open && wayOf(run.exercise, 'settings') === 'free',
            error: null,
          },
        };
        tryToBegin(nextOf(experiment, patch), 'begin', patch);
        newBox(() => [...nearEnd(), ...cornerIn(store.get())]);
        catchUp(newest, generation, goesOn);
        // Who pressed Run while it was still to begin.
        if (before.evolving && !store.get().catchingUp) store.update({ evolving: true });
        if (problems.length > 0) store.update({ message: problems.join(' ') });
      });
    },

    /** Who works on the exercise says so: then what is drawn for each student is. @param {string} who */
    setWho(who) {
      const state = store.get();
      const { exercise, experiment, preset, student, work } = state;
      if (exercise.vary.length === 0 || student.who) {
        store.update({ student: { ...student, who } });
        return;
      }
      forget();
      attempt(() => {
        const base = student.base ?? { preset, experiment, prepared: preparedAs(state, exercise) };
        const drawn = engine.experiment(drawnFor(base.experiment, exercise.vary, who));
        // What is drawn for a student is not taken back.
        tryToBegin(nextOf(drawn, { preset: base.preset, versions: noVersions }), 'begin', {
          student: { ...student, who, base },
          // The generations of the exercise are evolved again, and counted then.
          work: {
            ...work,
            spent: spentOf({ ...state, generation: work.counted, work: { ...work, tries: 0 } }),
            counted: work.opened,
          },
          robot: shown(),
        });
        newBox();
        if (work.opened > 0) catchUp(work.opened, work.opened);
      });
    },
  };
}

/** Where the robot in ink comes to rest, if that is not far away. @param {Basis} basis */
const createNearEnd =
  ({ store, drivenRun }) =>
  () => {
    const { experiment, trial } = store.get();
    const run = drivenRun();
    const last = run.time.length - 1;
    const end = { x: run.x[last], y: run.y[last], theta: run.theta[last] };
    const [start, goal] = [trial.start ?? experiment.starts[0], experiment.goal];
    const away = Math.hypot(end.x - goal.x, end.y - goal.y);
    return away < Math.hypot(start.x - goal.x, start.y - goal.y) ? [end] : [];
  };

/** Beside the words of the lesson the lab shows x_e and y_e too: the corner in which they meet at the start. @param {State} state */
function cornerIn(state) {
  if (state.lesson === 0 || state.page !== 'lab') return [];
  const { start, goal } = endsOf(state);
  const [cos, sin] = [Math.cos(goal.theta), Math.sin(goal.theta)];
  const behind = (goal.x - start.x) * cos + (goal.y - start.y) * sin;
  return [{ ...goal, x: goal.x - behind * cos, y: goal.y - behind * sin }];
}

/** What is open, and what is said. @param {Basis} basis @param {(page: string) => void} openPage */
export function createPage({ store }, openPage) {
  return {
    /** @param {string} page */
    openPage(page) {
      store.update({ lesson: 0 });
      openPage(page);
    },

    /** @param {string} message */
    say(message) {
      store.update({ message });
    },

    /** Where the way to Share may be gone. @param {() => void} open */
    share(open) {
      open();
    },

    /** @param {boolean} open */
    openSettings(open) {
      const { maker } = store.get();
      // The two stand in the same place.
      store.update({ settings: { open, error: null }, maker: { ...maker, open: maker.open && !open } });
    },

    /** @param {Partial<MakerState>} patch */
    makeExercise(patch) {
      const { settings, maker } = store.get();
      const made = { ...maker, ...patch };
      store.update({ maker: made, settings: { ...settings, open: false } });
      // Nobody could pause it.
      if (!isFree(store.get(), 'run') && !store.get().catchingUp) store.update({ evolving: false });
      if (isHiddenWithPaper(shownExercise(store.get()), 'lesson')) store.update({ lesson: 0 });
    },

    /** @param {State['size']} size */
    setSize(size) {
      store.update({ size });
    },

    /** Colours have changed. */
    changeTheme() {
      store.update({ theme: store.get().theme + 1 });
    },
  };
}
