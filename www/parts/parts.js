// The parts of the page beside the lab, in the order in which it names them: one row each.
/** @import { Named } from '../lab/navigation.js' */
/** @import { Part } from './part.js' */
import { labSlice } from '../lab/state.js';
import { lab } from '../words/index.js';
import { language } from '../words/language.js';
import { curves } from './curves/part.js';
import { disturbance } from './disturbance/part.js';
import { generation } from './generation/part.js';
import { landscape } from './landscape/part.js';
import { luck } from './luck/part.js';
import { park } from './park/part.js';
import { robustness } from './robustness/part.js';
import { training } from './training/part.js';

/** @type {readonly Part[]} */
export const parts = [park, generation, curves, landscape, robustness, training, disturbance, luck];

/** What an address without a part opens. */
export const firstPage = park.name;
export const pageNames = ['lab', ...parts.map(({ name }) => name)];

/** What is said of them, by their names. @type {Record<string, Named>} */
export const named = {
  lab: { name: lab.labName, purpose: lab.labPurpose },
  ...Object.fromEntries(
    parts.map(({ name, called, room }) => {
      const said = called[language];
      return [name, { name: said.name, purpose: () => said.purpose, room }];
    }),
  ),
};

/** @param {string} page */
const partOf = (page) => parts.find(({ name }) => name === page);

/** What a run knows of them. @type {import('../run/actions/basis.js').Places} */
export const places = {
  triesStarts: (page) => partOf(page)?.tries?.includes('start') ?? false,
  triesDisturbance: (page) => partOf(page)?.tries?.includes('disturbance') ?? false,
  phases: /** @type {Part} */ (parts.find(({ phases }) => phases)).name,
  slices: [labSlice, ...parts.map(({ slice }) => slice)],
};

/** The pages on which something of the lab stands. @param {string | null} what */
export const pagesBeside = (what) => [
  'lab',
  ...parts.filter(({ beside = [] }) => beside.some((one) => one === what)).map(({ name }) => name),
];

/** What of the lab is in sight. @type {import('../lab/draw.js').InSight} */
export const inSight = {
  lab: ({ page }) => !partOf(page)?.alone,
  gains: (state) => state.page === 'lab' || (partOf(state.page)?.gains?.(state) ?? state.driver === 'hand'),
  pays: ({ page }) => partOf(page)?.pays ?? false,
  tells: ({ page }) => partOf(page)?.tells ?? false,
  steps: ({ page }) => partOf(page)?.phases ?? false,
};

/** What links know of them. @type {Omit<import('../link/link.js').Tables, 'lesson'>} */
export const linked = {
  pages: pageNames,
  places,
  keys: parts.flatMap(({ keys = [] }) => keys),
  mend: (opened, refuse) =>
    parts.reduce((mended, { mend }) => (mend ? mend(mended, refuse) : mended), opened),
};
