// What pictures are taken of: every part, step and dialog of the page, each by the link that opens it and what is pressed then.
import { pageNames } from '../../www/parts/parts.js';

/** @typedef {readonly [width: number, height: number]} Size */
/**
 * @typedef {object} State
 * @property {string} name
 * @property {string} link What follows the address of the page.
 * @property {readonly string[]} [press] The texts of what is pressed, one after the other.
 * @property {true} [isWithoutScripts]
 * @property {true} [isPrinted]
 */
/** @typedef {State & { size: Size, theme: 'light' | 'dark', language: 'en' | 'ko' }} View */

const pins = 'pin1=first~5,1,5&pin2=second~8.2,3.1,7~law:kanayama';

/** Of those parts of which more is to be seen than one generation. @type {Readonly<Record<string, readonly State[]>>} */
const more = {
  lab: [
    { name: 'lab', link: '#lab' },
    { name: 'lab-evolved', link: `#lab&v=1&generation=40&${pins}` },
  ],
  generation: [{ name: 'generation', link: '#generation&v=1&generation=3' }],
  curves: [
    { name: 'curves', link: `#curves&v=1&generation=20&${pins}` },
    { name: 'stability', link: '#curves&v=1&view=stability&generation=20' },
    { name: 'compare', link: `#curves&v=1&view=compare&generation=20&${pins}` },
  ],
  luck: [
    { name: 'luck', link: '#luck&v=1&generation=20' },
    { name: 'contest', link: '#luck&v=1&luck=contest' },
  ],
};

/** @type {readonly State[]} */
const parts = pageNames.flatMap((name) => more[name] ?? [{ name, link: `#${name}&v=1&generation=20` }]);

/** @type {readonly State[]} */
const choices = [
  { name: 'lab-hand', link: '#lab&v=1&drives=hand&gains=9.5,3.25,12&generation=5&curve=sigmas' },
  { name: 'lab-limits', link: '#lab&v=1&preset=acceleration-limits&generation=100&drives=paper-ep' },
  { name: 'lab-starts', link: '#lab&v=1&start=0,0,0;1,-1,90;-0.5,0.5,45&generation=10' },
  { name: 'lab-refused', link: '#lab&v=1&seed=-1&nothing=2' },
  { name: 'generation-parents', link: '#generation&v=1&generation=3&individual=7' },
  { name: 'generation-duel', link: '#generation&v=1&generation=3&phase=tournament&individual=12' },
  { name: 'generation-children', link: '#generation&v=1&generation=3&phase=mutation&individual=4' },
  { name: 'numbers', link: '#curves&v=1&view=numbers&generation=20' },
  { name: 'stability-log', link: '#curves&v=1&view=stability&scale=log&law=kanayama&generation=4' },
  { name: 'landscape-ellipse', link: '#landscape&v=1&evolution.method=cma-es&generation=9' },
  { name: 'landscape-differences', link: '#landscape&v=1&evolution.method=de&generation=9' },
  { name: 'landscape-simplex', link: '#landscape&v=1&evolution.method=nelder-mead&generation=9' },
  { name: 'landscape-sigma', link: '#landscape&v=1&x=kx&y=ky&third=3&generation=2' },
  { name: 'robustness-time', link: '#robustness&v=1&colour=time&half=2&heading=3' },
  { name: 'robustness-cost', link: '#robustness&v=1&colour=cost&generation=20' },
  { name: 'disturbance-kick', link: '#disturbance&v=1&under=random,0.1,0.1,7&generation=20' },
];

