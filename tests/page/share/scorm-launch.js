// A package for learning platforms without a browser: its own script between a platform and a figure that are not there.
import { readFileSync } from 'node:fs';
import vm from 'node:vm';
import { scorm as words } from '../../../www/share/words/en.js';

const script = readFileSync(new URL('../../../www/share/scorm/files/runtime.js', import.meta.url), 'utf8');
export const link = '#lab&v=1&task=Park';
export const receipt = `${link}&who=s4711&handin=1~8`;
const done = { met: true, points: 8, most: 10 };

/** A clock of its own. */
function createClock() {
  /** @type {{ id: number, at: number, act: () => void }[]} */
  let waiting = [];
  let [now, last, wall] = [0, 0, 1e12];
  return {
    performance: { now: () => now },
    Date: { now: () => wall },
    /** Of the machine, as somebody, or the network, sets it. @param {number} milliseconds */
    putBack(milliseconds) {
      wall -= milliseconds;
    },
    /** @param {() => void} act @param {number} after */
    setTimeout(act, after) {
      last += 1;
      waiting.push({ id: last, at: now + after, act });
      return last;
    },
    /** @param {number} id */
    clearTimeout(id) {
      waiting = waiting.filter((one) => one.id !== id);
    },
    /** @param {number} milliseconds */
    pass(milliseconds) {
      now += milliseconds;
      wall += milliseconds;
      const due = waiting.filter(({ at }) => at <= now);
      waiting = waiting.filter(({ at }) => at > now);
      for (const { act } of due) act();
    },
  };
}

/** A package that is opened by a platform with these values. @param {Record<string, string>} values By their names without cmi. @param {(api: object) => object} [windows] Where the platform stands. @param {string} [exercise] Its link. @param {RegExp} [unknown] Names that the platform does not take. */
export function launch(values, windows = (api) => ({ API: api }), exercise = link, unknown = /^$/) {
  const held = {
    suspend_data: '',
    'core.student_id': 's4711',
    'core.lesson_status': 'not attempted',
    ...values,
  };
  /** @type {Record<string, string>} */
  const cmi = Object.fromEntries(Object.entries(held).map(([name, value]) => [`cmi.${name}`, value]));
  /** What was asked but for values. @type {string[]} */
  const calls = [];
  let committed = '';
  let isOn = false;
  let code = '0';
  const turn = (/** @type {string} */ name, /** @type {boolean} */ on) => () => {
    calls.push(name);
    code = '0';
    if (name === 'LMSCommit') committed = cmi['cmi.suspend_data'];
    const answer = String(isOn !== (name === 'LMSInitialize'));
    isOn = on;
    return answer;
  };
  const api = {
    LMSInitialize: turn('LMSInitialize', true),
    LMSGetValue: (/** @type {string} */ name) => cmi[name] ?? '',
    LMSSetValue(/** @type {string} */ name, /** @type {string} */ value) {
      code = isOn && unknown.test(name) ? '401' : '0';
      if (code !== '0') return 'false';
      if (isOn) cmi[name] = value;
      return String(isOn);
    },
    LMSCommit: turn('LMSCommit', true),
    LMSFinish: turn('LMSFinish', false),
    LMSGetLastError: () => code,
    LMSGetErrorString: () => 'Not implemented',
  };
  const clock = createClock();
  /** @type {string[]} */
  const asked = [];
  const figure = { src: '', contentWindow: { postMessage: ({ id = '' }) => asked.push(id) } };
  const told = { textContent: '', hidden: true };
  /** @type {Record<string, (event: object) => void>} */
  const listeners = {};
  const addEventListener = (/** @type {string} */ type, /** @type {() => void} */ listener) => {
    listeners[type] = listener;
  };
  const document = {
    getElementById: (/** @type {string} */ id) => ({ figure, told })[id],
    documentElement: {},
    visibilityState: 'visible',
    addEventListener,
  };
  const own = /** @type {Record<string, unknown>} */ (windows(api));
  own.parent ??= own;
  own.top ??= own;
  vm.runInNewContext(script, {
    ...clock,
    exercise: { link: exercise.slice(1), texts: { ...words.sentences, title: 'Park', language: 'en' } },
    window: own,
    document,
    addEventListener,
  });
  const say = (/** @type {string} */ type, /** @type {object} */ more = {}) =>
    listeners.message({ source: figure.contentWindow, data: { ep: 1, type, ...more } });
  return {
    pass: clock.pass,
    putBack: clock.putBack,
    say,
    asked,
    told: () => (told.hidden ? '' : told.textContent),
    /** What the figure opens. */
    opened: () => figure.src.replace('ep-locomotion.html?embed', ''),
    /** The figure answers a question, the latest if no other is named. @param {string} now @param {string} [id] */
    answer: (now, id = asked.at(-1)) => say('state', { id, link: now.slice(1) }),
    handIn: (/** @type {string} */ address, /** @type {object} */ result = done) =>
      say('handin', { link: `http://x/${address}`, ...result }),
    calls,
    committed: () => committed,
    hide() {
      document.visibilityState = 'hidden';
      listeners.visibilitychange({});
    },
    leave: () => listeners.pagehide({}),
    comeBack(persisted = true) {
      document.visibilityState = 'visible';
      listeners.pageshow({ persisted });
    },
    suspended: () => cmi['cmi.suspend_data'],
    /** As packages kept it that knew of no other exercise. */
    kept: () => cmi['cmi.suspend_data'].replace(/ [\da-f]{8}$/gm, ''),
    status: () => cmi['cmi.core.lesson_status'],
    score: () => cmi['cmi.core.score.raw'],
    time: () => cmi['cmi.core.session_time'],
  };
}
