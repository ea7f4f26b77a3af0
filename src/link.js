// The package's `ep-locomotion/link`: what a link of the page runs. It reads numbers as the page does, and none of its words but
// those that say what is wrong.
import { experiment as completed, evaluate } from '../pkg/ep_locomotion.js';
import { pathOf, withField } from '../www/link/experiment.js';
import { readAll } from '../www/link/together.js';
import { oneOf, pairOf, triple, wholeNumber } from '../www/link/values.js';

/** @typedef {import('./link.d.ts').LinkedRun} LinkedRun */

const presets = /** @type {const} */ (['velocity-limits', 'acceleration-limits']);

/** As long as what the page reads. */
const mostCharacters = 20_000;

/** What is read besides the fields of the experiment. @type {Record<string, (run: LinkedRun, text: string) => LinkedRun>} */
const keys = {
  preset: (run, text) => ({ ...run, preset: oneOf(presets, text) }),
  generation: (run, text) => ({ ...run, generation: wholeNumber(text, 100_000) }),
  drives: (run, text) => ({ ...run, drives: text }),
  gains(run, text) {
    const gains = triple(text);
    // The core knows which gains cannot be driven; one sample tells.
    evaluate({ horizon: 0.01 }, gains);
    return { ...run, gains };
  },
};

/** Whether a key is a field of the experiment, or a shorter name of one. @param {string} key @param {object} experiment */
const isField = (key, experiment) => pathOf(key).split('.')[0] in experiment;

/** @type {typeof import('./link.d.ts').openLink} */
export function openLink(link) {
  const text = link.slice(link.indexOf('#') + 1, mostCharacters).replaceAll('&amp;', '&');
  const [part, ...rest] = text.split('&');
  const given = new Map(rest.filter((pair) => pair !== '').map(pairOf));
  const preset = presets.find((one) => one === given.get('preset')) ?? presets[0];
  /** @type {LinkedRun} */
  const first = {
    part: part || 'lab',
    preset,
    experiment: completed(preset),
    generation: 0,
    drives: 'evolved',
    gains: null,
    others: {},
    problems: [],
  };
  const { opened, refused } = readAll(given, first, (run, key, value) => {
    if (Object.hasOwn(keys, key)) return keys[key](run, value);
    if (!isField(key, run.experiment)) return { ...run, others: { ...run.others, [key]: value } };
    return { ...run, experiment: completed(withField(run.experiment, pathOf(key), value)) };
  });
  const problems = refused.map(([key, error]) => `${key}: ${/** @type {Error} */ (error).message}`);
  if (link.length > mostCharacters) problems.push(`of ${link.length} characters ${mostCharacters} were read`);
  return { ...opened, problems };
}
