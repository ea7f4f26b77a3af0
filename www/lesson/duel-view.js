// The duel on the page: first your own drives until they are locked in, then how the three compare.
import { html, render } from 'lit-html';
import { create } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { createSwatch } from '../kit/swatch.js';
import { noTrial } from '../run/state.js';
import { messageOf } from '../words/errors.js';
import { isDuelOf, judge, lockedIn, longestOf, lowestOf, nextSeed, roundOf, scoreOf } from './duel.js';
import { createDuelPlot, looks } from './duel-plot.js';
import { paragraphs } from './prose.js';
import { noTally, progressSlice } from './state.js';
import { tallyOf } from './tally.js';

/** @import { Verdict } from './words/common.js' */
/** @import { Duel } from './duel.js' */
/** @import { Block, Live, Tools } from './page.js' */
/** @typedef {Pick<typeof import('./words/en/duel.js').duel, 'duel' | 'texts'>} Words */

/** Under which name the prediction is kept. */
const prediction = 'duel.ahead';

const { update } = progressSlice;

/** Your drives so far, and the button that locks them in. @param {Tools} tools @param {Words} words @returns {Block} */
export function createDuelDrives({ store }, { duel: words }) {
  const element = create('section', 'duel');
  element.setAttribute('aria-label', words.drivesLabel);
  const startOver = () => {
    const { [prediction]: _, ...answers } = progressSlice.of(store.get()).answers;
    update(store, { answers, tally: noTally, duel: null });
  };
  const changed = watch();
  return {
    element,
    draw(live) {
      const { experiment } = live.scene;
      const { duel } = progressSlice.of(live.state);
      const tally = tallyIn(live);
      const { population } = live.state.experiment.evolution;
      if (!changed(duel, tally, population, experiment)) return;
      const { costs } = duel ?? tally;
      const status = duel
        ? isDuelOf(duel, experiment)
          ? words.locked
          : words.elsewhere
        : words.enough(costs.length, population);
      const lock = () => update(store, { duel: lockedIn(tally, experiment) });
      element.classList.toggle('locked', duel !== null);
      render(
        html`<div class="duel-numbers">
            <p class="duel-number">
              <span>${words.drivesName}</span><strong id="duel-drives">${costs.length}</strong>
            </p>
            <p class="duel-number">
              <span>${words.bestName}</span
              ><strong id="duel-best">${costs.length === 0 ? '…' : words.cost(lowestOf(costs))}</strong>
            </p>
          </div>
          <p id="duel-status" class="muted">${status}</p>
          <div class="bar">
            <button id="duel-lock" type="button" class="primary" @click=${lock}
              ?hidden=${duel !== null} ?disabled=${costs.length === 0}>${words.lock}</button>
            <button id="duel-new" type="button" @click=${startOver}
              ?hidden=${costs.length === 0}>${words.startOver}</button>
          </div>`,
        element,
      );
    },
  };
}

/** @param {Live} live */
const tallyIn = ({ state, scene }) => tallyOf(progressSlice.of(state).tally, scene.experiment);

/** What is locked in, or what the prediction locks in. @param {Live} live @returns {Duel} */
export const duelIn = (live) =>
  progressSlice.of(live.state).duel ?? lockedIn(tallyIn(live), live.scene.experiment);

