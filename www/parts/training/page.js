// The part of the page that evolves on many starts and tests on others, and what its controls do.
/** @import { Posture } from '../../core/engine.js' */
/** @import { State } from '../../run/state.js' */
/** @import { RowName } from './request.js' */
/** @import { TrainingState } from './state.js' */
/** @import { Row } from './table.js' */
import './style.css';
import './places.css';
import { html, nothing, render } from 'lit-html';
import { lengths, trainingSlice } from './state.js';
import { byIdIn } from '../../kit/elements.js';
import { selectOf } from '../../kit/fields.js';
import { unless, unlessDouble } from '../../kit/templates.js';
import { createSection } from '../section.js';
import { remember, watch } from '../../kit/memo.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { hidesPaper } from '../../run/exercise.js';
import { isFree } from '../../run/guard.js';
import { isAtEdge } from '../around.js';
import { changesOf } from '../changes.js';
import { hasMovingReference } from '../../core/reference.js';
import { createPicture, signs } from './picture.js';
import { createTraining, evolvedFor, furthestOf, handOf } from './request.js';
import { circleCount, gridCount, isSet, setNames, unseenCount, unseenRadius } from './sets.js';
import { rangesOf, seedCount } from './spread.js';
import { tableOf } from './table.js';

const { texts } = words;
const lengthChoices = lengths.map(
  (length) => /** @type {const} */ ([length, words.generationsChoice(length)]),
);

/** @param {import('../part.js').Tools} parts @returns {import('../part.js').Page} */
export function createPage({ engine, store, actions, paper }) {
  const element = createSection('training');
  const training = createTraining(engine, store, paper);
  const { update } = trainingSlice.at(store);
  const rowsOf = createRows();

  const { pick, tryFrom, evolve, workIfWanted } = createEvents({ store, actions }, training, rowsOf);
  const changed = watch();
  /** @param {State} state @param {readonly Row[]} rows @param {readonly [string, string]} titles @param {string} readout */
  const show = (state, rows, titles, readout) => {
    if (changed(trainingSlice.of(state), state.experiment, rows, ...titles, readout))
      render(
        sight(state, rows, titles, readout, { choose: pick, evolve, spread: training.spread, update }),
        element,
      );
  };
  show(store.get(), rowsOf(store.get()), ['', ''], '');
  const pictures = ['seen', 'unseen'].map((name) =>
    createPicture(byIdIn(element, `training-${name}`), {
      radius: unseenRadius,
      onTry: tryFrom,
      onSize: store.redraw,
    }),
  );

  return {
    element,
    retry: training.retry,
    draw(state, { driving }) {
      const sets = training.setsOf(state.experiment);
      const rows = rowsOf(state);
      const chosen = chosenOf(state);
      const result = rows.find(({ name }) => name === chosen)?.result ?? null;
      training.follow(state);
      workIfWanted(state);

      const own = isSet(chosen) ? sets[chosen] : sets.one;
      const follows = hasMovingReference(state.experiment);
      const fares = follows ? null : result;
      const seen = fares?.training ?? { starts: result?.training.starts ?? own, arrived: null };
      const unseen = fares?.unseen ?? { starts: sets.unseen, arrived: null };
      const { start } = state.trial;
      show(
        state,
        rows,
        [
          words.trainingTitle(chosen, fares, seen.starts.length),
          words.unseenTitle(fares, unseen.starts.length),
        ],
        start ? words.readout(start, lab.outcomeText(driving)) : '',
      );
      // What was evolved for another goal is shown around that goal.
      const { evolved } = trainingSlice.of(state);
      // One start fills no picture; once others are beside it to compare, both keep their sizes.
      element.classList.toggle('of-one', !evolved && seen.starts.length === 1);
      const { goal } = isSet(chosen) && evolved ? evolved.experiment : state.experiment;
      for (const [i, { starts, arrived }] of [seen, unseen].entries())
        pictures[i].draw({ starts, arrived, goal, tried: start, driving, theme: state.theme });
    },
  };
}

