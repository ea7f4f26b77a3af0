// Where there is no room for all of the figure beside the words, it shows one sight: the robot, what the step is about, or the gains. It stays over the words; in a frame it stands beside them sooner.
import { byId, isSeen } from '../kit/elements.js';
import { createSegmented } from '../kit/segmented.js';
import { hearOfPaper } from '../kit/size.js';
import { named, parts } from '../parts/parts.js';
import { lab } from '../words/index.js';
import words from './words/index.js';

/** @import { Choice } from '../kit/segmented.js' */
/** @import { State } from '../run/state.js' */
/** @import { Step } from './steps.js' */
/** @typedef {'robot' | 'stage' | 'part' | 'gains'} Sight */
/** What stands under the plane. @typedef {'' | 'drive' | 'evolve' | 'plane' | 'part'} Figure */

/** On a lower plane a drive cannot be followed. */
const leastHeight = 200;

/** @param {Step | undefined} step @param {Pick<State, 'page' | 'driver'>} state @returns {Figure} */
export function figureOf(step, { page, driver }) {
  if (!step) return '';
  if (page !== 'lab') return 'part';
  if (step.figure === 'driver') return driver === 'hand' ? 'drive' : 'evolve';
  return step.figure;
}

/** @param {HTMLFieldSetElement} fieldset */
export function createSights(fieldset) {
  const narrow = matchMedia('(max-width: 1023px)');
  /** @type {Sight | null} */
  let chosen = null;
  /** What a question is about, when what it opens is there. @type {Sight | null} */
  let wanted = null;
  /** @type {Step | undefined} */
  let opened;
  /** @type {readonly Sight[]} */
  let offered = [];
  let draw = () => {};
  let isOnSheet = false;
  const show = () => {
    if (chosen && narrow.matches && !isOnSheet) document.body.dataset.sight = chosen;
    else delete document.body.dataset.sight;
  };
  narrow.addEventListener('change', show);
  // A sheet has room for all of it.
  hearOfPaper((prints) => {
    isOnSheet = prints;
    show();
  });
  return {
    /** Offers what there is, and begins with what the words speak of. @param {Step | undefined} step @param {string} page @param {Figure} figure @param {'instead' | 'beside' | 'under' | undefined} stage */
    open(step, page, figure, stage) {
      if (step !== opened) wanted = null;
      opened = step;
      chosen = null;
      if (step) {
        const isPart = figure === 'part' || figure === 'evolve';
        const hasGains = !isPart || parts.find(({ name }) => name === page)?.gains !== undefined;
        chosen = stage ? 'stage' : isPart ? 'part' : figure === 'drive' ? 'gains' : 'robot';
        /** @type {Choice<Sight>[]} */
        const choices = [];
        if (stage) choices.push({ value: 'stage', text: words.sightOfStage });
        if (stage !== 'instead') choices.push({ value: 'robot', text: words.sightOfRobot });
        if (isPart)
          choices.push({
            value: 'part',
            text: page === 'lab' ? lab.texts.evolutionSection : named[page].name,
          });
        if (hasGains) choices.push({ value: 'gains', text: lab.texts.gainsTitle });
        offered = choices.map(({ value }) => value);
        for (const first of [step.sight, wanted]) if (first && offered.includes(first)) chosen = first;
        wanted = null;
        const picker = createSegmented(fieldset.id, words.sights, choices, (sight) => {
          chosen = sight;
          show();
        });
        draw = () => picker.draw(chosen);
        draw();
      }
      show();
    },

    /** Shows what a question is about, now and in what it opens; without it, what that opens with. @param {Sight} [sight] */
    look(sight) {
      wanted = sight ?? null;
      if (!sight) return;
      const plane = byId('plane');
      // Who sees it already, under what the step is about or as more than a strip, keeps what stands beside it.
      const isThere =
        sight === 'robot' && isSeen(plane) && (chosen === 'stage' || plane.clientHeight >= leastHeight);
      if (isThere || !offered.includes(sight)) return;
      chosen = sight;
      draw();
      show();
    },
  };
}
