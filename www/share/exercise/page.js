// An exercise as who follows the link sees it: the task at the top, and the controls that are locked or hidden.
/** @import { Places } from '../../parts/part.js' */
/** @import { Group } from '../../run/exercise.js' */
/** @import { Scene } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
import { tidyText } from '../../kit/text.js';
import { byId } from '../../kit/elements.js';
import { isEmbedded } from '../../kit/host.js';
import { once, watch } from '../../kit/memo.js';
import { showOn } from '../../lab/navigation.js';
import { createWaiting } from '../../lab/waiting.js';
import { parts } from '../../parts/parts.js';
import { exercise as words } from '../../words/index.js';
import { afterWords } from '../../words/pick.js';
import { load as loadHandIn } from '../handin/words/load.js';
import { load as loadWords } from '../words/load.js';
import { asksSomething, groupNames, isEmpty, noExercise, shownExercise, wayOf } from '../../run/exercise.js';
import { caughtUp } from '../../run/state.js';
import { createAway } from './away.js';
import { keepFromLinks, lock, lockAgain } from './locks.js';

/** Rows of the settings. @param {...string} paths How they begin. */
const settingsOf = (...paths) => `.setting:is(${paths.map((path) => `[data-of^="${path}"]`).join(', ')})`;
const ends = settingsOf('starts[0]', 'goal');
const seed = settingsOf('evolution.seed');
const fields = ':is(input, select, button)';
/** In the lesson's table of drives, the names that drive. @param {...string} entrants */
const standing = (...entrants) =>
  `.standing-name:is(${entrants.map((name) => `[data-entrant="${name}"]`).join(', ')})`;
const again = '#near-goal button';

/** A line that says why nothing happens. */
const alight = [
  {
    background: 'var(--hairline)',
    boxShadow: '0 0 0 5px var(--hairline)',
    color: 'var(--ink)',
    easing: 'ease-in',
  },
  {},
];

/** And where only a part of the exercise stays in sight, all of it is. */
const inSight = [{ top: '0px' }, { top: '0px' }];

/** Those of the lab, the lesson, the settings and Share. @type {Places} */
const own = {
  gains: { lock: `#gains, ${standing('gentle', 'hand')}`, hide: '#gains, #gains-note' },
  drives: { lock: '#drives, .standing-name', hide: '#drives' },
  paper: {
    lock: `#drives-paper-ep, #drives-paper-arbitrary, ${standing('ep', 'arbitrary')}`,
    // The page's own checks tell them.
    hide: '#drives label[data-choice^="paper"], #keys-checks, #keep-checks',
  },
  postures: {
    lock: `#handles, #restore-postures, ${ends} ${fields}, #settings-preset`,
    hide: `#handles, #postures .hint, ${ends}, #settings-preset`,
  },
  run: { lock: '#evolution-clock, #evolution-pace, #pause-evolution', hide: '#evolving, #pause-evolution' },
  seed: {
    lock: `#new-seed, ${seed} ${fields}, #settings-preset`,
    hide: `#new-seed, ${seed}, #settings-preset`,
  },
  clock: { lock: `#robot-clock, #push-clock, ${again}`, hide: `#robot-clock, #push-clock, ${again}` },
  settings: {
    lock: '#preset, #settings-button, #weights',
    hide: '#preset, #settings-button, #settings, #weights',
  },
  parts: {
    lock: '#pages a:not(#page-lesson)',
    // Those that were open before.
    hide: ['#pages a:not(#page-lesson)', ...parts.map(({ name }) => `section.${name}[hidden]`)].join(', '),
  },
  lesson: {
    lock: '#page-lesson, #lesson-step, #lesson a',
    hide: '#page-lesson, .lesson-head, .lesson-foot, .tries, .sheet-link, #lesson[hidden] > *',
  },
  share: { lock: '#keep-button', hide: '#keep-button, #keep, #code, #collect' },
};

/** What there is to do is loaded with the first exercise that asks for something. @param {import('../handin/work.js').WorkTools} tools */
function createWorkOnDemand(tools) {
  /** @type {ReturnType<typeof import('../handin/work.js').createWork> | null} */
  let work = null;
  const load = once(async () => {
    try {
      const { createWork } = await afterWords([loadWords, loadHandIn], () => import('../handin/work.js'));
      work = createWork(tools, byId('exercise-work'));
      tools.store.redraw();
    } catch (error) {
      const { element, fail } = createWaiting();
      byId('exercise-work').append(element);
      fail(error);
    }
  });
  return (/** @type {State} */ state, /** @type {Scene} */ scene) => {
    if (asksSomething(shownExercise(state)) || state.student.handin) load();
    work?.draw(state, scene);
  };
}

