// The part of the page that evolves on many starts and tests on others, and what its controls do.
import { trainingSlice } from './state.js';
import { byId, write } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { training as words } from '../../words/index.js';
import { createPicture } from './picture.js';
import { changesOf, createTraining, handOf, lengths } from './request.js';
import { circleCount, gridCount, setNames, unseenCount, unseenRadius } from './sets.js';
import { createTable } from './table.js';

/** @typedef {import('../../run/actions/actions.js').Actions} Actions */
/** @typedef {import('../../core/engine.js').Posture} Posture */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/store.js').Store} Store */
/** @typedef {import('./request.js').RowName} RowName */
/** @typedef {import('./request.js').Result} Result */
/** @typedef {import('./state.js').TrainingState} TrainingState */
/** @typedef {import('./sets.js').SetName} SetName */
/** @typedef {import('./table.js').Row} Row */

/** @param {import('../part.js').Tools} parts @returns {import('../part.js').Page} */
export function createTrainingPage({ engine, store, actions, paper }) {
  const training = createTraining(engine, store, paper);
  const rowsOf = createRows();

  /** Drives with the gains of a row, from the start that is tried now. @param {RowName} name */
  const choose = (name) => {
    const state = store.get();
    const row = rowsOf(state).find((one) => one.name === name);
    trainingSlice.update(store, { chosen: name });
    if (!row?.result) return;
    if (name === 'paper-ep' || name === 'paper-arbitrary') actions.chooseDriver(name);
    else {
      trainingSlice.update(store, { byHand: handOf(state) });
      actions.driveGains(row.result.gains, isSet(name) ? 'training' : 'hand');
    }
    actions.tryStart(store.get().trial.start);
  };

  /** @param {Posture} start */
  const tryFrom = (start) => {
    choose(chosenOf(store.get()));
    actions.tryStart(start);
  };

  const evolve = async () => {
    if (trainingSlice.of(store.get()).progress !== null) return training.cancel();
    if (!(await training.evolve())) return;
    // The newest gains drive, unless those of somebody else were chosen.
    const { chosen } = trainingSlice.of(store.get());
    const next = chosen ?? 'circle';
    if (store.get().page === 'training' && isSet(next)) choose(next);
  };

  const table = createTable(byId('training-table'), choose);
  const pictures = ['seen', 'unseen'].map((part) => {
    const canvas = /** @type {HTMLCanvasElement} */ (byId(`training-${part}`));
    const onSize = () => store.redraw();
    return {
      canvas,
      title: byId(`training-${part}-title`),
      picture: createPicture(canvas, { radius: unseenRadius, onTry: tryFrom, onSize }),
    };
  });
  const controls = createControls(store, evolve);

  return {
    /** @param {State} state */
    draw(state) {
      const { goal } = state.experiment;
      const sets = training.setsOf(state.experiment);
      const rows = rowsOf(state);
      const chosen = chosenOf(state);
      const result = rows.find(({ name }) => name === chosen)?.result ?? null;
      training.follow(state);
      table.draw(rows, chosen, unseenCount);
      controls.draw(state, rows);

      const own = isSet(chosen) ? sets[chosen] : sets.one;
      const seen = result?.training ?? { starts: own, arrived: null };
      const unseen = result?.unseen ?? { starts: sets.unseen, arrived: null };
      const titles = [
        words.trainingTitle(chosen, result, own.length),
        words.unseenTitle(result, unseen.starts.length),
      ];
      // What was evolved for another goal is shown around that goal.
      const { evolved } = trainingSlice.of(state);
      const around = isSet(chosen) && evolved ? evolved.experiment.goal : goal;
      for (const [i, { starts, arrived }] of [seen, unseen].entries()) {
        const { canvas, title, picture } = pictures[i];
        write(title, titles[i]);
        canvas.setAttribute('aria-label', words.pictureLabel(titles[i]));
        picture.draw({ starts, arrived, goal: around, tried: state.trial.start, theme: state.theme });
      }
    },
  };
}

/** @param {RowName} name @returns {name is SetName} */
const isSet = (name) => setNames.some((set) => set === name);

/** @param {State} state @returns {RowName} */
const chosenOf = (state) => {
  const { chosen, evolved } = trainingSlice.of(state);
  return chosen ?? (evolved ? 'circle' : 'paper-ep');
};

function createRows() {
  const changes = remember(changesOf);
  const rows = remember(
    /** @returns {Row[]} */
    (
      /** @type {TrainingState['evolved']} */ evolved,
      /** @type {TrainingState['given']} */ given,
      /** @type {State['experiment']} */ experiment,
      /** @type {boolean} */ byHand,
    ) => {
      const isOld = evolved !== null && changes(evolved.experiment, experiment).length > 0;
      const counts = { one: experiment.starts.length, circle: circleCount, grid: gridCount };
      const names = /** @type {const} */ (['paper-ep', 'paper-arbitrary', ...(byHand ? ['hand'] : [])]);
      return [
        ...setNames.map((name) => ({
          name,
          text: words.rowName(name, counts[name]),
          result: evolved?.results[name] ?? null,
          old: isOld,
        })),
        ...names.map((name) => ({
          name: /** @type {RowName} */ (name),
          text: words.rowName(/** @type {RowName} */ (name), 0),
          result: given?.results[/** @type {RowName} */ (name)] ?? null,
          old: given !== null && given.spec.experiment !== experiment,
        })),
      ];
    },
  );
  return (/** @type {State} */ state) =>
    rows(
      trainingSlice.of(state).evolved,
      trainingSlice.of(state).given,
      state.experiment,
      handOf(state) !== null,
    );
}

/** @param {Store} store @param {() => void} onEvolve */
function createControls(store, onEvolve) {
  const button = byId('training-evolve');
  /** @type {HTMLSelectElement} */
  const generations = byId('training-generations');
  /** @type {HTMLProgressElement} */
  const progress = byId('training-progress');
  generations.replaceChildren(...lengths.map((one) => new Option(words.generationsChoice(one), String(one))));
  button.addEventListener('click', onEvolve);
  generations.addEventListener('change', () =>
    trainingSlice.update(store, { generations: Number(generations.value) }),
  );
  const changed = watch();

  return {
    /** @param {State} state @param {readonly Row[]} rows */
    draw(state, rows) {
      const { experiment } = state;
      const training = trainingSlice.of(state);
      if (!changed(training, experiment, rows)) return;
      const { evolved } = training;
      const runs = training.progress !== null;
      const changes = evolved ? changesOf(evolved.experiment, experiment) : [];
      const press = runs ? words.cancel : evolved ? words.evolveAgain : words.evolveAll;
      write(button, press);
      button.classList.toggle('primary', !runs);
      generations.value = String(training.generations);
      progress.classList.toggle('visually-hidden', !runs);
      progress.value = training.progress ?? 0;
      byId('training-note').textContent = evolved ? words.evolvedNote(evolved) : '';
      const status = [
        training.message ? words.failed(training.message, evolved !== null) : '',
        training.cancelled ? words.cancelled(evolved !== null) : '',
        changes.length > 0 ? words.outOfDate(changes) : '',
      ].filter((text) => text !== '');
      byId('training-status').textContent = status.join(' ');
      byId('training-note').hidden = status.length > 0;
      const ep = rows.find(({ name }) => name === 'paper-ep')?.result;
      const finding = byId('training-finding');
      finding.textContent = evolved ? words.lesson(evolved) : ep ? words.question(ep) : words.driving;
      finding.classList.toggle('old', changes.length > 0);
      byId('training-key').textContent = words.key(unseenCount, unseenRadius, experiment.horizon);
    },
  };
}
