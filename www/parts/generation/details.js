// What the chosen individual went through in a phase, in the numbers of the record.
/** @import { TemplateResult } from 'lit-html' */
/** @import { Individual, Run } from '../../core/engine.js' */
/** @import { Successes } from './detail-methods.js' */
/** @import { Anatomy, GenerationRecord, Phase } from './record.js' */
import { html, nothing } from 'lit-html';
import { winsBout } from '../../core/rules.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { bell } from './bell.js';
import { forgets } from './phases.js';
import { gainRows, headline, link, symbol } from './detail.js';
import { learntBy, madeBy, standsBy, weighedBy } from './detail-methods.js';
import { isInitial, partnerOf } from './record.js';

/** @typedef {GenerationRecord['mutations'][number]} Mutation */
/** @typedef {{ own: number, common: number }} Rates */
/** @typedef {{ anatomy: Anatomy, phase: Phase, chosen: number, run: Run, starts: number, successes: Successes | null }} DetailsModel */
/** @typedef {{ rates: Rates, choose: (number: number) => void }} Context */

/** τ and τ′ as an experiment has them: the paper's, times its factor. @param {Rates} rates @param {number} adaptation @returns {Rates} */
export const ratesOf = ({ own, common }, adaptation) => ({
  own: adaptation * own,
  common: adaptation * common,
});

/** More bouts than that are told as a number. */
const mostBouts = 20;
/** A σ so small makes the numbers of a mutation long. */
const longBelow = 1e-3;
/** Ranks above and below the line of the cut. */
const aroundCut = 2;

/** @param {DetailsModel} model @param {Context} context */
export const detailsOf = (model, context) => contents[model.phase](model, context);

/** @type {Record<Phase, (model: DetailsModel, context: Context) => TemplateResult>} */
const contents = {
  parents({ anatomy, chosen }) {
    const { record, all } = anatomy;
    const { cost, gains, sigmas } = all[chosen];
    const from = isInitial(record)
      ? words.initialText(anatomy)
      : words.ranked(chosen + 1, record.generation - 1);
    const told = headline(anatomy, chosen, `J ${words.costWriter(anatomy)(cost)}`, from);
    if (anatomy.method !== 'ep') return html`${told}${standsBy(anatomy, chosen)}`;
    const row = (/** @type {number} */ i) => html`
      ${bell(null)}
      <p class="equation">${symbol('k', i)} = ${words.gainText(gains[i])}</p>
      <p class="equation">${symbol('σ', i)} = ${words.sigmaText(sigmas[i])}</p>`;
    return html`
      ${told}
      ${gainRows('gain-rows', row)}`;
  },

  mutation({ anatomy, chosen }, { rates, choose }) {
    const { record, count } = anatomy;
    if (anatomy.method !== 'ep') return madeBy(anatomy, chosen, choose);
    const pair = chosen % count;
    // Where parents are crossed, it begins with what came of that.
    const parent = record.bases[pair] ?? record.parents[pair];
    const [child, draws] = [record.offspring[pair], record.mutations[pair]];
    const row = (/** @type {number} */ i) => html`
      ${bell(draws.gains[i])}
      ${gainEquation(parent, child, draws, i)}
      ${sigmaEquation(parent, child, draws, i, rates)}`;
    const { gain, sigma, exponent } = words.formula;
    return html`
      <p class="headline"><span>${link(anatomy, pair, choose)} → ${link(anatomy, pair + count, choose)}</span><span
        class="rule muted">${gain}<span class="gap"></span>${sigma}<sup>${exponent}</sup></span></p>
      ${gainRows(Math.min(...parent.sigmas) < longBelow ? 'gain-rows long' : 'gain-rows', row)}
      ${commonEquation(draws, rates)}`;
  },

  drive({ anatomy, chosen, run, starts }, { choose }) {
    const { all, method } = anatomy;
    const { cost, gains } = all[chosen];
    const write = words.costWriter(anatomy);
    const partner = partnerOf(anatomy, chosen);
    const parts = lab.costParts.filter(([part]) => part !== 'penalty' || run.cost.penalty > 0);
    const sum = parts.map(
      ([part, name], i) =>
        html`${i === 0 ? ' = ' : ' + '}<span class="part part-${part}">${name} ${lab.partText(run.cost[part])}</span>`,
    );
    return html`
      ${headline(anatomy, chosen, `J ${write(cost)}`, lab.outcomeText(run))}
      <p class="triple">${gains.map((gain, i) => html`<span>${symbol('k', i)} = ${words.gainText(gain)}</span>`)}</p>
      ${starts > 1 ? html`<p class="muted">${words.meanText(starts)}</p>` : html`<p class="parts"><i>J</i>${sum}</p>`}
      ${forgets(method) ? nothing : html`<p>${words.comparedText(cost, all[partner].cost)}${link(anatomy, partner, choose)}, J ${write(all[partner].cost)}</p>`}`;
  },

  tournament({ anatomy, chosen }, { choose }) {
    const { record, all } = anatomy;
    const { cost } = all[chosen];
    const write = words.costWriter(anatomy);
    const opponents = record.opponents[chosen];
    const bouts = Array.from(opponents.slice(0, mostBouts), (opponent) => {
      const won = winsBout(cost, all[opponent].cost);
      return html`<li class=${won ? 'won' : 'lost'}><span class="sign" role="img"
        aria-label=${won ? words.wonText : words.lostText}>${won ? words.won : words.lost}</span>${link(anatomy, opponent, choose)}<span
        class="cost">${write(all[opponent].cost)}</span></li>`;
    });
    const rest = opponents.length - bouts.length;
    return html`
      ${headline(anatomy, chosen, `J ${write(cost)}`, words.sumText(record.wins[chosen], opponents.length))}
      <ul class="bouts">${bouts}${rest > 0 ? html`<li class="muted">${words.moreBouts(rest)}</li>` : nothing}</ul>`;
  },

  ranking({ anatomy, chosen }, { choose }) {
    const { counting, ranked, ranks } = anatomy;
    const last = Math.min(ranked, counting + aroundCut);
    const near = Array.from({ length: ranked }, (_, rank) => rank).slice(
      Math.max(0, counting - aroundCut),
      last,
    );
    const own = ranks[chosen];
    const rows = [...new Set([own, ...near])].sort((a, b) => a - b);
    return html`
      ${headline(anatomy, chosen, words.fateText(anatomy, chosen))}
      <ol class="ranks">${rows.map((rank) => rankRow(anatomy, rank, own, choose))}</ol>
      ${anatomy.method === 'ep' ? upset(anatomy) : weighedBy(anatomy, chosen)}`;
  },

  survivors({ anatomy, chosen, successes }) {
    const { record, all, staying, ranking, method } = anatomy;
    const write = words.costWriter(anatomy);
    const best = (/** @type {Individual[]} */ some) => Math.min(...some.map(({ cost }) => cost));
    const after = best(ranking.slice(0, staying).map((number) => all[number]));
    const told = () => html`
      <p>${words.bestText(method, best(record.parents), after, write)}</p>
      ${method === 'ep' || method === 'de' ? upset(anatomy) : learntBy(anatomy, successes)}`;
    return html`
      ${headline(anatomy, chosen, `J ${write(all[chosen].cost)}`, words.fateText(anatomy, chosen))}
      ${isInitial(record) ? nothing : told()}`;
  },
};

