// Every word of σ over the generations, in Korean.
/** @import { Statistics } from '../../core/engine.js' */
import { sigmaText } from '../common/sigmas.js';

export * from '../common/sigmas.js';

export const curveLegend = '세대에 따른 곡선';
/** @type {import('../../kit/segmented.js').Choices<import('../common/kinds.js').LabCurve>} */
export const curveChoices = {
  cost: 'J',
  sigmas: { text: 'σ', hint: '이득별 평균 변이 폭' },
};
export const sigmaTitle = '평균 변이 폭';

/** @param {Statistics} first @param {Statistics} shown @param {readonly { name: string }[]} gains */
export const sigmaLabel = (first, shown, gains) =>
  `${shown.generation}세대에 걸친 이득별 평균 σ, 로그 축. ${gains
    .map(({ name }, i) => `${name}: ${sigmaText(first.meanSigmas[i])} → ${sigmaText(shown.meanSigmas[i])}`)
    .join(', ')}.`;

/** What stands before and after the name of a gain at its line. */
export const sigmaOf = ['', '의 σ'];