/** How the three compare, once it is predicted. @param {Tools} tools @param {Words} words @returns {Block} */
export function createDuelResult({ store, engine, actions }, { duel: words, texts }) {
  const rounds = createRounds({ store, engine, actions });
  const goOn = (/** @type {Duel} */ duel) => update(store, { duel: { ...duel, goesOn: !duel.goesOn } });
  const watchIt = (/** @type {Duel} */ { experiment }, /** @type {Verdict} */ { seed, generation }) => {
    const { page, lesson, preset, handGains, found, pins, exercise } = store.get();
    actions.openLinked(
      {
        ...{ page, lesson, preset, handGains, found, pins, exercise, generation, parts: {} },
        experiment: { ...experiment, evolution: { ...experiment.evolution, seed } },
        driver: 'evolved',
        trial: noTrial,
      },
      [],
    );
  };
  const picture = create('div', 'duel-plot');
  picture.id = 'duel-plot';
  picture.setAttribute('role', 'img');
  const plot = createDuelPlot(picture, words);
  // What follows from it would give the answer away.
  const after = create('div', 'prose', ...paragraphs(texts.after, (link) => `#${link}`));
  const element = create('div', 'duel-result');
  element.hidden = true;
  const changed = watch();

  return {
    element,
    draw(live) {
      const { theme, evolving } = live.state;
      const progress = progressSlice.of(live.state);
      const predicted = progress.answers[prediction] !== undefined;
      if (predicted && !evolving) rounds.begin(duelIn(live));
      const { duel } = progress;
      const round = duel?.rounds.at(-1);
      if (!changed(duel, predicted, theme)) return;
      element.hidden = !predicted || !duel || !round;
      if (!predicted || !duel || !round) return;
      const verdict = judge(duel, round);
      const sentence = words.sentence(verdict);
      const later = duel.goesOn ? words.later(verdict) : '';
      render(
        html`<section class="duel" aria-label=${words.resultLabel}>
            ${tableOf(verdict, words)}
            <p id="duel-sentence" class="duel-sentence" role="status">${sentence}</p>
            <p id="duel-later" role="status">${later}</p>
            ${picture}
            <div class="bar">
              <button id="duel-further" type="button" class="primary" @click=${() => goOn(duel)}>${
                duel.goesOn ? words.backTo(verdict.drives) : words.goOn(longestOf(duel))
              }</button>
              <button id="duel-again" type="button" @click=${() => rounds.run()}>${words.anotherSeed}</button>
              <button id="duel-watch" type="button" @click=${() => watchIt(duel, verdict)}>${words.watch(
                verdict,
              )}</button>
            </div>
            <p id="duel-score" class="muted">${words.score(duel.rounds.length, scoreOf(duel))}</p>
          </section>
          ${after}`,
        element,
      );
      picture.setAttribute('aria-label', words.plotLabel(`${sentence} ${later}`));
      plot.draw(duel, theme);
    },
  };
}

/** The three, lowest J first. @param {Verdict} verdict @param {Words['duel']} words */
function tableOf(verdict, words) {
  const { costs, drives, given, winner } = verdict;
  const rows = /** @type {const} */ (['you', 'evolution', 'random'])
    .map((name) => ({ name, cost: costs[name], driven: name === 'you' ? drives : given }))
    .sort((a, b) => a.cost - b.cost);
  const wins = (/** @type {string} */ name) => name === winner || (winner === 'both' && name !== 'you');
  return html`<table id="duel-table" class="duel-table">
    <caption>${words.caption(verdict)}</caption>
    <thead><tr>${words.heads.map((text) => html`<th scope="col">${text}</th>`)}</tr></thead>
    <tbody>
      ${rows.map(
        ({ name, cost, driven }) => html`<tr class=${wins(name) ? 'wins' : ''} data-who=${name}>
          <th scope="row">${createSwatch(looks[name])}${words.names[name]}</th>
          <td>${driven}</td>
          <td class="cost">${words.cost(cost)}</td>
        </tr>`,
      )}
    </tbody>
  </table>`;
}

/** Asks the workers for evolution and random search. @param {Pick<Tools, 'store' | 'engine' | 'actions'>} tools */
function createRounds({ store, engine, actions }) {
  /** @type {Duel | null} */
  let asked = null;
  /** @param {Duel} duel */
  const ask = async (duel) => {
    if (asked === duel) return;
    asked = duel;
    try {
      const round = await roundOf(engine, duel, nextSeed(duel));
      if (progressSlice.of(store.get()).duel === duel)
        update(store, { duel: { ...duel, rounds: [...duel.rounds, round] } });
    } catch (error) {
      asked = null;
      actions.say(messageOf(error));
    }
  };
  return {
    /** Locks in, and runs the first seed. @param {Duel} duel */
    begin(duel) {
      if (duel.rounds.length > 0) return;
      if (progressSlice.of(store.get()).duel !== duel) update(store, { duel });
      ask(duel);
    },
    run() {
      const { duel } = progressSlice.of(store.get());
      if (duel) ask(duel);
    },
  };
}
