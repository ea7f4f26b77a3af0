// What the chosen individual went through in a phase, in the numbers of the record.
/** @import { TemplateResult } from 'lit-html' */
/** @import { Individual, Run } from '../../core/engine.js' */
/** @import { Birth, Rates } from './birth.js' */
/** @import { Successes } from './detail-methods.js' */
/** @import { Anatomy, Phase } from './record.js' */
import { range } from 'd3-array';
import { html, nothing } from 'lit-html';
import { forgets, methods } from '../../core/methods.js';
import { winsBout } from '../../core/rules.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { bell, shareOf } from './bell.js';
import { birthOf, grownSigma, movedGain } from './birth.js';
import { becoming, gainRows, headline, link, rulesOf, symbol } from './detail.js';
import { learntBy, madeBy, standsBy, weighedBy } from './detail-methods.js';
import { isInitial, partnerOf } from './record.js';

/** `fallen`: who was shown in the generation before, if it fell there. @typedef {{ anatomy: Anatomy, phase: Phase, chosen: number, fallen: string, run: Run, starts: number, successes: Successes | null }} DetailsModel */
/** @typedef {{ rates: Rates, choose: (number: number) => void }} Context */

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
  parents({ anatomy, chosen, fallen }) {
    const { record, all } = anatomy;
    const { cost, gains, sigmas } = all[chosen];
    const from = isInitial(record)
      ? words.initialText(anatomy)
      : words.ranked(chosen + 1, record.generation - 1);
    const told = headline(anatomy, chosen, `J ${words.costWriter(anatomy)(cost)}`, from);
    const isOwn = anatomy.method === 'ep';
    const note = fallen === '' ? (isOwn ? words.bellsText : '') : words.fallenText(anatomy, fallen);
    const row = (/** @type {number} */ i) => html`
      ${bell(null, anatomy.step, shareOf(sigmas, i))}
      <p class="equation">${symbol('k', i)} = ${words.gainText(gains[i])}</p>
      <p class="equation">${symbol('σ', i)} = ${words.sigmaText(sigmas[i])}</p>`;
    return html`
      ${told}
      ${isOwn ? gainRows('gain-rows', row) : standsBy(anatomy, chosen)}
      ${note === '' ? nothing : html`<p class="common muted">${note}</p>`}`;
  },

  mutation({ anatomy, chosen }, { rates, choose }) {
    const { count, step } = anatomy;
    const pair = chosen % count;
    const birth = birthOf(anatomy, pair);
    if (!birth) return madeBy(anatomy, chosen, choose);
    const row = (/** @type {number} */ i) => html`
      ${bell(birth.draws.gains[i], step, shareOf(birth.base.sigmas, i))}
      ${gainEquation(birth, i)}
      ${sigmaEquation(birth, i, rates)}`;
    const { gain, sigma, exponent, index } = words.formula;
    return html`
      <p class="headline row"><span>${link(anatomy, pair, choose)} → ${link(anatomy, pair + count, choose)}</span><span
        class="rule muted">${gain[step]}<span class="gap"></span>${sigma}<sup>${exponent}<sub>${index}</sub></sup></span></p>
      ${birth.other === null ? nothing : crossing(anatomy, birth, birth.other, choose)}
      ${gainRows(Math.min(...birth.base.sigmas) < longBelow ? 'gain-rows long' : 'gain-rows', row)}
      ${commonEquation(birth, rates)}
      ${rulesOf(anatomy)}`;
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
      return html`<li class="row ${won ? 'won' : 'lost'}"><span class="sign" role="img"
        aria-label=${won ? words.wonText : words.lostText}>${won ? words.won : words.lost}</span>${link(anatomy, opponent, choose)}<span
        class="cost">${write(all[opponent].cost)}</span></li>`;
    });
    const rest = opponents.length - bouts.length;
    return html`
      ${headline(anatomy, chosen, `J ${write(cost)}`, words.sumText(record.wins[chosen], opponents.length))}
      <ul class="bouts">${bouts}${rest > 0 ? html`<li class="row muted">${words.moreBouts(rest)}</li>` : nothing}</ul>`;
  },

  ranking({ anatomy, chosen }, { choose }) {
    const { counting, ranked, ranks } = anatomy;
    const near = range(Math.max(0, counting - aroundCut), Math.min(ranked, counting + aroundCut));
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
    const isProbed = method === 'finite-differences' && !record.plan.steps;
    const told = () => html`
      <p>${isProbed ? words.probedText(write(after), best(record.offspring) < after) : words.bestText(method, best(record.parents), after, write)}</p>
      ${methods[method].upsets ? upset(anatomy) : learntBy(anatomy, successes)}`;
    return html`
      ${headline(anatomy, chosen, `J ${write(all[chosen].cost)}`, words.fateText(anatomy, chosen))}
      ${isInitial(record) ? nothing : told()}`;
  },
};

