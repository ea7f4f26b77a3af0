// What the package for learning platforms keeps, without a browser: its own script between a platform and a figure that are not there.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import vm from 'node:vm';
import { createReader } from '../../../www/share/collect/entries.js';
import { scorm as words } from '../../../www/share/words/en.js';
import { test } from '../harness/once.js';

const script = readFileSync(new URL('../../../www/share/scorm/files/runtime.js', import.meta.url), 'utf8');
const link = '#lab&v=1&task=Park';
const receipt = `${link}&who=s4711&handin=1~8`;
const done = { met: true, points: 8, most: 10 };

/** A clock of its own. */
function createClock() {
  /** @type {{ id: number, at: number, act: () => void }[]} */
  let waiting = [];
  let [now, last] = [0, 0];
  return {
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
      const due = waiting.filter(({ at }) => at <= now);
      waiting = waiting.filter(({ at }) => at > now);
      for (const { act } of due) act();
    },
  };
}

/** A package that is opened by a platform with these values. @param {Record<string, string>} values By their names without cmi. @param {(api: object) => object} [windows] Where the platform stands. @param {string} [exercise] Its link. */
function launch(values, windows = (api) => ({ API: api }), exercise = link) {
  const held = {
    suspend_data: '',
    'core.student_id': 's4711',
    'core.lesson_status': 'not attempted',
    ...values,
  };
  /** @type {Record<string, string>} */
  const cmi = Object.fromEntries(Object.entries(held).map(([name, value]) => [`cmi.${name}`, value]));
  const api = {
    LMSInitialize: () => 'true',
    LMSGetValue: (/** @type {string} */ name) => cmi[name] ?? '',
    LMSSetValue(/** @type {string} */ name, /** @type {string} */ value) {
      cmi[name] = value;
      return 'true';
    },
    LMSCommit: () => 'true',
    LMSFinish: () => 'true',
    LMSGetLastError: () => '0',
    LMSGetErrorString: () => '',
  };
  const clock = createClock();
  /** @type {string[]} */
  const asked = [];
  const figure = { src: '', contentWindow: { postMessage: ({ id = '' }) => asked.push(id) } };
  const told = { textContent: '', hidden: true };
  /** @type {Record<string, (event: object) => void>} */
  const listeners = {};
  const own = /** @type {Record<string, unknown>} */ (windows(api));
  own.parent ??= own;
  own.top ??= own;
  vm.runInNewContext(script, {
    ...clock,
    exercise: { link: exercise.slice(1), texts: { ...words.sentences, title: 'Park', language: 'en' } },
    window: own,
    document: { getElementById: (/** @type {string} */ id) => ({ figure, told })[id], documentElement: {} },
    addEventListener: (/** @type {string} */ type, /** @type {() => void} */ listener) => {
      listeners[type] = listener;
    },
  });
  const say = (/** @type {string} */ type, /** @type {object} */ more = {}) =>
    listeners.message({ source: figure.contentWindow, data: { ep: 1, type, ...more } });
  return {
    pass: clock.pass,
    say,
    asked,
    told: () => (told.hidden ? '' : told.textContent),
    /** What the figure opens. */
    opened: () => figure.src.replace('ep-locomotion.html?embed', ''),
    /** The figure answers a question, the latest if no other is named. @param {string} now @param {string} [id] */
    answer: (now, id = asked.at(-1)) => say('state', { id, link: now.slice(1) }),
    handIn: (/** @type {string} */ address, /** @type {object} */ result = done) =>
      say('handin', { link: `http://x/${address}`, ...result }),
    suspended: () => cmi['cmi.suspend_data'],
    /** As packages kept it that knew of no other exercise. */
    kept: () => cmi['cmi.suspend_data'].replace(/ [\da-f]{8}$/gm, ''),
    status: () => cmi['cmi.core.lesson_status'],
    score: () => cmi['cmi.core.score.raw'],
  };
}

test('while generations rush by, how far they have come is kept every second, however late the figure answers', () => {
  const { say, pass, asked, answer, kept } = launch({});
  for (let generation = 1; generation <= 50; generation += 1) {
    say('generation');
    const before = asked.length;
    pass(100);
    if (asked.length > before) answer(`${link}&generation=${generation}`, asked.at(-2));
  }
  const [, generation] = /generation=(\d+)$/.exec(kept()) ?? [];
  assert.ok(Number(generation) > 35, kept());
  // One alone is asked about at once.
  pass(2000);
  const before = asked.length;
  say('generation');
  assert.equal(asked.length, before + 1);
});

test('what the figure was asked before a hand-in is no work after it', () => {
  const { say, asked, answer, handIn, kept, pass } = launch({});
  say('drive');
  const early = asked.at(-1);
  say('generation');
  handIn(receipt);
  pass(5000);
  assert.equal(asked.length, 2);
  answer(`${link}&gains=1,1,1`, early);
  assert.equal(kept(), receipt);
  say('drive');
  answer(`${link}&gains=2,2,2`);
  assert.equal(kept(), `${receipt}\n${link}&gains=2,2,2`);
});