/** @param {Pick<import('../part.js').Tools, 'store' | 'actions'>} tools @param {ReturnType<typeof createTraining>} training @param {(state: State) => Row[]} rowsOf */
function createEvents({ store, actions }, training, rowsOf) {
  /** Drives with the gains of a row, from the start that is tried now. @param {RowName} name */
  const choose = (name) => {
    const state = store.get();
    const row = rowsOf(state).find((one) => one.name === name);
    const isPapers = name === 'paper-ep' || name === 'paper-arbitrary';
    /** @type {readonly import('../../run/exercise.js').Group[]} */
    const groups = isPapers ? ['drives', 'paper'] : ['gains'];
    if ((row?.result || isPapers) && !groups.every((group) => isFree(state, group))) return;
    trainingSlice.update(store, { chosen: name });
    if (!row?.result) return;
    if (isPapers) actions.chooseDriver(name);
    else {
      trainingSlice.update(store, { byHand: handOf(state) });
      actions.driveGains(row.result.gains, isSet(name) ? 'training' : 'hand');
      actions.driveAgain();
    }
    actions.tryStart(store.get().trial.start);
  };

  /** @param {Posture} start */
  const tryFrom = (start) => {
    if (isAtEdge(trainingSlice.of(store.get()))) return;
    choose(chosenOf(store.get()));
    actions.tryStart(start);
  };

  /** The row that nobody chose: it is that of what evolved last. @type {RowName | null} */
  let led = null;

  /** @param {RowName | null} [usual] Which row drives then, if none was chosen; else the one that comes furthest. */
  const evolve = async (usual) => {
    const before = store.get();
    const own = trainingSlice.of(before);
    if (own.progress !== null) return training.cancel();
    if (isAtEdge(own) || !(await training.evolve())) return;
    // The newest gains drive, unless those of somebody else were chosen, or have come meanwhile.
    const now = store.get();
    const { chosen, evolved } = trainingSlice.of(now);
    const isUnchosen = chosen === null || chosen === led;
    const isOther = now.driver !== before.driver || now.handGains !== before.handGains;
    if (isUnchosen ? isOther || now.experiment !== before.experiment : isOther && now.found !== 'training')
      return;
    const next = isUnchosen ? (usual ?? (evolved && furthestOf(evolved.results))) : chosen;
    if (now.page !== 'training' || !next || !isSet(next)) return;
    choose(next);
    if (isUnchosen && !usual) led = next;
  };

  /** Somebody chooses a row. @param {RowName} name */
  const pick = (name) => {
    led = null;
    choose(name);
  };

  /** What was asked for elsewhere, unless it is there, or once what is under way is done. @param {State} state */
  const workIfWanted = (state) => {
    const { wanted, progress } = trainingSlice.of(state);
    if (!wanted || progress !== null) return;
    trainingSlice.update(store, { wanted: null });
    if (wanted === 'spread') training.spread();
    else if (evolvedFor(state)) choose('circle');
    else evolve('circle');
  };

  return { pick, tryFrom, evolve: () => evolve(), workIfWanted };
}

/** The row that drives, if one does; else the one that was chosen. @param {State} state @returns {RowName} */
function chosenOf(state) {
  const { chosen, evolved } = trainingSlice.of(state);
  const { driver, handGains } = state;
  // Of what has not evolved yet one sees the starts.
  if (chosen && isSet(chosen) && !evolved) return chosen;
  if (driver === 'paper-ep' || driver === 'paper-arbitrary') return driver;
  if (driver === 'hand') {
    const drives = (/** @type {RowName | null} */ name) =>
      name !== null && isSet(name) && String(evolved?.results[name].gains) === String(handGains);
    return drives(chosen) ? /** @type {RowName} */ (chosen) : (setNames.find(drives) ?? 'hand');
  }
  return chosen ?? (evolved ? furthestOf(evolved.results) : hidesPaper(state) ? 'one' : 'paper-ep');
}

/** Rows of gains that were not evolved here: always the same lists, so that rows are made anew only when others are in sight. */
const others = /** @type {const} */ ({ none: [], papers: ['paper-ep', 'paper-arbitrary'], hands: ['hand'] });

function createRows() {
  const rows = remember(
    /** @param {TrainingState['evolved']} evolved @param {TrainingState['given']} given @param {State['experiment']} experiment @param {readonly RowName[]} papers @param {readonly RowName[]} hands @returns {Row[]} */
    (evolved, given, experiment, papers, hands) => {
      const isOld = evolved !== null && changesOf(evolved.experiment, experiment).length > 0;
      const isOldGiven = given !== null && given.spec.experiment !== experiment;
      const counts = { one: experiment.starts.length, circle: circleCount, grid: gridCount };
      /** @param {RowName} name @param {number} count @param {Row['result'] | undefined} result @param {boolean} old */
      const row = (name, count, result, old) => ({
        name,
        text: words.rowName(name, count),
        result: result ?? null,
        old,
      });
      return [
        ...setNames.map((name) => row(name, counts[name], evolved?.results[name], isOld)),
        ...[...papers, ...hands].map((name) => row(name, 0, given?.results[name], isOldGiven)),
      ];
    },
  );
  return (/** @type {State} */ state) =>
    rows(
      trainingSlice.of(state).evolved,
      trainingSlice.of(state).given,
      state.experiment,
      hidesPaper(state) ? others.none : others.papers,
      handOf(state) ? others.hands : others.none,
    );
}