/** @param {Anatomy} anatomy */
const upset = (anatomy) => html`<p class="upset">${words.upsetText(anatomy)}</p>`;

/** With whom the parent was crossed, and what it got. @param {Anatomy} anatomy @param {Birth} birth @param {number} other @param {(number: number) => void} choose */
function crossing(anatomy, { parent, base }, other, choose) {
  const isOwn = (/** @type {number} */ i) =>
    base.gains[i] === parent.gains[i] && base.sigmas[i] === parent.sigmas[i];
  const given = lab.gains.flatMap(({ name }, i) => (isOwn(i) ? [] : [name]));
  return html`<p class="donors"><span>${words.crossedWith}${link(anatomy, other, choose)}${words.givenText(given)}</span></p>`;
}

/** kᵢ + σᵢ Nᵢ = kᵢ′ @param {Birth} birth @param {number} i */
function gainEquation(birth, i) {
  const { base, child, draws } = birth;
  const sigma = base.sigmas[i];
  const moved = words.gainText(movedGain(birth, i), sigma);
  const [from, wide, draw] = words.addingUp(
    [
      (more) => words.gainText(base.gains[i], sigma, more),
      (more) => words.sigmaWith(sigma, more),
      (more) => words.drawText(draws.gains[i], more),
    ],
    (k, σ, n) => k + σ * n,
    moved,
  );
  const sum = words.becomes(moved, words.gainText(child.gains[i], sigma));
  return html`<p class="equation">${becoming('k', i)} ${from} + ${wide} × ${words.bracketed(draw)} = ${sum}</p>`;
}

/** σᵢ e^(τ′N + τNᵢ′) = σᵢ′, where τ′N is the same for all three. @param {Birth} birth @param {number} i @param {Rates} rates */
function sigmaEquation(birth, i, rates) {
  const { base, child, draws } = birth;
  const own = `${words.drawText(rates.own)} × ${words.bracketed(words.drawText(draws.sigmas[i]))}`;
  const exponent = `${words.drawText(rates.common * draws.common)} + ${own}`;
  const product = words.becomes(
    words.sigmaText(grownSigma(birth, i, rates)),
    words.sigmaText(child.sigmas[i]),
  );
  return html`<p class="equation">${becoming('σ', i)} ${words.sigmaText(base.sigmas[i])} × e<sup>${exponent}</sup> =\u00a0${product}</p>`;
}

/** τ′N @param {Birth} birth @param {Rates} rates */
function commonEquation({ draws: { common } }, rates) {
  const product = words.drawText(rates.common * common);
  const [rate, draw] = words.addingUp(
    [(more) => words.drawText(rates.common, more), (more) => words.drawText(common, more)],
    (τ, n) => τ * n,
    product,
  );
  return html`<p class="common muted">${product} = ${rate} × ${words.bracketed(draw)}${words.commonText}</p>`;
}

/** @param {Anatomy} anatomy @param {number} rank @param {number} own @param {(number: number) => void} choose */
function rankRow(anatomy, rank, own, choose) {
  const { ranking, record, all, counting, expected } = anatomy;
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
      ${expected.length > 0 ? html`<span class="luck">${words.luckText(expected[individual], record.wins[individual])}</span>` : nothing}
    </li>`;
}