/** @param {import('../handin/work.js').WorkTools & { places: readonly Places[] }} tools `places` of the parts of the page. */
export function createExercise({ places, ...tools }) {
  const { store, engine, links } = tools;
  const work = createWorkOnDemand(tools);
  const all = [own, ...places];
  const section = byId('exercise');
  const [label, task, locks] = ['task-label', 'task', 'exercise-locks'].map((id) => byId(id));
  const leave = byId('exercise-leave');
  // In a small frame a long task scrolls.
  if (isEmbedded) section.tabIndex = 0;
  // What moves is written into no address: only who is about to press takes it along as it is now.
  const follow = () => {
    const link = links.linkOf({ ...caughtUp(store.get()), exercise: noExercise }, engine.experiment);
    leave.setAttribute('href', `#${link}`);
  };
  for (const type of ['pointerdown', 'focus', 'click']) leave.addEventListener(type, follow);
  for (const type of ['click', 'auxclick']) document.addEventListener(type, keepFromLinks, true);
  const keeper = createKeeper(all, store);

  const changed = watch();
  const refuses = watch();
  /** @type {Animation[]} */
  let glow = [];
  // Where it stays in sight, what is above the aim leaves it.
  const below = byId('exercise-work');
  const above = () => below.getBoundingClientRect().top - section.getBoundingClientRect().top;
  new ResizeObserver(() => section.style.setProperty('--above', `${above()}px`)).observe(section);
  return {
    /** @param {State} state @param {number} made How many parts of the page have been opened. @param {Scene} scene */
    draw(state, made, scene) {
      const exercise = shownExercise(state);
      work(state, scene);
      keeper.follow(state, made);
      if (refuses(state.refusals) && state.refusals > 0) {
        // A drag asks again in every frame.
        for (const light of glow) light.cancel();
        glow = [locks.animate(alight, 2000), section.animate(inSight, 2000)];
      }
      if (!changed(exercise, state.student.handin)) return;
      document.body.toggleAttribute('data-exercise', asksSomething(exercise));
      section.hidden = isEmpty(exercise) && state.student.handin === '';
      task.textContent = tidyText(exercise.task);
      label.hidden = task.textContent === '';
      task.hidden = label.hidden;
      const named = (/** @type {import('../../run/exercise.js').Way} */ way) =>
        groupNames.filter((group) => wayOf(exercise, group) === way).map((group) => words.groups[group]);
      locks.textContent = words.locksText(named('locked'), named('hidden'));
    },
  };
}

/** Keeps locked what is locked, and away what is hidden, also where a view makes it anew. @param {readonly Places[]} places @param {import('../../run/store.js').Store} store */
function createKeeper(places, store) {
  const away = createAway((element) => showOn([element], store.get().page));
  const changed = watch();
  let [locked, hidden] = ['', ''];

  /** @param {'lock' | 'hide'} kind @param {readonly Group[]} groups */
  const selectorOf = (kind, groups) =>
    places
      .flatMap((one) => groups.map((group) => one[group]?.[kind]))
      .filter((selector) => selector !== undefined)
      .join(', ');
  const found = (/** @type {string} */ selector) => (selector ? document.querySelectorAll(selector) : []);

  const keep = () => {
    away.take(hidden);
    for (const element of found(locked)) lock(element, true);
    observer.takeRecords();
  };
  /** Each once: what it was at last is what counts. @param {readonly MutationRecord[]} records */
  const heed = (records) => {
    const freed = records.flatMap(({ type, target }) => (type === 'attributes' ? [target] : []));
    for (const element of new Set(freed)) lockAgain(/** @type {Element} */ (element));
  };
  const observer = new MutationObserver((records) => {
    heed(records);
    keep();
  });

  return {
    /** @param {State} state @param {number} made How many parts of the page have been opened. */
    follow(state, made) {
      const exercise = shownExercise(state);
      // Each step of the lesson has controls of its own, and so has each part.
      if (!changed(exercise, state.page, state.lesson, made)) return;
      const of = (/** @type {import('../../run/exercise.js').Way[]} */ ...ways) =>
        groupNames.filter((group) => ways.includes(wayOf(exercise, group)));
      // What has just been drawn may have freed some.
      heed(observer.takeRecords());
      observer.disconnect();
      const isBack = away.bringBack();
      // What belongs to a hidden group and has to stay is locked.
      [locked, hidden] = [selectorOf('lock', of('locked', 'hidden')), selectorOf('hide', of('hidden'))];
      for (const element of found('[data-locked]'))
        if (!locked || !element.matches(locked)) lock(element, false);
      keep();
      if (locked || hidden)
        observer.observe(document.body, { childList: true, subtree: true, attributeFilter: ['disabled'] });
      // What is back is drawn once more.
      if (isBack) store.redraw();
    },
  };
}
