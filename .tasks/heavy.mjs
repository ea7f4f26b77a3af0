// npm run heavy: how long links and settings that ask for much hold the built page at once, in Chromium: the longest
// task of its thread, in milliseconds of the processor, and the longest call of the core in it, in milliseconds of the
// clock. On a busy machine both are more than there is, the second much more.
//
//   npm run heavy -- [--site DIR] [--only TEXT]
import { parseArgs } from 'node:util';
import { pageNames } from '../www/parts/parts.js';
import { openChromium } from './chromium.mjs';
import { probe } from './probe.mjs';
import { Failure, needBuilt, task } from './run.mjs';
import { serveCompressed } from './serve.mjs';

/** Milliseconds. */
const aim = 50;
/** How long the page is watched once it is ready, and after each press. */
const watched = 4000;

/** Starts around the goal. @param {number} count */
const starts = (count) =>
  `start=${Array.from({ length: count }, (_, i) => `${i % 9},${Math.floor(i / 9) % 9},0`).join(';')}`;

const long = 'sampleTime=0.001&horizon=100';
const many = Array.from({ length: 4600 }, (_, i) => `a${i}=`).join('&');
const population = 'evolution.population=2000';
const pin = (/** @type {number} */ i) =>
  `pin${i}=p${i}~${i + 2},5,5~sampleTime:0.001~horizon:100~goal.x:90~goal.y:${i * 9}`;
/** Goals that no robot reaches: all samples are driven. */
const never = 'goal.x=900&goal.y=900&limits.speed=0.01';

/** Receipts of as many students. @param {number} count */
const handIns = (count) =>
  Array.from(
    { length: count },
    (_, i) =>
      `lab&v=1&drives=hand&gains=${3 + i / 1000},0,4.5&task=Park.&aim=J<8&who=s${i}&handin=1~7.9~1/1~3~2~0.1.0~0123abcd~~0123abcd`,
  ).join('\n');

/** A link, and what is pressed then, or typed. @typedef {readonly [link: string, ...press: (string | readonly [field: string, text: string])[]]} Steps */
/** @type {readonly (readonly [name: string, ...Steps])[]} */
const cases = [
  ['nothing heavy', 'lab'],
  ['population 2000, opponents 1000', `lab&v=1&${population}&evolution.opponents=1000`],
  ['the same, one generation', `lab&v=1&${population}&evolution.opponents=1000`, '#one-generation'],
  ['Generation, the same', `generation&v=1&generation=1&${population}&evolution.opponents=1000`],
  [
    'Generation, population 2000, table',
    `generation&v=1&generation=1&${population}&evolution.opponents=274&phase=tournament`,
    '#generation-table',
  ],
  ['3 000 starts', `lab&v=1&${starts(3000)}`],
  ['3 000 starts, population 121', `lab&v=1&${starts(3000)}&evolution.population=121`],
  ['200 starts, population 2000, 1000 samples a run', `lab&v=1&${starts(200)}&${population}&${never}`],
  ['the same, one generation', `lab&v=1&${starts(200)}&${population}&${never}`, '#one-generation'],
  ['the same at generation 3', `lab&v=1&generation=3&${starts(200)}&${population}&${never}`],
  ...[...pageNames, 'curves&view=stability'].map(
    (part) =>
      /** @type {[string, string]} */ ([
        `100 000 samples a run: ${part}`,
        `${part.replace('&', '&v=1&')}${part.includes('&') ? '' : '&v=1'}&${never}&${long}`,
      ]),
  ),
  ['the same with a step of the lesson', `lab&v=1&lesson=4&${never}&${long}`],
  ['the same with population 2000', `lab&v=1&${population}&${never}&${long}`],
  ['four pins of 100 000 samples', `curves&v=1&${[1, 2, 3, 4].map(pin).join('&')}`],
  ['generation 100000', 'lab&v=1&generation=100000'],
  ['generation 20000, then its table', 'generation&v=1&generation=20000', '#generation-table'],
  [
    '500 hand-ins',
    'lab&v=1&task=Park.&aim=J<8',
    '#keep-button',
    '#keep-collect',
    ['#collect-text', handIns(500)],
    '#collect-check',
  ],
  ['10 000 starts', `lab&v=1&${starts(10000)}`],
  ['4 600 unknown keys', `lab&v=1&${many}`],
  ['one key of 190 000 characters', `lab&v=1&${'k'.repeat(190_000)}=1`],
];

