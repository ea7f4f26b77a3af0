// The offspring of a generation, each with its drive beside its parent's: what the phase Drive does, seen at once.
import { html, render } from 'lit-html';
import { forgets } from '../../core/methods.js';
import { create } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { generationSlice } from '../../parts/generation/state.js';
import { isInitial, partnerOf } from '../../parts/generation/record.js';
import { fixed, powerText } from '../../words/numbers.js';
import { anatomyOf, chosenIn } from '../anatomy.js';
import { createSmallDrive } from './small-drives.js';

/** @import { Experiment, Triple } from '../../core/engine.js' */
/** @import { Anatomy } from '../../parts/generation/record.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** @typedef {{ newborn: { title: (better: number, count: number) => string, parents: (count: number) => string, alone: (count: number) => string, name: (number: number, isParent: boolean) => string } }} NewbornWords */

const most = 20;
/** There is room for four digits. @param {number} cost */
const inFour = (cost) =>
  cost < 1e4 ? fixed(cost, cost < 100 ? 2 : cost < 1000 ? 1 : 0) : powerText(cost, 2);

/** Whether each of the offspring is that of one parent. @param {Anatomy} anatomy */
const isPaired = ({ method, record }) => !forgets(method) && record.offspring.length <= record.parents.length;

/** @param {Tools} tools @param {NewbornWords} words @returns {Block} */
export function createNewborn({ engine, store }, { newborn: words }) {
  const element = create('div', { id: 'newborn', class: 'newborn' });
  const pictures = Array.from({ length: most }, () => createSmallDrive(store));
  const drivesOf = remember(
    (/** @type {Experiment} */ experiment, /** @type {Anatomy} */ anatomy, /** @type {boolean} */ isBorn) => {
      const { parents, offspring } = anatomy.record;
      const shown = (isBorn ? offspring : parents).slice(0, most);
      const beside = isBorn && isPaired(anatomy) ? parents.slice(0, shown.length) : [];
      const runs = engine.drive(
        { ...experiment, starts: [experiment.starts[0]] },
        [...shown, ...beside].map((one) => /** @type {Triple} */ ([...one.gains])),
      );
      return shown.map((_, i) => ({
        run: runs[i],
        others: runs.slice(shown.length + i, shown.length + i + 1),
      }));
    },
  );
  const changed = watch();
  const titleOf = (
    /** @type {Anatomy} */ anatomy,
    /** @type {boolean} */ isBorn,
    /** @type {number} */ better,
  ) => {
    const { parents, offspring } = anatomy.record;
    if (!isBorn) return words.parents(parents.length);
    return isPaired(anatomy) ? words.title(better, offspring.length) : words.alone(offspring.length);
  };

  return {
    element,
    draw(/** @type {Live} */ live) {
      const { state } = live;
      const anatomy = anatomyOf(live);
      const { record } = anatomy;
      const { phase } = generationSlice.of(state);
      const isBorn = !isInitial(record) && phase !== 'parents' && phase !== 'mutation';
      const drives = drivesOf(state.experiment, anatomy, isBorn);
      const chosen = chosenIn(live) % anatomy.count;
      const all = isBorn ? record.offspring : record.parents;
      const isBetter = (/** @type {number} */ i) =>
        isBorn && isPaired(anatomy) && all[i].cost < anatomy.all[partnerOf(anatomy, anatomy.count + i)].cost;
      if (changed(drives, chosen))
        render(
          html`<p class="newborn-title">${titleOf(anatomy, isBorn, all.filter((_, i) => isBetter(i)).length)}</p>
            <div class="newborn-pictures"><ul>${drives.map(
              (_, i) => html`<li class=${`${i === chosen ? 'chosen' : ''}${isBetter(i) ? ' better' : ''}`}>
                ${pictures[i].element}<span>${words.name(i + 1, !isBorn)}</span> <strong>${inFour(all[i].cost)}</strong></li>`,
            )}</ul></div>`,
          element,
        );
      for (const [i, { run, others }] of drives.entries())
        pictures[i].draw(state.experiment, run, state.robot.time, state.theme, {
          others,
          car: 3.5,
          token: isBetter(i) ? '--theta' : '--ink',
        });
    },
  };
}
