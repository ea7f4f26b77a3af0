// What the chosen individual went through in a phase, in the numbers of the record.
import { winsBout } from '../../core/rules.js';
import { create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { generation as words, lab } from '../../words/index.js';
import { createBell } from './bell.js';
import { isInitial, partnerOf } from './record.js';

/** @typedef {import('../../core/engine.js').Individual} Individual */
/** @typedef {import('./record.js').GenerationRecord['mutations'][number]} Mutation */
/** @typedef {import('../../core/engine.js').Run} Run */
/** @typedef {import('./record.js').Anatomy} Anatomy */
/** @typedef {import('./record.js').Phase} Phase */
/** @typedef {{ own: number, common: number }} Rates */
/** @typedef {{ anatomy: Anatomy, phase: Phase, chosen: number, run: Run, starts: number }} DetailsModel */

/** More bouts than that are told as a number. */
const mostBouts = 20;
/** A σ so small makes the numbers of a mutation long. */
const longBelow = 1e-3;
/** Ranks above and below the line of the cut. */
const aroundCut = 2;

/** @param {HTMLElement} root @param {Rates} rates @param {(number: number) => void} choose */
export function createDetails(root, rates, choose) {
  const changed = watch();
  const context = { rates, choose };
  return {
    /** @param {DetailsModel} model */
    draw(model) {
      const { anatomy, phase, chosen, run, starts } = model;
      // Only in one phase the drive itself is told.
      if (!changed(anatomy, phase, chosen, phase === 'drive' ? run : null, starts)) return;
      root.replaceChildren(...contents[phase](model, context));
    },
  };
}

/** @typedef {{ rates: Rates, choose: (number: number) => void }} Context */

/** @type {Record<Phase, (model: DetailsModel, context: Context) => HTMLElement[]>} */
const contents = {
  parents({ anatomy, chosen }) {
    const { record, all } = anatomy;
    const individual = all[chosen];
    const write = words.costWriter(anatomy);
    const from = isInitial(record) ? words.initialText : words.ranked(chosen + 1, record.generation - 1);
    return [
      headline(words.nameOf(anatomy, chosen), `J ${write(individual.cost)}`, from),
      gainRows('gain-rows', (i) => [
        createBell(null),
        equation(symbol('k', i), ` = ${words.gainText(individual.gains[i])}`),
        equation(symbol('σ', i), ` = ${words.sigmaText(individual.sigmas[i])}`),
      ]),
    ];
  },

  mutation({ anatomy, chosen }, { rates, choose }) {
    const { record, count } = anatomy;
    const pair = chosen % count;
    const [parent, child, draws] = [record.parents[pair], record.offspring[pair], record.mutations[pair]];
    return [
      create(
        'p',
        'headline',
        create(
          'span',
          '',
          individualLink(anatomy, pair, choose),
          ' → ',
          individualLink(anatomy, pair + count, choose),
        ),
        formula(),
      ),
      gainRows(Math.min(...parent.sigmas) < longBelow ? 'gain-rows long' : 'gain-rows', (i) => [
        createBell(draws.gains[i]),
        gainEquation(parent, child, draws, i),
        sigmaEquation(parent, child, draws, i, rates),
      ]),
      commonEquation(draws, rates),
    ];
  },

  drive({ anatomy, chosen, run, starts }, { choose }) {
    const { all } = anatomy;
    const { cost, gains } = all[chosen];
    const write = words.costWriter(anatomy);
    const partner = partnerOf(anatomy, chosen);
    const parts = lab.costParts.filter(([part]) => part !== 'penalty' || run.cost.penalty > 0);
    const sum = parts.flatMap(([part, name], i) => [
      i === 0 ? ' = ' : ' + ',
      create('span', `part part-${part}`, `${name} ${lab.partText(run.cost[part])}`),
    ]);
    return [
      headline(words.nameOf(anatomy, chosen), `J ${write(cost)}`, lab.outcomeText(run)),
      create(
        'p',
        'triple',
        ...gains.map((gain, i) => create('span', '', symbol('k', i), ` = ${words.gainText(gain)}`)),
      ),
      starts > 1
        ? create('p', 'muted', words.meanText(starts))
        : create('p', 'parts', create('i', '', 'J'), ...sum),
      create(
        'p',
        '',
        words.comparedText(cost, all[partner].cost),
        individualLink(anatomy, partner, choose),
        `, J ${write(all[partner].cost)}`,
      ),
    ];
  },

  tournament({ anatomy, chosen }, { choose }) {
    const { record, all } = anatomy;
    const { cost } = all[chosen];
    const write = words.costWriter(anatomy);
    const opponents = record.opponents[chosen];
    const bouts = Array.from(opponents.slice(0, mostBouts), (opponent) => {
      const won = winsBout(cost, all[opponent].cost);
      const sign = create('span', 'sign', won ? words.won : words.lost);
      sign.setAttribute('aria-label', won ? words.wonText : words.lostText);
      sign.setAttribute('role', 'img');
      return create(
        'li',
        won ? 'won' : 'lost',
        sign,
        individualLink(anatomy, opponent, choose),
        create('span', 'cost', write(all[opponent].cost)),
      );
    });
    const rest = opponents.length - bouts.length;
    return [
      headline(
        words.nameOf(anatomy, chosen),
        `J ${write(cost)}`,
        words.sumText(record.wins[chosen], opponents.length),
      ),
      create('ul', 'bouts', ...bouts, ...(rest > 0 ? [create('li', 'muted', words.moreBouts(rest))] : [])),
    ];
  },

  ranking({ anatomy, chosen }, { choose }) {
    const { count, ranking, ranks } = anatomy;
    const near = ranking.map((_, rank) => rank).slice(Math.max(0, count - aroundCut), count + aroundCut);
    const own = ranks[chosen];
    const rows = [...new Set([own, ...near])].sort((a, b) => a - b);
    return [
      headline(words.nameOf(anatomy, chosen), words.fateText(anatomy, chosen)),
      create('ol', 'ranks', ...rows.map((rank) => rankRow(anatomy, rank, own, choose))),
      upsetOf(anatomy),
    ];
  },

  survivors({ anatomy, chosen }) {
    const { record, all, count, ranking } = anatomy;
    const write = words.costWriter(anatomy);
    const best = (/** @type {Individual[]} */ some) => Math.min(...some.map(({ cost }) => cost));
    const after = best(ranking.slice(0, count).map((number) => all[number]));
    return [
      headline(
        words.nameOf(anatomy, chosen),
        `J ${write(all[chosen].cost)}`,
        words.fateText(anatomy, chosen),
      ),
      ...(isInitial(record)
        ? []
        : [create('p', '', words.bestText(best(record.parents), after, write)), upsetOf(anatomy)]),
    ];
  },
};

/** @param {Anatomy} anatomy */
const upsetOf = (anatomy) => create('p', 'upset', words.upsetText(anatomy));

/** @param {string} name @param {string[]} facts */
const headline = (name, ...facts) =>
  create('p', 'headline', create('strong', '', words.capital(name)), create('span', '', facts.join(' · ')));

/** @param {Anatomy} anatomy @param {number} number @param {(number: number) => void} choose */
function individualLink(anatomy, number, choose) {
  const button = create('button', 'link', words.nameOf(anatomy, number));
  button.setAttribute('type', 'button');
  button.addEventListener('click', () => choose(number));
  return button;
}

/** @param {string} className @param {(i: number) => (Node | string)[]} cells */
const gainRows = (className, cells) =>
  create('div', className, ...lab.gains.map(({ id }, i) => create('div', `gain-row ${id}`, ...cells(i))));

/** @param {string} letter @param {number} i */
const symbol = (letter, i) =>
  create('span', `symbol ${lab.gains[i].id}`, letter, create('sub', '', lab.gains[i].index));

/** @param {(Node | string)[]} parts */
const equation = (...parts) => create('p', 'equation', ...parts);

/** k + σ N = k′ @param {Individual} parent @param {Individual} child @param {Mutation} draws @param {number} i */
function gainEquation(parent, child, draws, i) {
  const sigma = parent.sigmas[i];
  const step = `${words.sigmaText(sigma)} × ${words.bracketed(words.drawText(draws.gains[i]))}`;
  const gain = (/** @type {Individual} */ { gains }) => words.gainText(gains[i], sigma);
  return equation(symbol('k', i), ` ${gain(parent)} + ${step} = ${gain(child)}`);
}

/** σ e^(τ′N + τN) = σ′, where τ′N is the same for all three. @param {Individual} parent @param {Individual} child @param {Mutation} draws @param {number} i @param {Rates} rates */
function sigmaEquation(parent, child, draws, i, rates) {
  const own = `${words.drawText(rates.own)} × ${words.bracketed(words.drawText(draws.sigmas[i]))}`;
  return equation(
    symbol('σ', i),
    ` ${words.sigmaText(parent.sigmas[i])} × e`,
    create('sup', '', `${words.drawText(rates.common * draws.common)} + ${own}`),
    ` = ${words.sigmaText(child.sigmas[i])}`,
  );
}

/** @param {Mutation} draws @param {Rates} rates */
function commonEquation({ common }, rates) {
  const product = `${words.drawText(rates.common)} × ${words.bracketed(words.drawText(common))}`;
  return create(
    'p',
    'common muted',
    `${words.drawText(rates.common * common)} = ${product}${words.commonText}`,
  );
}

const formula = () =>
  create(
    'span',
    'rule muted',
    words.formula.gain,
    create('span', 'gap'),
    words.formula.sigma,
    create('sup', '', words.formula.exponent),
  );

/** @param {Anatomy} anatomy @param {number} rank @param {number} own @param {(number: number) => void} choose */
function rankRow(anatomy, rank, own, choose) {
  const { ranking, record, all, count } = anatomy;
  const individual = ranking[rank];
  const row = create(
    'li',
    [rank === own ? 'own' : '', rank >= count ? 'falls' : 'stays', rank === count ? 'first' : '']
      .join(' ')
      .trim(),
    create('span', 'rank', `${rank + 1}.`),
    individualLink(anatomy, individual, choose),
    create('span', 'wins', words.winsText(record.wins[individual])),
    create('span', 'cost', `J ${words.costWriter(anatomy)(all[individual].cost)}`),
  );
  return row;
}