/**
 * @param {State} state @param {readonly Row[]} rows @param {readonly [string, string]} titles Of the pictures. @param {string} readout Of the start that is tried.
 * @param {{ choose: (name: RowName) => void, evolve: () => void, spread: () => void, update: (patch: Partial<TrainingState>) => void }} on
 */
function sight(state, rows, titles, readout, { choose, evolve, spread: onSpread, update }) {
  const { experiment } = state;
  const own = trainingSlice.of(state);
  const { evolved, spread, message, cancelled, progress, generations } = own;
  const runs = progress !== null;
  const isVain = isAtEdge(own) && !runs;
  const hasNoSeeds = runs || !evolved || spread !== null;
  const changes = evolved ? changesOf(evolved.experiment, experiment) : [];
  const status = [
    message ? words.failed(message, evolved !== null) : '',
    cancelled ? words.cancelled(evolved !== null) : '',
    changes.length > 0 ? words.outOfDate(changes) : '',
  ].filter((text) => text !== '');
  const follows = hasMovingReference(experiment);
  return html`
    <div class="heading">
      <h2 id="training-title">${texts.trainingTitle}</h2>
      <p id="training-note" class="muted" .hidden=${status.length > 0}>${evolved ? words.evolvedNote(evolved) : ''}</p>
      <p id="training-status" class="training-status" role="status">${status.join(' ')}</p>
    </div>
    <div class="bar training-controls">
      <button id="training-evolve" type="button" class=${runs ? '' : 'primary'} data-other=${words.evolveAll}
        aria-disabled=${String(isVain)} @click=${unlessDouble(evolve)}>${
          runs ? words.cancel : evolved ? words.evolveAgain : words.evolveAll
        }</button>
      ${selectOf('training-generations', texts.trainingGenerations, lengthChoices, generations, (chosen) => update({ generations: chosen }))}
      <button id="training-seeds" type="button" class="not-in-small-figure" title=${words.seedsHint(seedCount)} aria-disabled=${String(hasNoSeeds)}
        @click=${unless(hasNoSeeds, onSpread)}>${words.seedsButton(seedCount)}</button>
      <progress id="training-progress" max="1" class=${runs ? '' : 'visually-hidden'}
        aria-label=${texts.trainingProgress} .value=${progress ?? 0}></progress>
    </div>
    <p id="training-finding" class=${`training-finding not-in-small-figure ${changes.length > 0 ? 'old' : ''}`} aria-live=${evolved || runs ? 'polite' : 'off'}>${findingOf(state, rows)}</p>
    ${tableOf(rows, spread, chosenOf(state), { unseen: unseenCount, own: experiment.starts.length, follows }, choose)}
    <div class="training-pictures picture" data-picture="training" data-name=${words.texts.trainingPicture}>
      <p id="training-seen-title">${titles[0]}</p>
      <p id="training-unseen-title">${titles[1]}</p>
      <canvas id="training-seen" role="application" tabindex="0" aria-describedby="training-readout" aria-label=${words.pictureLabel(titles[0])}></canvas>
      <canvas id="training-unseen" role="application" tabindex="0" aria-describedby="training-readout" aria-label=${words.pictureLabel(titles[1])}></canvas>
    </div>
    <p id="training-readout" class="visually-hidden" aria-live="polite">${readout}</p>
    <p id="training-key" class="muted training-key not-in-figure not-in-sight" data-picture="training">${follows ? nothing : html`${sign('arrives')} ${words.signs.arrives} ${sign('misses')} ${words.signs.misses} `}${isVain ? nothing : html`<span class="hint">${words.pressOne}</span>`} ${words.key(
      unseenCount,
      unseenRadius,
      experiment.horizon,
    )}</p>`;
}

/** What was found, or what there is to find out. @param {State} state @param {readonly Row[]} rows */
function findingOf(state, rows) {
  const { experiment } = state;
  const { evolved, spread, message } = trainingSlice.of(state);
  if (evolved) {
    if (hasMovingReference(evolved.experiment)) return words.followed(evolved);
    if (!spread) return words.lesson(evolved);
    return words.spreadText(rangesOf(spread), unseenCount, evolved.results.one.training.starts.length);
  }
  if (hasMovingReference(experiment)) return words.tracking;
  const ep = rows.find(({ name }) => name === 'paper-ep');
  if (!ep) return words.invitation(experiment.starts.length);
  if (ep.result) return words.question(ep.result);
  return message ? '' : words.driving;
}

/** @param {keyof typeof signs} name */
const sign = (name) =>
  html`<svg class="training-sign ${name}" viewBox="-11 -11 22 22" aria-hidden="true"><path d=${signs[name]}></path></svg>`;