for (const how of /** @type {const} */ (['suspended', 'kept']))
  test(`an attempt that is resumed again and again keeps one receipt, its result, and what was done after it: ${how}`, () => {
    const first = launch({});
    assert.deepEqual([first.opened(), first.status()], [`${link}&who=s4711`, 'incomplete']);
    first.handIn(receipt);
    assert.deepEqual([first.status(), first.score()], ['passed', '80']);
    let data = first[how]();
    for (const attempt of [1, 2]) {
      const again = launch({ suspend_data: data, 'core.lesson_status': 'passed' });
      assert.equal(again.opened(), receipt, `attempt ${attempt}`);
      again.say('generation');
      again.pass(1000);
      again.answer(receipt);
      assert.deepEqual([again.kept(), again.status()], [receipt, 'passed'], `attempt ${attempt}`);
      data = again[how]();
    }
    const on = launch({ suspend_data: data, 'core.lesson_status': 'passed' });
    on.say('drive');
    on.answer(`${link}&gains=2,2,2`);
    const later = launch({ suspend_data: on[how](), 'core.lesson_status': 'passed' });
    assert.deepEqual([later.opened(), later.told()], [`${link}&gains=2,2,2`, '']);
    later.handIn(`${receipt}2`, { met: false, points: 3, most: 10 });
    assert.deepEqual([later.kept(), later.status(), later.score()], [`${receipt}2`, 'failed', '30']);
    // A new attempt begins anew.
    assert.equal(launch({}).opened(), `${link}&who=s4711`);
  });

test('who has begun before the exercise was corrected begins in the corrected one, and the receipt stays', async () => {
  const corrected = `${link}%20there`;
  const resume = (/** @type {string} */ data) =>
    launch({ suspend_data: data, 'core.lesson_status': 'passed' }, undefined, corrected);
  const before = launch({});
  before.say('drive');
  before.answer(`${link}&gains=1,1,1`);
  assert.equal(resume(before.suspended()).opened(), `${corrected}&who=s4711`);
  before.handIn(receipt);
  const first = resume(before.suspended());
  assert.deepEqual([first.opened(), first.told()], [`${corrected}&who=s4711`, words.sentences.changed]);
  assert.deepEqual([first.status(), first.suspended()], ['passed', before.suspended()]);
  // Nothing done, nothing other.
  assert.equal(resume(first.suspended()).opened(), `${corrected}&who=s4711`);
  first.say('drive');
  first.answer(`${corrected}&gains=2,2,2`);
  assert.equal(first.kept(), `${receipt}\n${corrected}&gains=2,2,2`);
  // What platforms make of the end of a line.
  for (const end of ['\n', ' ', '\r\n']) {
    const second = resume(first.suspended().replace('\n', end));
    assert.deepEqual([second.opened(), second.told()], [`${corrected}&gains=2,2,2`, '']);
  }
  first.handIn(`${receipt}2`);
  assert.deepEqual([first.kept(), first.told()], [`${receipt}2`, words.sentences.kept]);
  assert.equal(resume(first.suspended()).opened(), `${receipt}2`);
});

test('whoever checks finds the receipt in what is kept', async () => {
  const whole = '#lab&v=1&drives=hand&gains=3,0,4&task=Park&handin=1~8~1/1~2~0~0.1.0~00000000~~0123abcd';
  const { handIn, say, answer, suspended } = launch({});
  handIn(whole);
  const entries = await createReader(['lab']).read(suspended());
  assert.deepEqual(
    entries.map((entry) => entry.link),
    [whole.slice(1)],
  );
  say('drive');
  answer(`${link}&gains=2,2,2`);
  const [first] = await createReader(['lab']).read(suspended());
  assert.equal(first.link, whole.slice(1));
});

test('the student is told that the platform has the result', () => {
  const { handIn, told } = launch({});
  assert.equal(told(), '');
  handIn('#lab&v=1&handin=1');
  assert.equal(told(), words.sentences.kept);
});

test('where a receipt has no room the student is told, the result stays, and the work goes on being kept', () => {
  const long = `${receipt}${'x'.repeat(4096)}`;
  const { handIn, say, answer, kept, status, told } = launch({});
  handIn(long);
  assert.deepEqual([status(), told()], ['passed', words.sentences.tooLong]);
  say('drive');
  answer(`${link}&gains=2,2,2`);
  assert.equal(kept(), `${link}&gains=2,2,2`);
  const resumed = launch({ suspend_data: kept(), 'core.lesson_status': 'passed' });
  assert.deepEqual([resumed.opened(), resumed.status()], [kept(), 'passed']);
  // Work for which there is no room beside a receipt leaves that as it was.
  const short = launch({});
  short.handIn(receipt);
  short.say('drive');
  short.answer(`${link}&task=${'x'.repeat(4050)}`);
  assert.equal(short.kept(), receipt);
});

test('whoever the platform says it is works on it, and nobody where it says nothing', () => {
  for (const [id, who] of [
    ['', ''],
    ['a&b=c#d?e', '&who=a%26b%3Dc%23d%3Fe'],
    ['김 철수', `&who=${encodeURIComponent('김 철수')}`],
    ['x'.repeat(120), `&who=${'x'.repeat(80)}`],
    [`${'x'.repeat(79)}🤖🤖`, `&who=${'x'.repeat(79)}${encodeURIComponent('🤖')}`],
  ])
    assert.equal(launch({ 'core.student_id': id }).opened(), `${link}${who}`);
});

test('the platform is found around the package, and in the window that opened it or the outermost', () => {
  for (const windows of /** @type {((api: object) => object)[]} */ ([
    (API) => ({ API }),
    (API) => ({ parent: { API } }),
    (API) => ({ opener: { API } }),
    (API) => ({ parent: {}, top: { opener: { API } } }),
  ]))
    assert.equal(launch({}, windows).told(), '', String(windows));
  assert.equal(launch({}, () => ({})).told(), words.sentences.nobody);
});