/** @typedef {import('./chromium.mjs').Driver} Driver */

const openBrowser = () =>
  openChromium(
    'this is measured in',
    ['--window-size=1200,900'],
    { perfLoggingPrefs: { enableNetwork: false, traceCategories: 'toplevel,devtools.timeline' } },
    { 'goog:loggingPrefs': { performance: 'ALL' } },
  );

/** @typedef {{ name: string, ph: string, ts: number, pid: number, tid: number, dur?: number, tdur?: number, args?: { name?: string, data?: { url?: string } } }} TraceEvent */

/** The longest task of a page's thread since it was asked for last, in milliseconds of the processor; null if the browser has told of none. @param {Driver} driver @param {string} address */
async function longestTask(driver, address) {
  const entries = await driver.manage().logs().get('performance');
  /** @type {TraceEvent[]} */
  const events = entries
    .map(({ message }) => JSON.parse(message).message)
    .filter(({ method }) => method === 'Tracing.dataCollected')
    .map(({ params }) => params);
  const keyOf = (/** @type {TraceEvent} */ { pid, tid }) => `${pid} ${tid}`;
  // The browser has pages of its own, and workers have no layout.
  const ours = new Set(
    events.filter(({ args }) => args?.data?.url?.startsWith(address)).map(({ pid }) => pid),
  );
  const drawing = events.filter(({ name, pid }) => name === 'FireAnimationFrame' && ours.has(pid));
  const threads = new Set(drawing.map(keyOf));
  // To leave the page before is work, too, but not of this one.
  const begins = events.filter(
    ({ name, args }) => name === 'CommitLoad' && args?.data?.url?.startsWith(address),
  );
  const begin = Math.min(...begins.map(({ ts }) => ts));
  const tasks = events.filter(
    (event) => /RunTask$/.test(event.name) && threads.has(keyOf(event)) && event.ts >= begin,
  );
  if (tasks.length === 0) return null;
  return tasks.reduce((most, { dur = 0, tdur = dur }) => Math.max(most, tdur / 1000), 0);
}

/** As longestTask(), from a link on. @param {Driver} driver @param {string} address @param {Steps} steps */
async function measured(driver, address, [link, ...presses]) {
  // Between two pages the browser may lose its trace.
  for (let attempt = 0; attempt < 4; attempt += 1) {
    await driver.get('about:blank');
    await driver.get(`${address}#${link}`);
    await pause(watched);
    for (const press of presses) {
      if (typeof press !== 'string') {
        await driver.executeScript('document.querySelector(arguments[0]).value = arguments[1]', ...press);
        continue;
      }
      await driver.executeScript(
        'const [press] = arguments; setTimeout(() => document.querySelector(press).click())',
        press,
      );
      await pause(watched);
    }
    // Once: the browser ends its trace with it.
    const longest = await longestTask(driver, address);
    if (longest !== null) return longest;
  }
  throw new Failure('the browser has told of no task');
}

const inMilliseconds = (/** @type {number} */ time) => `${Math.round(time)} ms`.padStart(8);

/** @param {number} milliseconds */
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

await task(async () => {
  const { values } = parseArgs({
    options: { site: { type: 'string', default: 'dist' }, only: { type: 'string', default: '' } },
  });
  needBuilt(values.site);
  const driver = await openBrowser();
  const served = await serveCompressed(values.site);
  const over = { all: 0, core: 0 };
  try {
    await driver.manage().setTimeouts({ script: 120_000, pageLoad: 120_000 });
    await driver.sendAndGetDevToolsCommand('Page.addScriptToEvaluateOnNewDocument', { source: probe });
    for (const [name, ...steps] of cases.filter(([name]) => name.includes(values.only))) {
      const all = await measured(driver, served.address, steps);
      const core = /** @type {number} */ (await driver.executeScript('return longest'));
      if (core === 0) throw new Failure(`no call of the core was seen: ${name}`);
      if (all > aim) over.all += 1;
      if (core > aim) over.core += 1;
      console.log(`${inMilliseconds(all)} in all, ${inMilliseconds(core)} of the core: ${name}`);
    }
  } finally {
    await driver.quit();
    await served.close();
  }
  console.log(
    `\n${over.all} hold the page for more than ${aim} ms at once, ${over.core} by one call of the core.`,
  );
});
