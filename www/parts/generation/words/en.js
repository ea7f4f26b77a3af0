// Every word of the generation part.
/** @import { Anatomy, Phase } from '../record.js' */
import { isOtherSearch } from '../state.js';
import { costWriter, digitsFor } from './common.js';
import { costText, fixed, powerText } from '../../../words/en/numbers.js';

export * from './common.js';

export const texts = {
  generationPicture: 'The generation',
  generationTable: 'Table',
  generationStep: 'Steps of the generation',
  generationBack: 'Phase before',
  generationDetails: 'The chosen individual',
};

export const phaseLegend = 'Phase of the generation';
/** @type {readonly import('../../../kit/segmented.js').Choice<Phase>[]} */
export const phases = [
  { value: 'parents', text: 'Parents' },
  { value: 'mutation', text: 'Mutation' },
  { value: 'drive', text: 'Drive' },
  { value: 'tournament', text: 'Tournament' },
  { value: 'ranking', text: 'Ranking' },
  { value: 'survivors', text: 'Survivors' },
];

/** @param {Phase} phase */
const phaseName = (phase) => phases.find(({ value }) => value === phase)?.text ?? phase;

/** @param {number} generation */
export const title = (generation) => `Generation ${generation}`;

export const next = 'Next';
/** @param {Phase} phase */
export const nextPhase = (phase) => `: ${phaseName(phase).toLowerCase()}`;
/** @param {number} generation */
export const nextGeneration = (generation) => `: generation ${generation}`;

export const parentKey = 'parent';
export const offspringKey = 'offspring';

/** An individual's name: those of generation 0 have no parents and no offspring. @param {Anatomy} anatomy @param {number} number */
export const nameOf = ({ count, record }, number) =>
  record.offspring.length === 0
    ? `robot ${number + 1}`
    : number < count
      ? `parent ${number + 1}`
      : `offspring ${number - count + 1}`;

/** @param {string} text */
export const capital = (text) => text[0].toUpperCase() + text.slice(1);

/** What happens in a phase. @param {Anatomy} anatomy @param {Phase} phase */
export function sentence({ count, staying, all, record }, phase) {
  const { generation, offspring, parents, survivors } = record;
  if (generation === 0)
    return phase === 'survivors'
      ? `All ${count} stay, now in the order of their J: the parents of generation 1.`
      : `${count} robots with random gains, in the order of their draws. No one has competed yet.`;
  if (isOtherSearch(record))
    return {
      parents: `What the search keeps after generation ${generation - 1}: ${count}, best ranked first. Lower J is better.`,
      drive: `The search asks for ${parts(offspring.length, 'drive', 'drives')}, and is told each J.`,
      survivors: `${parts(staying, 'stays', 'stay')}: ${staying - parentsIn(record)} of those that drove, and ${parentsIn(record)} from before.`,
    }[/** @type {'parents' | 'drive' | 'survivors'} */ (phase)];
  const better = offspring.filter(({ cost }, i) => cost < parents[i].cost).length;
  const stayed = survivors.filter((number) => number < count).length;
  return {
    parents: `The ${count} survivors of generation ${generation - 1}, best ranked first. Lower J is better.`,
    mutation: 'Each parent has one offspring: its gains move by the old σ times a random draw.',
    drive: `The offspring drive and get their J: ${better} of ${count} drive better than their parent.`,
    tournament: `Each of the ${all.length} meets ${record.opponents[0]?.length} others drawn at random, and wins if its J is not higher.`,
    ranking:
      record.wins.length > 0
        ? `Most wins first; with equal wins, lower J first. The line is drawn after ${count}.`
        : `Those that survive first, each part by J. The line is drawn after ${count}.`,
    survivors: `${parts(stayed, 'parent', 'parents')} and ${count - stayed} offspring stay, with their σ: the parents of generation ${generation + 1}.`,
  }[phase];
}

/** @param {Anatomy['record']} record */
const parentsIn = ({ parents, survivors }) => survivors.filter((number) => number < parents.length).length;

/** @param {number} count @param {string} one @param {string} many */
const parts = (count, one, many) => `${count} ${count === 1 ? one : many}`;

/** @param {number} count */
export const winsText = (count) => parts(count, 'win', 'wins');

/** One that survives though a better one fell. @param {Anatomy} anatomy */
export function upsetText(anatomy) {
  const { upset, all, record } = anatomy;
  if (!upset) return `This time those that stay are exactly the ${anatomy.staying} with the lowest J.`;
  const { survivor, fallen } = upset;
  const [a, b] = [all[survivor].cost, all[fallen].cost];
  const write = (/** @type {number} */ cost) => (cost < 100 ? fixed(cost, digitsFor(a - b)) : costText(cost));
  const who = capital(nameOf(anatomy, survivor));
  if (record.wins.length === 0)
    return `${who} (J ${write(a)}) stays, though ${nameOf(anatomy, fallen)} (J ${write(b)}) is better: this search does not keep the best of all.`;
  return `${who} (J ${write(a)}) survives with ${winsText(record.wins[survivor])}; ${nameOf(anatomy, fallen)} (J ${write(b)}) fell with ${record.wins[fallen]}: luck in the opponents.`;
}

