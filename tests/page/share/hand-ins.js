// Hand-ins of a class that was never there: made by the page's own receipts.
import { links } from '../../../www/lesson/links.js';
import { newWork } from '../../../www/run/state.js';
import { receiptOf } from '../../../www/share/handin/receipt.js';
import en from '../../../www/share/handin/words/index.js';
import { createEngine, paper } from '../harness/core.js';

export const engine = createEngine();
export const exercise =
  'lab&v=1&lock=postures,seed,settings&hide=paper&task=Park%20for%20less.&aim=J%3C7.9&points=9:0,7.75:10';
export const site = 'https://course.example/ep/';

/** What the page holds once it has opened a link. @param {string} link */
export async function opened(link) {
  const { parts, ...state } = links.openLink(link, engine).opened;
  const { population, statistics } = await engine.surveys.generation(state.experiment, state.generation);
  const history = Array.from({ length: state.generation + 1 }, () => statistics);
  return { ...state, slices: parts, population, history, work: newWork('') };
}

/** @param {string} link */
export const receipt = async (link) => receiptOf({ engine, links, paper: paper() }, await opened(link));

/** A receipt by hand, as text. @param {string} who @param {readonly number[]} gains @param {string} [from] */
export async function handedIn(who, gains, from = exercise) {
  const made = await receipt(`${from}&drives=hand&gains=${gains.join(',')}&who=${encodeURIComponent(who)}`);
  return { ...made, text: en.receiptText(made, `${site}#${made.link}`) };
}
