// What the package for learning platforms keeps, commits and opens again.
import assert from 'node:assert/strict';
import { createReader } from '../../../www/share/collect/entries.js';
import { scorm as words } from '../../../www/share/words/en.js';
import { test } from '../harness/once.js';
import { launch, link, receipt } from './scorm-launch.js';

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

test('the time of a session is what has passed, whatever the clock of the machine is set to meanwhile', () => {
  const { pass, putBack, leave, comeBack, time } = launch({});
  pass(3_725_000);
  putBack(7_200_000);
  leave();
  assert.equal(time(), '0001:02:05');
  comeBack();
  pass(61_000);
  putBack(-7_200_000);
  leave();
  assert.equal(time(), '0000:01:01');
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

test('what is kept is committed when nobody sees the page, and else once a minute', () => {
  const { say, answer, pass, hide, calls, committed, suspended } = launch({});
  const commits = () => calls.filter((name) => name === 'LMSCommit').length;
  const drive = (/** @type {number} */ kx) => {
    say('drive');
    answer(`${link}&gains=${kx},2,2`);
  };
  hide();
  assert.equal(commits(), 0, 'nothing to commit');
  drive(1);
  hide();
  hide();
  assert.deepEqual([commits(), committed()], [1, suspended()]);
  for (let second = 0; second < 150; second += 1) {
    drive(second);
    pass(1000);
  }
  assert.equal(commits(), 3);
  pass(60_000);
  assert.deepEqual([commits(), committed()], [4, suspended()]);
  pass(600_000);
  assert.equal(commits(), 4);
});

test('who comes back to a page that the browser has kept goes on in another session', () => {
  const { say, answer, hide, leave, comeBack, calls, committed, kept, told } = launch({});
  comeBack(false);
  const session = ['LMSInitialize', 'LMSCommit', 'LMSFinish'];
  leave();
  hide();
  leave();
  assert.deepEqual(calls, session);
  say('generation');
  comeBack();
  say('drive');
  answer(`${link}&gains=2,2,2`);
  assert.equal(kept(), `${link}&gains=2,2,2`);
  leave();
  assert.deepEqual([calls, told()], [[...session, ...session], '']);
  assert.match(committed(), /gains=2,2,2/);
});

test('the student is told that the platform has the result', () => {
  const { handIn, told } = launch({});
  assert.equal(told(), '');
  handIn('#lab&v=1&handin=1');
  assert.equal(told(), words.sentences.kept);
});

test('a platform need not take the bounds of the score, but the score', () => {
  const bounds = launch({}, undefined, link, /score\.(?:min|max)$/);
  bounds.handIn(receipt);
  assert.deepEqual([bounds.score(), bounds.status(), bounds.told()], ['80', 'passed', words.sentences.kept]);
  const score = launch({}, undefined, link, /score\.raw$/);
  score.handIn(receipt);
  const refused = words.sentences.refused.replace('…', '401 Not implemented');
  assert.equal(score.told(), refused);
  const all = launch({}, undefined, link, /./);
  assert.equal(all.told(), refused);
  all.handIn(receipt);
  assert.equal(all.told(), refused);
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
  // Work for which there is no room beside a receipt leaves that as it was, and the student knows until the next hand-in.
  const short = launch({});
  short.handIn(receipt);
  for (const kx of [1, 2]) {
    short.say('drive');
    short.answer(`${link}&gains=${kx},2,2&task=${'x'.repeat(4050)}`);
    assert.deepEqual([short.kept(), short.told()], [receipt, words.sentences.noRoom]);
    short.handIn(receipt);
    assert.equal(short.told(), words.sentences.kept);
  }
  // What went wrong stays in sight.
  handIn(receipt);
  assert.equal(told(), words.sentences.tooLong);
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
  const alone = launch({}, () => ({}));
  assert.deepEqual([alone.told(), alone.opened()], [words.sentences.nobody, link]);
});
