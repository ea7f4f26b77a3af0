// Every word of the generation part.
/** @import { Anatomy, Phase } from '../record.js' */
/** @import { Others } from './common.js' */
import { costsApart, costWriter, luckSign, tellingApart } from './common.js';
import { nameOf, sentenceOfMethod } from './methods-en.js';
import { counted } from '../../../words/en/counted.js';
import { fixed } from '../../../words/en/numbers.js';

export * from './common.js';
export * from './methods-en.js';

export const texts = {
  generationPicture: 'The generation',
  generationTable: 'Table',
  generationStep: 'Steps of the generation',
  generationBack: 'Phase before',
  generationDetails: 'The chosen individual',
};

export const phaseLegend = 'Phase of the generation';

/** @param {number} generation */
export const title = (generation) => `Generation ${generation}`;

/** @param {Anatomy} anatomy */
export const beginText = ({ method, record }) =>
  `${method === 'ep' ? 'Breed' : 'Make'} generation ${record.generation + 1}`;
export const next = 'Next';
/** @param {string} name */
export const nextPhase = (name) => `: ${name.toLowerCase()}`;
/** @param {number} generation */
export const nextGeneration = (generation) => `: generation ${generation}`;

/** @param {string} text */
export const capital = (text) => text[0].toUpperCase() + text.slice(1);

/** What happens in a phase. @param {Anatomy} anatomy @param {Phase} phase */
export function sentence(anatomy, phase) {
  const { count, all, record, method } = anatomy;
  const { generation, offspring, parents, survivors } = record;
  if (method !== 'ep') return sentenceOfMethod(anatomy, phase, costWriter(anatomy));
  if (generation === 0)
    return phase === 'survivors'
      ? count === 1
        ? 'It stays: the parent of generation 1.'
        : `All ${count} stay, now in the order of their J: the parents of generation 1.`
      : `${counted(count, 'robot', 'robots')} with random gains, in the order of their draws. No one has competed yet.`;
  const better = offspring.filter(({ cost }, i) => cost < parents[i].cost).length;
  const stayed = survivors.filter((number) => number < count).length;
  const crossed = record.donors.filter(({ length }) => length > 0).length;
  return {
    parents: `The ${generation > 1 ? counted(count, 'survivor', 'survivors') : counted(count, 'robot', 'robots')} of generation ${generation - 1}, ${generation > 1 ? 'best ranked' : 'lowest J'} first. Lower J is better.`,
    mutation: `Each parent has one offspring: its gains move by the old σ times a random draw.${crossed > 0 ? ` ${crossed} of ${count} parents are crossed with another first.` : ''}`,
    drive: `The offspring drive and get their J. Better than their parent: ${better} of ${count}.`,
    tournament: `Each of the ${all.length} meets ${counted(record.opponents[0]?.length ?? 0, 'other', 'others')} drawn at random, and wins if its J is not higher.`,
    ranking:
      record.wins.length > 0
        ? `Most wins first; with equal wins, lower J first. The line is drawn after ${count}.`
        : `Survivors first, then the others, each group by J. The line is drawn after ${count}.`,
    survivors: `${counted(stayed, 'parent', 'parents')} and ${count - stayed} offspring stay, with their σ: the parents of generation ${generation + 1}.`,
  }[phase];
}

/** @param {number} count */
export const winsText = (count) => counted(count, 'win', 'wins');

/** One that survives though a better one fell. @param {Anatomy} anatomy */
export function upsetText(anatomy) {
  const { upset, all, record } = anatomy;
  if (!upset)
    return `${record.wins.length > 0 ? 'This time those' : 'Those'} that stay are exactly the ${anatomy.staying} with the lowest J.`;
  const { survivor, fallen } = upset;
  const [a, b] = [all[survivor].cost, all[fallen].cost];
  const write = costsApart(a - b);
  const who = capital(nameOf(anatomy, survivor));
  if (record.wins.length === 0)
    return `${who} (J ${write(a)}) stays, though ${nameOf(anatomy, fallen)} (J ${write(b)}) is better: each of them meets only its own ${record.mutations.length > 0 ? 'parent' : 'member'}.`;
  return `${who} (J ${write(a)}) survives with ${winsText(record.wins[survivor])}; ${nameOf(anatomy, fallen)} (J ${write(b)}) fell with ${record.wins[fallen]}: luck in the opponents.`;
}

/** @param {number} expected @param {number} wins */
export const luckText = (expected, wins) =>
  `expected ${fixed(expected, 1)}: luck ${luckSign(expected, wins)}`;

/** @param {string} name @param {number} generation */
export const drivingText = (name, generation) => `${name} of generation ${generation}`;