/** @param {string} name @param {number} generation */
export const drivingText = (name, generation) => `${name} of generation ${generation}`;

/** @param {Phase} phase @param {number} shown @param {number} all @param {number | null} arrived Null where nobody can arrive. */
export function othersText(phase, shown, all, arrived) {
  const kind = { parents: 'parents', mutation: 'parents', drive: 'offspring', survivors: 'survivors' };
  const who =
    phase === 'tournament'
      ? `its ${parts(all, 'opponent', 'opponents')}`
      : phase === 'ranking'
        ? `the other ${all}`
        : `the other ${all} ${kind[phase]}`;
  const drawn = shown < all ? `${shown} of ${who}` : who;
  return arrived === null ? drawn : `${drawn}, ${arrived} of them arrive`;
}

export const pictureLabel = 'The individuals of this generation; arrow keys choose one';

/** What is said of the one that is chosen. @param {Anatomy} anatomy @param {Phase} phase @param {number} number */
export function chosenText(anatomy, phase, number) {
  const { count, staying, all, record, ranks } = anatomy;
  const undriven = phase === 'mutation' && number >= count;
  const stays = ranks[number] < staying ? 'survives' : 'falls';
  return [
    nameOf(anatomy, number),
    undriven ? 'not driven yet' : `J ${costWriter(anatomy)(all[number].cost)}`,
    ...(phase === 'ranking' || phase === 'survivors' ? standing() : []),
  ].join(', ');

  function standing() {
    if (record.generation === 0) return [`rank ${ranks[number] + 1}`];
    const wins = record.wins.length > 0 ? [winsText(record.wins[number])] : [];
    return [...wins, `rank ${ranks[number] + 1} of ${all.length}`, stays];
  }
}

/** The axis of J where it is too narrow for J itself. @param {number} value */
export const beyondBest = (value) => (value === 0 ? 'best' : `+${powerText(value, 2)}`);
export const winsAxis = 'wins';
export const pairAxis = 'pair';
export const robotAxis = 'robot';
export const parentAxis = 'parent';
/** @param {number} count */
export const stay = (count) => `${count} stay`;
/** @param {number} count */
export const fall = (count) => `${count} fall`;
export const wonText = 'won against';
export const lostText = 'lost to';

export const initialText = 'drawn evenly from the initial range, σ as set';

/** @param {number} rank @param {number} generation */
export const ranked = (rank, generation) => `ranked ${rank} in generation ${generation}`;

export const commonText = ': one draw for all three σ';

/** What stands before the name of the other. @param {number} own @param {number} other */
export const comparedText = (own, other) =>
  own === other ? 'As good as ' : own < other ? 'Better than ' : 'Worse than ';

/** @param {number} starts */
export const meanText = (starts) => `J is the mean over ${starts} starts; the plane shows the first.`;

/** @param {number} wins @param {number} bouts */
export const sumText = (wins, bouts) => `${winsText(wins)} of ${bouts}`;

/** @param {number} rest */
export const moreBouts = (rest) => `and ${rest} more bouts`;

/** @param {Anatomy} anatomy @param {number} number */
export function fateText({ ranks, staying, record, all }, number) {
  const rank = ranks[number] + 1;
  if (rank > staying) return `fell: rank ${rank} of ${all.length}`;
  return `survives as parent ${rank} of generation ${record.generation + 1}`;
}

/** @param {number} before @param {number} after @param {(cost: number) => string} write */
export const bestText = (before, after, write) =>
  after < before
    ? `The best J falls from ${write(before)} to ${write(after)}.`
    : after === before
      ? `The best J stays ${write(after)}: the best always survives.`
      : `The best J rises from ${write(before)} to ${write(after)}: this search forgets what it had.`;

/** @param {Anatomy} anatomy */
export const tableCaption = ({ record, count, all }) =>
  record.generation === 0
    ? `Generation 0: ${count} robots with random gains. The core’s record counts from 0: robot 1 is its number 0.`
    : `Generation ${record.generation}, all ${all.length}. The core’s record counts from 0: parent 1 is its number 0, offspring 1 its number ${count}. ${record.wins.length > 0 ? 'Most wins first.' : 'Those that stay first.'}`;
export const columns = [
  'rank',
  'who',
  'number',
  'parent',
  'kx',
  'ky',
  'kθ',
  'σx',
  'σy',
  'σθ',
  'J',
  'wins',
  'survives',
];
export const yes = 'yes';
export const no = 'no';
