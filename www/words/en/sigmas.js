// Every word of σ over the generations.
/** @import { Statistics } from '../../core/engine.js' */
import { sigmaText } from '../common/sigmas.js';

export * from '../common/sigmas.js';

export const curveLegend = 'Curve over the generations';
/** @type {import('../../kit/segmented.js').Choices<import('../common/kinds.js').LabCurve>} */
export const curveChoices = {
  cost: 'J',
  sigmas: { text: 'σ', hint: 'Mean step size of each gain' },
};
export const sigmaTitle = 'Mean step sizes';

/** @param {Statistics} first @param {Statistics} shown @param {readonly { name: string }[]} gains */
export const sigmaLabel = (first, shown, gains) =>
  `Mean σ of each gain over ${shown.generation} generations, on a logarithmic axis: ${gains
    .map(
      ({ name }, i) => `${name} from ${sigmaText(first.meanSigmas[i])} to ${sigmaText(shown.meanSigmas[i])}`,
    )
    .join(', ')}.`;

/** What stands before and after the name of a gain at its line. */
export const sigmaOf = ['σ of ', ''];