/** @param {Anatomy} anatomy @param {Phase} phase @param {Others} others */
export function othersText({ method, record }, phase, { drawn, all, isAmong, arrived }) {
  const bouts = record.opponents[0]?.length ?? 0;
  const isOwn = method === 'ep';
  const before = isOwn ? ['parent', 'parents'] : ['robot', 'robots'];
  const staying = method === 'random' ? ['draw', 'draws'] : ['one that stays', 'that stay'];
  const [one, many] = {
    parents: before,
    mutation: before,
    drive: isOwn ? ['offspring', 'offspring'] : ['trial', 'trials'],
    tournament: ['opponent', `opponents in ${bouts} bouts`],
    ranking: ['one', ''],
    survivors: isOwn ? ['survivor', 'survivors'] : staying,
  }[phase];
  const these = phase === 'tournament' ? 'its' : isAmong ? 'the other' : 'the';
  if (all === 1) {
    const ending = arrived === 1 ? ', which arrives' : ', which does not arrive';
    return `${these} ${one}${arrived === null ? '' : ending}`;
  }
  const who = `${these} ${all} ${many}`.trimEnd();
  const told = drawn < all ? `${drawn} of ${who}` : who;
  return arrived === null ? told : `${told}, ${arrived} of them ${arrived === 1 ? 'arrives' : 'arrive'}`;
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

/** The axis of J where it is too narrow for J itself. @param {string} text how far, from the best on @param {number} i */
export const beyondBest = (text, i) => (i === 0 ? 'best' : `+${text}`);
/** Of the thin lines that lead to the marks. */
export const byCostText = '— from the rank by J alone';
export const winsAxis = 'wins';
export const pairAxis = 'pair';
export const robotAxis = 'robot';
/** Of those that stay, best ranked first. @param {Anatomy['method']} method */
export const survivorAxis = (method) => (method === 'ep' ? 'parent' : 'rank');
export const wonText = 'won against';
export const lostText = 'lost to';

/** @param {number} rank @param {number} generation */
export const ranked = (rank, generation) => `ranked ${rank} in generation ${generation}`;

/** Whom one followed until then. @param {Anatomy} anatomy @param {string} name */
export const fallenText = ({ record, method }, name) =>
  `${capital(name)}, shown until here, ${method === 'ep' ? 'fell' : 'was dropped'} in generation ${record.generation - 1}.`;

/** Of the pictures beside k and σ. */
export const bellsText = 'The bells: where an offspring’s gains are likely to land, on one scale.';

export const commonText = ': one N for all three σ';
export const crossedWith = 'crossed with ';
/** @param {readonly string[]} gains */
export const givenText = (gains) =>
  gains.length > 0
    ? `, which gave ${gains.join(gains.length > 2 ? ', ' : ' and ')} with ${gains.length > 1 ? 'their' : 'its'} σ`
    : ', which gave nothing';
/** What becomes of gains that are drawn there. */
export const belowZeroText = {
  mirror: 'Gains below 0 are mirrored at 0 before they are tried.',
  clamp: 'Gains below 0 are held at 0 before they are tried.',
};
/** @param {string} sigma */
export const floorText = (sigma) => `No σ falls below ${sigma}.`;
export const cauchyText = 'C is drawn from Cauchy’s distribution, N from the normal one.';

/** What stands before the name of the other. @param {number} own @param {number} other */
export const comparedText = (own, other) =>
  own === other ? 'As good as ' : own < other ? 'Better than ' : 'Worse than ';

/** @param {number} starts */
export const meanText = (starts) => `J is the mean over ${starts} starts; the plane shows the first.`;

/** @param {number} wins @param {number} bouts */
export const sumText = (wins, bouts) => `${winsText(wins)} of ${bouts}`;

/** @param {number} rest */
export const moreBouts = (rest) => `and ${counted(rest, 'more bout', 'more bouts')}`;

/** @param {Anatomy} anatomy @param {number} number */
export function fateText({ ranks, staying, record, all, method }, number) {
  const rank = ranks[number] + 1;
  if (method === 'random') return `rank ${rank} of ${staying}`;
  if (method !== 'ep') return rank > staying ? 'is dropped' : `stays: rank ${rank} of ${staying}`;
  if (rank > staying) return `fell: rank ${rank} of ${all.length}`;
  return `survives as parent ${rank} of generation ${record.generation + 1}`;
}

/** @param {Anatomy['method']} method */
const always = (method) => (method === 'ep' ? ' The best always survives.' : '');
/** @param {Anatomy['method']} method @param {number} before @param {number} after @param {(cost: number) => string} usual */
export function bestText(method, before, after, usual) {
  const write = tellingApart(before, after, usual);
  if (method === 'random')
    return `The best of these draws has J ${write(after)}, of those before ${write(before)}. What is remembered is the best of all.`;
  return after < before
    ? `The best J falls from ${write(before)} to ${write(after)}.`
    : after === before
      ? `The best J stays ${write(after)}.${always(method)}`
      : `The best J rises from ${write(before)} to ${write(after)}: this search forgets what it had.`;
}

/** Where the slope was probed. @param {string} cost of the robot @param {boolean} isLower Whether a probe's is lower. */
export const probedText = (cost, isLower) =>
  `The robot’s J stays ${cost}.${isLower ? ' A probe only tells the slope: it is not taken, though its J is lower.' : ''}`;

/** @param {Anatomy} anatomy */
export function tableCaption(anatomy) {
  const { record, count, all } = anatomy;
  const counts = (/** @type {number} */ number) => `${nameOf(anatomy, number)} is its number ${number}`;
  return record.generation === 0
    ? `Generation 0: ${counted(count, 'robot', 'robots')} with random gains. The core’s record counts from 0: ${counts(0)}.`
    : `Generation ${record.generation}, all ${all.length}. The core’s record counts from 0: ${counts(0)}, ${counts(count)}. ${record.wins.length > 0 ? 'Most wins first.' : 'Survivors first.'}`;
}
const columns = [
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
/** @param {Anatomy['method']} method */
export const columnsOf = (method) => {
  const own = { de: { parent: 'member, a, b, c' }, 'cma-es': { wins: 'weight' } };
  const names = /** @type {Readonly<Record<string, string>>} */ (
    method === 'de' || method === 'cma-es' ? own[method] : {}
  );
  return columns.map((name) => names[name] ?? name);
};
export const yes = 'yes';
export const no = 'no';
