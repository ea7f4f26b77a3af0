// The duel on the page: first your own trials until they are locked in, then how the three compare.
import { html, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { createSwatch } from '../../kit/swatch.js';
import { gainsOf } from '../../run/drivers.js';
import { messageOf } from '../../words/errors.js';
import { lab } from '../../words/index.js';
import {
  isBeyond,
  isDuelOf,
  judge,
  lockedIn,
  longestOf,
  lowestOf,
  nextSeed,
  roundOf,
  scoreOf,
} from './duel.js';
import { createDuelPlot, looks } from './duel-plot.js';
import { marksOf } from './marks.js';
import { paragraphs } from '../prose.js';
import { progressSlice } from '../state.js';
import { createSwarm } from './swarm.js';
import { talliesBut, tallyOf, taskText } from './tally.js';
import shared from '../words/index.js';
import { yardOf } from './yard.js';

/** @import { Experiment } from '../../core/engine.js' */
/** @import { Verdict } from '../words/common.js' */
/** @import { Duel } from './duel.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** @typedef {Pick<typeof import('../words/en/duel.js').duel, 'duel' | 'texts'>} Words */

/** Under which name the prediction is kept. */
const prediction = 'duel.ahead';

const { update } = progressSlice;

/** The contest is about all starts around the goal. @param {Pick<Live, 'engine' | 'state'>} live */
const contestOf = ({ engine, state }) => yardOf(engine).experimentOf(state.experiment);

/** A drive by hand in the yard. @param {Live} live */
export function priceInYard({ engine, state }) {
  const yard = state.handGains && yardOf(engine).drive(state.experiment, state.handGains);
  if (!yard) return null;
  const { gains, cost, parked, runs, experiment } = yard;
  return { experiment: taskText(experiment), gains, cost, arrived: parked === runs.length };
}

/** @param {Live} live */
const tallyIn = (live) => tallyOf(progressSlice.of(live.state).tallies, contestOf(live));

/** @param {Live} live */
const isPredicted = ({ state }) => progressSlice.of(state).answers[prediction] !== undefined;

/** What is locked in, or what the prediction locks in. @param {Live} live @returns {Duel} */
export const duelIn = (live) => progressSlice.of(live.state).duel ?? lockedIn(tallyIn(live), contestOf(live));

/** All 32 robots: with your gains, or with those of evolution until something else drives. @param {Tools} tools @param {any} _words @returns {Block} */
export function createDuelStage(tools, _words) {
  const changed = watch();
  return createSwarm(tools, shared.swarm, (live) => {
    const { engine, state, paper } = live;
    const drivesOn = changed(state.driver, state.handGains, state.experiment);
    const { duel, sees } = progressSlice.of(state);
    if (drivesOn && sees !== 'you') update(tools.store, { sees: 'you' });
    const champion = sees === 'evolution' && !drivesOn && duel ? duel.rounds.at(-1)?.champion : null;
    const gains = champion ?? gainsOf(state, state.driver, paper);
    // Evolution's drive where they were bred, whatever has been changed since.
    const yard = yardOf(engine).drive(champion && duel ? duel.experiment : state.experiment, gains);
    return yard && { name: champion ? shared.swarm.evolution(gains) : shared.swarm.own(gains), yard };
  });
}

/** Your trials so far, what you have beaten, and the button that locks them in. @param {Tools} tools @param {Words} words @returns {Block} */
export function createDuelDrives({ store }, { duel: words }) {
  const element = create('section', { class: 'duel', 'aria-label': words.drivesLabel });
  const startOver = (/** @type {Experiment} */ of) => {
    const { answers: before, tallies } = progressSlice.of(store.get());
    const { [prediction]: _, ...answers } = before;
    update(store, { answers, tallies: talliesBut(tallies, of), duel: null, sees: 'you' });
  };
  const changed = watch();
  return {
    element,
    draw(live) {
      const experiment = contestOf(live);
      const { duel } = progressSlice.of(live.state);
      const tally = tallyIn(live);
      const { population } = live.state.experiment.evolution;
      const predicted = isPredicted(live);
      if (!changed(duel, tally, population, experiment, predicted)) return;
      const { costs } = duel ?? tally;
      const best = lowestOf(costs);
      const isHere = !duel || isDuelOf(duel, experiment);
      // J of another task compares with none of this one.
      const beaten = isHere ? marksOf(live).filter(({ cost }) => best < cost) : [];
      const status = !isHere ? words.elsewhere : duel ? words.locked(predicted) : words.enough(costs.length);
      const lock = () => update(store, { duel: lockedIn(tally, experiment) });
      element.classList.toggle('locked', duel !== null);
      render(
        html`<div class="duel-numbers">
            <p class="duel-number">
              <span>${words.drivesName}</span><strong id="duel-drives">${costs.length}</strong>
            </p>
            <p class="duel-number">
              <span>${words.bestName}</span
              ><strong id="duel-best">${costs.length === 0 ? '…' : lab.costText(best)}</strong>
            </p>
          </div>
          <p id="duel-beaten" role="status">${shared.beaten(beaten)}</p>
          <p id="duel-status" class="muted">${status}</p>
          <div class="bar">
            <button id="duel-lock" type="button" class="primary" @click=${lock}
              ?hidden=${duel !== null} ?disabled=${costs.length === 0}>${words.lock}</button>
            <button id="duel-new" type="button" @click=${() => startOver(experiment)}
              ?hidden=${duel === null && costs.length === 0}>${words.startOver}</button>
          </div>`,
        element,
      );
    },
  };
}

/** How the three compare, once it is predicted. @param {Tools} tools @param {Words} words @returns {Block} */
export function createDuelResult({ store, engine, actions }, { duel: words, texts }) {
  const rounds = createRounds({ store, engine, actions });
  const goOn = (/** @type {Duel} */ duel) => update(store, { duel: { ...duel, goesOn: !duel.goesOn } });
  const picture = create('div', { id: 'duel-plot', class: 'duel-plot', role: 'img' });
  const plot = createDuelPlot(picture, words);
  // What follows from it would give the answer away.
  const [beyond, within, after] = [texts.beyond, texts.within, texts.after].map((text) =>
    create('div', 'prose', ...paragraphs(text, (link) => `#${link}`)),
  );
  const element = create('div', { class: 'duel-result', hidden: '' });
  const changed = watch();

  return {
    element,
    draw(live) {
      const { theme, evolving, preset } = live.state;
      const progress = progressSlice.of(live.state);
      const { sees } = progress;
      const predicted = isPredicted(live);
      if (!predicted) rounds.forgive();
      else if (!evolving) rounds.begin(duelIn(live));
      const { duel } = progress;
      const round = duel?.rounds.at(-1);
      if (!changed(duel, predicted, theme, sees, preset)) return;
      element.hidden = !predicted || !duel || !round;
      if (!predicted || !duel || !round) return;
      const verdict = judge(duel, round);
      const sentence = words.sentence(verdict);
      const later = duel.goesOn ? words.later(verdict) : '';
      const other = sees === 'you' ? 'evolution' : 'you';
      render(
        html`<section class="duel" aria-label=${words.resultLabel}>
            ${tableOf(duel, verdict, words, live)}
            <p id="duel-sentence" class="duel-sentence" role="status">${sentence}</p>
            <p id="duel-later" role="status">${later}</p>
            ${picture}
            <div class="bar">
              <button id="duel-watch" type="button" class="primary" @click=${() => update(store, { sees: other })}>${
                words.watch[other]
              }</button>
              <button id="duel-further" type="button" @click=${() => goOn(duel)}>${
                duel.goesOn ? words.backTo(verdict) : words.goOn(longestOf(duel))
              }</button>
              <button id="duel-again" type="button" @click=${() => rounds.run()}>${words.anotherSeed}</button>
            </div>
            <p id="duel-score" class="muted">${words.score(duel.rounds.length, scoreOf(duel))}</p>
          </section>
          ${isBeyond(duel, round, preset) ? beyond : within}${after}`,
        element,
      );
      picture.setAttribute('aria-label', words.plotLabel(`${sentence} ${later}`));
      plot.draw({ duel, theme });
    },
  };
}

/** The three, lowest J first. @param {Duel} duel @param {Verdict} verdict @param {Words['duel']} words @param {Live} live */
function tableOf(duel, verdict, words, { engine }) {
  const { costs, drives, given, winner } = verdict;
  const parkedWith = (/** @type {Duel['gains']} */ gains) => {
    const yard = gains && yardOf(engine).drive(duel.experiment, gains);
    return yard ? String(yard.parked) : '';
  };
  const round = duel.rounds.at(-1);
  const parked = {
    you: parkedWith(duel.gains),
    evolution: parkedWith(round?.champion ?? null),
    random: parkedWith(round?.drawn ?? null),
  };
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
          <td class="parked">${parked[name] || '–'}</td>
          <td class="cost">${lab.costText(cost)}</td>
        </tr>`,
      )}
    </tbody>
  </table>`;
}

/** Asks the workers for evolution and random search. @param {Pick<Tools, 'store' | 'engine' | 'actions'>} tools */
function createRounds({ store, engine, actions }) {
  /** @type {Duel | null} */
  let asked = null;
  let hasFailed = false;
  /** @param {Duel} duel */
  const ask = async (duel) => {
    if (asked === duel) return;
    asked = duel;
    const { handGains } = store.get();
    try {
      const round = await roundOf(engine, duel, nextSeed(duel));
      // Whatever is shown of it meanwhile, it is the same as long as nobody has driven on.
      const now = progressSlice.of(store.get()).duel;
      if (now && now.rounds === duel.rounds && now.costs === duel.costs)
        update(store, {
          duel: { ...now, rounds: [...now.rounds, round] },
          // Whoever has predicted wants to see it, but for who drives on.
          ...(store.get().dragging || store.get().handGains !== handGains ? {} : { sees: 'evolution' }),
        });
    } catch (error) {
      hasFailed = true;
      actions.say(messageOf(error));
    }
  };
  /** What has failed is tried again only when somebody asks for it. */
  const forgive = () => {
    if (hasFailed) asked = null;
    hasFailed = false;
  };
  return {
    forgive,
    /** Locks in, and runs the first seed. @param {Duel} duel */
    begin(duel) {
      if (duel.rounds.length > 0) return;
      if (progressSlice.of(store.get()).duel !== duel) update(store, { duel });
      ask(duel);
    },
    run() {
      forgive();
      const { duel } = progressSlice.of(store.get());
      if (duel) ask(duel);
    },
  };
}