/** @param {Anatomy} anatomy */
const upset = (anatomy) => html`<p class="upset">${words.upsetText(anatomy)}</p>`;

/** k + σ N = k′ @param {Individual} parent @param {Individual} child @param {Mutation} draws @param {number} i */
function gainEquation(parent, child, draws, i) {
  const sigma = parent.sigmas[i];
  const step = `${words.sigmaText(sigma)} × ${words.bracketed(words.drawText(draws.gains[i]))}`;
  const gain = (/** @type {Individual} */ { gains }) => words.gainText(gains[i], sigma);
  return html`<p class="equation">${symbol('k', i)} ${gain(parent)} + ${step} = ${gain(child)}</p>`;
}

/** σ e^(τ′N + τNᵢ) = σ′, where τ′N is the same for all three. @param {Individual} parent @param {Individual} child @param {Mutation} draws @param {number} i @param {Rates} rates */
function sigmaEquation(parent, child, draws, i, rates) {
  const own = `${words.drawText(rates.own)} × ${words.bracketed(words.drawText(draws.sigmas[i]))}`;
  const exponent = `${words.drawText(rates.common * draws.common)} + ${own}`;
  const sigma = (/** @type {Individual} */ { sigmas }) => words.sigmaText(sigmas[i]);
  return html`<p class="equation">${symbol('σ', i)} ${sigma(parent)} × e<sup>${exponent}</sup> = ${sigma(child)}</p>`;
}

/** @param {Mutation} draws @param {Rates} rates */
function commonEquation({ common }, rates) {
  const product = `${words.drawText(rates.common)} × ${words.bracketed(words.drawText(common))}`;
  return html`<p class="common muted">${words.drawText(rates.common * common)} = ${product}${words.commonText}</p>`;
}

/** @param {Anatomy} anatomy @param {number} rank @param {number} own @param {(number: number) => void} choose */
function rankRow(anatomy, rank, own, choose) {
  const { ranking, record, all, counting } = anatomy;
  const individual = ranking[rank];
  const classes = [rank === own && 'own', rank >= counting ? 'falls' : 'stays', rank === counting && 'first'];
  const { weights } = record.plan;
  const told = weights.length > 0 ? words.weightText(weights[rank] ?? 0) : nothing;
  return html`
    <li class=${classes.filter(Boolean).join(' ')}>
      <span class="rank">${rank + 1}.</span>
      ${link(anatomy, individual, choose)}
      <span class="wins">${record.wins.length > 0 ? words.winsText(record.wins[individual]) : told}</span>
      <span class="cost">J ${words.costWriter(anatomy)(all[individual].cost)}</span>
    </li>`;
}
