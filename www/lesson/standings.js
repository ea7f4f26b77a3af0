// Some drives by what they cost under the present weights; the cheapest is marked.
import { create } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { gainsOf } from '../run/drivers.js';
import { lab } from '../words/index.js';
import { costText, threeDigits } from '../words/numbers.js';

/** @typedef {import('../core/engine.js').Run} Run */
/** @typedef {import('../core/engine.js').Triple} Triple */
/** @typedef {'ep' | 'arbitrary' | 'gentle' | 'hand'} Entrant */
/** @typedef {{ standings: { caption: string, gentle: string, lowest: string, nobody: string } }} Words */

/** Turns and drives with patience. @type {Triple} */
export const gentle = [2, 0, 3];
const isGentle = (/** @type {Triple | null} */ gains) => String(gains) === String(gentle);
const entrants = /** @type {const} */ (['ep', 'arbitrary', 'gentle', 'hand']);

const drivers = /** @type {const} */ ({ ep: 'paper-ep', arbitrary: 'paper-arbitrary', hand: 'hand' });
/** As the lab names them. @param {Entrant} name @param {string} ofGentle */
const nameOf = (name, ofGentle) =>
  name === 'gentle' ? ofGentle : (lab.drivers.find(({ value }) => value === drivers[name])?.text ?? '');

/** Whose gains stand in the table; null: nobody's yet. @param {import('./page.js').Live} live @param {Triple | null} byHand @returns {Record<Entrant, Triple | null>} */
export const entrantsOf = ({ state, paper }, byHand) => ({
  ep: gainsOf(state, 'paper-ep', paper),
  arbitrary: gainsOf(state, 'paper-arbitrary', paper),
  gentle,
  hand: byHand,
});

/** The cheapest. @param {readonly (Run | null)[]} runs */
export const winnerOf = (runs) =>
  runs.reduce(
    (best, run, i) =>
      run && run.cost.total < (runs[best]?.cost.total ?? Number.POSITIVE_INFINITY) ? i : best,
    0,
  );

/** @param {import('./page.js').Tools} tools @param {Words} words @returns {import('./page.js').Block} */
export function createStandings({ engine, actions }, { standings: words }) {
  /** The last gains by hand that are not the gentle ones of the table. @type {Triple | null} */
  let byHand = null;
  const rows = entrants.map((name) => createRow(nameOf(name, words.gentle), words.lowest, () => drive(name)));
  const element = create('table', 'standings', create('tbody', '', ...rows.map(({ element: row }) => row)));
  element.id = 'standings';
  element.setAttribute('aria-label', words.caption);
  const changed = watch();

  /** @param {Entrant} name */
  function drive(name) {
    if (name === 'ep') return actions.chooseDriver('paper-ep');
    if (name === 'arbitrary') return actions.chooseDriver('paper-arbitrary');
    const gains = name === 'gentle' ? gentle : byHand;
    if (!gains) return;
    actions.driveGains(gains);
    actions.driveAgain();
  }

  return {
    element,
    draw(live) {
      const { experiment, handGains, driver, preset } = live.state;
      if (!changed(experiment, handGains, driver, preset)) return;
      if (handGains && !isGentle(handGains)) byHand = handGains;
      const gains = Object.values(entrantsOf(live, byHand));
      const runs = gains.map((triple) => triple && engine.drive(experiment, [triple])[0]);
      const winner = winnerOf(runs);
      const dearest = Math.max(...runs.map((run) => run?.cost.total ?? 0).filter(Number.isFinite));
      const drives = {
        ep: driver === 'paper-ep',
        arbitrary: driver === 'paper-arbitrary',
        gentle: driver === 'hand' && isGentle(handGains),
        hand: driver === 'hand' && !isGentle(handGains),
      };
      for (const [i, row] of rows.entries())
        row.draw({
          text: textOf(gains[i], runs[i]),
          run: runs[i],
          dearest,
          wins: i === winner,
          drives: drives[entrants[i]],
        });
    },
  };

  /** @param {Triple | null} gains @param {Run | null} run */
  function textOf(gains, run) {
    if (!gains || !run) return words.nobody;
    return `${gains.map(threeDigits).join(', ')} · ${lab.outcomeText(run)}`;
  }
}

/** @param {string} name @param {string} lowest @param {() => void} onPress */
function createRow(name, lowest, onPress) {
  const button = create('button', 'standing-name', name);
  button.setAttribute('type', 'button');
  button.addEventListener('click', onPress);
  const gains = create('span', 'muted');
  const segments = lab.costParts.map(([part]) => {
    const segment = create('span', `standing-segment part-${part}`);
    segment.dataset.term = part;
    return { part, segment };
  });
  const bar = create('div', 'standing-bar', ...segments.map(({ segment }) => segment));
  bar.setAttribute('aria-hidden', 'true');
  const total = create('span', 'standing-total');
  const mark = create('span', 'standing-mark', lowest);
  const head = create('th', 'standing-head', button, gains, bar);
  head.setAttribute('scope', 'row');
  const element = create('tr', 'standing', head, create('td', 'standing-cost', total, mark));
  return {
    element,
    /** @param {{ text: string, run: Run | null, dearest: number, wins: boolean, drives: boolean }} model */
    draw({ text, run, dearest, wins, drives }) {
      element.classList.toggle('wins', wins);
      mark.hidden = !wins;
      button.setAttribute('aria-pressed', String(drives));
      button.toggleAttribute('disabled', !run);
      gains.textContent = text;
      total.textContent = run ? costText(run.cost.total) : '–';
      const isPaid = run !== null && Number.isFinite(run.cost.total);
      for (const { part, segment } of segments)
        segment.style.width = isPaid ? `${(100 * run.cost[part]) / dearest}%` : '0';
    },
  };
}
