// Some drives by what they cost under the present weights; the cheapest is marked.
import { html, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { listed } from '../../kit/segmented.js';
import { roundStep } from '../../kit/steps.js';
import { gainsOf } from '../../run/drivers.js';
import { lab } from '../../words/index.js';
import { threeDigits } from '../../words/numbers.js';
import { createSmallDrive } from './small-drives.js';

/** @import { Experiment, Run, Triple } from '../../core/engine.js' */
/** @import { Driver } from '../../words/common/kinds.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** @typedef {'ep' | 'arbitrary' | 'gentle' | 'hand'} Entrant */
/** @typedef {{ standings: { caption: string, dots: (seconds: string) => string, gentle: string, lowest: string, nobody: string } }} Words */

/** Turns and drives with patience. @type {Triple} */
export const gentle = [2, 0, 3];
const isGentle = (/** @type {Triple | null} */ gains) => String(gains) === String(gentle);
const entrants = /** @type {const} */ (['ep', 'arbitrary', 'gentle', 'hand']);

const drivers = /** @type {const} */ ({ ep: 'paper-ep', arbitrary: 'paper-arbitrary', hand: 'hand' });
/** As the lab names them. @param {Driver} driver */
const driverText = (driver) => listed(lab.drivers).find(({ value }) => value === driver)?.text ?? '';

/** Whose gains stand in the table; null: nobody's yet. @param {Live} live @param {Triple | null} byHand @returns {Record<Entrant, Triple | null>} */
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

/** @param {Tools} tools @param {Words} words @returns {Block} */
export function createStandings({ engine, actions, store }, { standings: words }) {
  const pictures = entrants.map(() => createSmallDrive(store));
  /** The last gains by hand that are not the gentle ones of the table. @type {Triple | null} */
  let byHand = null;
  /** @type {readonly (Run | null)[]} */
  let driven = [];
  /** Seconds from dot to dot. */
  let beat = 0;
  /** The place of who drives by hand is that of the evolved robot while that one drives. */
  let isEvolved = false;
  const element = create('table', { id: 'standings', class: 'standings', 'aria-label': words.caption });
  const changed = watch();

  /** @param {Entrant} name */
  function drive(name) {
    if (name === 'ep') return actions.chooseDriver('paper-ep');
    if (name === 'arbitrary') return actions.chooseDriver('paper-arbitrary');
    const gains = name === 'gentle' ? gentle : byHand;
    if (!gains || (name === 'hand' && isEvolved)) return;
    actions.driveGains(gains);
    actions.driveAgain();
  }

  /** @param {Experiment} experiment @param {ReturnType<typeof entrantsOf>} gains */
  function drivesOf(experiment, gains) {
    try {
      return entrants.map((name) => gains[name] && engine.drive(experiment, [gains[name]])[0]);
    } catch (error) {
      // What is not there yet is asked for again.
      changed();
      throw error;
    }
  }

  return {
    element,
    draw(live) {
      const { experiment, handGains, driver, preset, robot, theme } = live.state;
      const drawPictures = () => {
        for (const [i, run] of driven.entries())
          if (run) pictures[i].draw(experiment, run, robot.time, theme, { car: 8, others: driven, beat });
      };
      isEvolved = driver === 'evolved';
      const last = isEvolved ? live.gains : null;
      if (!changed(experiment, handGains, driver, preset, String(last))) return drawPictures();
      if (handGains && !isGentle(handGains)) byHand = handGains;
      const gains = entrantsOf(live, last ?? byHand);
      /** @param {Entrant} name */
      const driverOf = (name) =>
        name === 'hand' && isEvolved ? 'evolved' : name === 'gentle' ? 'hand' : drivers[name];
      const runs = drivesOf(experiment, gains);
      driven = runs;
      beat = beatOf(runs);
      const winner = winnerOf(runs);
      const dearest = Math.max(...runs.map((run) => run?.cost.total ?? 0).filter(Number.isFinite));
      const driving =
        driver === 'hand' && isGentle(handGains)
          ? 'gentle'
          : entrants.find((name) => name !== 'gentle' && driverOf(name) === driver);
      const rows = entrants.map((name, i) => {
        const [triple, run] = [gains[name], runs[i]];
        const text =
          triple && run ? `${triple.map(threeDigits).join(', ')} · ${lab.outcomeText(run)}` : words.nobody;
        return html`<tr class=${i === winner ? 'standing wins' : 'standing'}>
          <td class="standing-picture">${pictures[i].element}</td>
          <th class="standing-head" scope="row">
            <button class="standing-name on-paper" type="button" data-entrant=${name} aria-pressed=${name === driving} .disabled=${!run}
              @click=${() => drive(name)}>${name === 'gentle' ? words.gentle : driverText(driverOf(name))}</button
            ><span class="muted">${text}</span>
            <div class="standing-bar" aria-hidden="true" .style=${`width: ${isPaid(run) ? (100 * run.cost.total) / dearest : 0}%`}>${segmentsOf(run)}</div>
          </th>
          <td class="standing-cost">
            <span class="standing-total">${run ? lab.costText(run.cost.total) : '–'}</span>
            <span class="standing-mark" ?hidden=${i !== winner}>${words.lowest}</span>
          </td>
        </tr>`;
      });
      render(
        html`<caption>${beat > 0 ? words.dots(String(beat)) : ''}</caption><tbody>${rows}</tbody>`,
        element,
      );
      drawPictures();
    },
  };
}

/** So many dots has the longest drive at most. */
const mostDots = 12;

/** A round number of seconds, the same for all, so that dots far apart mean fast. @param {readonly (Run | null)[]} runs */
export function beatOf(runs) {
  const longest = Math.max(...runs.map((run) => run?.finalTime ?? 0));
  return roundStep(longest / mostDots);
}

/** @param {Run | null} run @returns {run is Run} */
const isPaid = (run) => run !== null && Number.isFinite(run.cost.total);

/** J in its parts. @param {Run | null} run */
const segmentsOf = (run) =>
  lab.costParts.map(
    ([part]) => html`<span class=${`standing-segment part-${part}`} data-term=${part}
      .style=${`width: ${isPaid(run) ? (100 * run.cost[part]) / run.cost.total : 0}%`}></span>`,
  );