/** @type {readonly State[]} */
const opened = [
  { name: 'settings', link: '#lab', press: ['Settings'] },
  { name: 'share', link: '#lab&v=1&generation=2', press: ['Share'] },
  { name: 'share-curves', link: '#curves&v=1&generation=2', press: ['Share'] },
  { name: 'maker', link: '#lab', press: ['Share', 'Make an exercise'] },
  { name: 'keys', link: '#lab', press: ['Keys'] },
  { name: 'checks', link: '#lab', press: ['Keys', 'Check its numbers'] },
  { name: 'table-fitness', link: '#lab&v=1&generation=20', press: ['Table'] },
  { name: 'table-landscape', link: '#landscape', press: ['Table'] },
  { name: 'table-stability', link: '#curves&v=1&view=stability', press: ['Table'] },
  { name: 'table-generation', link: '#generation&v=1&generation=2', press: ['Table'] },
  { name: 'evolved-luck', link: '#luck&v=1&population=12&opponents=3', press: ['Run 100 seeds'] },
  { name: 'run-contest', link: '#luck&v=1&luck=contest&seeds=15&budget=1000', press: ['Run 4 × 15 seeds'] },
  { name: 'evolved-training', link: '#training&v=1&population=12&opponents=3', press: ['Evolve all three'] },
  {
    name: 'exercise',
    link: '#lab&v=1&lock=gains,clock&hide=paper,settings&task=Find%20gains%20that%20arrive%20sooner.',
  },
  { name: 'exercise-curves', link: '#curves&v=1&lock=parts&hide=share,gains&task=Why%3F' },
];

/** The steps of the lesson. @type {readonly State[]} */
const lesson = [
  ...Array.from({ length: 14 }, (_, i) => ({
    name: `lesson-${String(i + 1).padStart(2, '0')}`,
    link: `#lesson&step=${i + 1}`,
  })),
  ...['contest', 'build'].map((name) => ({ name: `lesson-${name}`, link: `#lesson&step=${name}` })),
];

/** @type {readonly State[]} */
const embedded = [
  ...parts.filter(({ name }) => name !== 'lab-evolved'),
  ...choices.filter(({ name }) => ['lab-hand', 'numbers', 'generation-duel'].includes(name)),
  ...opened.filter(({ name }) => name === 'exercise'),
].map(({ name, link }) => ({ name: `embed-${name}`, link: `?embed${link}` }));

/** @type {readonly State[]} */
const still = [{ name: 'without-scripts', link: '', isWithoutScripts: true }];
/** @type {readonly State[]} */
const printed = parts
  .filter(({ name }) => ['lab-evolved', 'generation', 'curves', 'stability'].includes(name))
  .map((state) => ({ ...state, name: `print-${state.name}`, isPrinted: true }));

const laptop = /** @type {Size} */ ([1440, 900]);
const projector = /** @type {Size} */ ([1024, 768]);
const phone = /** @type {Size} */ ([390, 844]);

/** @param {readonly State[]} states @param {Size} size @param {View['theme']} theme @param {View['language']} language @returns {View[]} */
const seen = (states, size, theme, language) =>
  states
    // Texts that are pressed are English.
    .filter(({ press }) => language === 'en' || !press)
    .map((state) => ({ ...state, size, theme, language }));

/** @param {readonly State[]} states @param {number} remainder */
const half = (states, remainder) => states.filter((_, i) => i % 2 === remainder);

/** Everything in light and English on a laptop and on a telephone; a sample of everything else. */
export const views = [
  ...seen([...parts, ...choices, ...opened, ...lesson, ...still, ...printed], laptop, 'light', 'en'),
  ...seen([...parts, ...choices, ...opened, ...lesson, ...still], phone, 'light', 'en'),
  ...seen(parts, projector, 'light', 'en'),
  ...seen(parts, projector, 'dark', 'ko'),
  ...seen([...parts, ...half(opened, 1), ...half(lesson, 1), ...still], laptop, 'dark', 'en'),
  ...seen([...parts, ...half(opened, 0)], phone, 'dark', 'en'),
  ...seen([...parts, ...half(lesson, 0), ...still], laptop, 'light', 'ko'),
  ...seen([...parts, ...half(lesson, 1)], phone, 'light', 'ko'),
  ...seen(embedded, [400, 300], 'light', 'en'),
  ...seen(embedded, [640, 420], 'light', 'en'),
  ...seen(half(embedded, 0), [400, 300], 'dark', 'ko'),
];

/** What names the picture. @param {View} view */
export const nameOf = ({ name, size, theme, language }) => `${name}-${size.join('x')}-${theme}-${language}`;

/** The link, in its language. @param {View} view */
export function linkOf({ link, language }) {
  if (language === 'en') return link;
  const [before, hash = ''] = link.split('#');
  const [part, ...pairs] = (hash || 'lab').split('&');
  return `${before}#${[part, ...(pairs.some((pair) => pair.startsWith('step=')) ? [] : ['v=1']), `lang=${language}`, ...pairs.filter((pair) => pair !== 'v=1')].join('&')}`;
}
