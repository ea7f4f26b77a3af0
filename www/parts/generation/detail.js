// What the numbers of a phase are told with.
/** @import { TemplateResult } from 'lit-html' */
/** @import { Anatomy } from './record.js' */
import { html, nothing } from 'lit-html';
import { lab } from '../../words/index.js';
import words from './words/index.js';

/** @param {Anatomy} anatomy @param {number} number @param {string[]} facts */
export const headline = (anatomy, number, ...facts) =>
  html`<p class="headline row"><strong>${words.capital(words.nameOf(anatomy, number))}</strong><span>${facts.join(' · ')}</span></p>`;

/** @param {Anatomy} anatomy @param {number} number @param {(number: number) => void} choose */
export const link = (anatomy, number, choose) =>
  html`<button class="link on-paper" type="button" @click=${() => choose(number)}>${words.nameOf(anatomy, number)}</button>`;

/** @param {string} className @param {(i: number) => TemplateResult} row */
export const gainRows = (className, row) =>
  html`<div class=${className}>${lab.gains.map(({ id }, i) => html`<div class="gain-row ${id}">${row(i)}</div>`)}</div>`;

/** @param {string} letter @param {number} i */
export const symbol = (letter, i) =>
  html`<span translate="no" class="symbol ${lab.gains[i].id}">${letter}<sub>${lab.gains[i].index}</sub></span>`;

/** What is told of the next generation's. @param {string} letter @param {number} i */
export const becoming = (letter, i) =>
  html`<span translate="no" class="symbol ${lab.gains[i].id}">${letter}<sub>${lab.gains[i].index}</sub>′</span> =`;

/** What becomes of numbers that follow an arrow, and what is drawn, where that is not the paper's. @param {Anatomy} anatomy */
export function rulesOf({ method, step, belowZero, sigmaFloor }) {
  const rules = [
    belowZero === 'penalty' ? '' : words.belowZeroText[belowZero],
    method === 'ep' && sigmaFloor > 0 ? words.floorText(words.sigmaText(sigmaFloor)) : '',
    method === 'ep' && step === 'cauchy' ? words.cauchyText : '',
  ].filter(Boolean);
  return rules.length > 0 ? html`<p class="common muted">${rules.join(' ')}</p>` : nothing;
}
