import assert from 'node:assert/strict';
import { risesFromEverywhere } from '../../../www/lesson/steps/limits.js';
import { stability as words } from '../../../www/lesson/words/en/stability.js';
import { stability as ko } from '../../../www/lesson/words/ko/stability.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { paperGains, simulate } from '../harness/core.js';
import { driven, engine, linkOf, opened, samples } from './links.js';
import { answered, liveOf, toldBy } from './live.js';
import { test } from '../harness/once.js';

const limits = stepOf('limits');
const stability = stepOf('stability');

/** Every sample of the robot by hand or of the paper's EP gains. @param {string} link */
function samplesOf(link) {
  const { experiment, handGains, preset } = opened(link);
  return samples(experiment, handGains ?? paperGains(preset, 'ep'));
}
/** @param {string} link */
const risesOf = (link) =>
  samplesOf(link).filter(({ lyapunov }, i, all) => i > 0 && lyapunov > all[i - 1].lyapunov).length;

test('without limits V falls from sample to sample, and its rate is what the law promises', () => {
  assert.equal(risesOf(stability.link), 0);
  assert.ok(driven(stability.link).arrived);
  const [kx, ky, kt] = opened(stability.link).handGains ?? [0, 0, 0];
  for (const { error, lyapunovRate, outcome } of samplesOf(stability.link)) {
    if (outcome !== null) continue;
    const { x, y, theta } = error;
    const promised = -kx * (x * Math.cos(theta)) ** 2 - ky * y ** 4 - kt * Math.sin(theta) ** 2;
    assert.ok(Math.abs(promised - lyapunovRate) < 1e-6 * (1 + Math.abs(promised)));
  }
});

test('where sin θe is 0 and ye is not, V may rise at once', () => {
  for (const { notice } of [words, ko]) {
    const link = /\]\((curves[^)]*start=2,1,45deg[^)]*)\)/.exec(notice.join())?.[1] ?? '';
    const [first, second] = samplesOf(link);
    assert.ok(Math.abs(Math.sin(first.error.theta)) < 1e-6 && Math.abs(first.error.y) > 0.1);
    assert.ok(second.lyapunov > 1.5 * first.lyapunov);
  }
});

test('the drive of the step leaps over sin θe = 0 beside the goal’s line, and turns ever faster until then', () => {
  const all = samplesOf(stability.link);
  const next = all.findIndex(({ error }) => error.theta < 0);
  const { error, time } = all[next - 1];
  assert.ok(error.theta > 0.01 && all[next].error.theta < -0.01 && error.y > 0.3 && time < 0.3);
  const rates = all.slice(0, next).map(({ command }) => command.angular);
  const least = rates.indexOf(Math.min(...rates));
  for (let i = least + 1; i < next; i++) assert.ok(rates[i] > rates[i - 1], `${i}`);
  assert.ok(rates[next - 1] > 2 * rates[least]);
});

test('backwards on the goal’s line the robot comes to the saddle, and stands there', () => {
  const { experiment, handGains } = opened(stability.link);
  const goal = { ...experiment.goal, theta: 0 };
  for (const ahead of [-1.5, 2]) {
    const starts = [{ ...goal, x: goal.x + ahead, theta: Math.PI }];
    const all = samples({ ...experiment, goal, starts }, handGains ?? [0, 0, 0]);
    const last = all.find(({ time }) => time >= 4) ?? all[0];
    assert.ok(Math.abs(last.error.x) < 1e-3 && Math.abs(last.lyapunov - 2) < 1e-3, JSON.stringify(last));
  }
});

test('with ky below zero V falls and rises again, as its rate says, wherever rounding puts it', async () => {
  const link = linkOf(stability, 'negative');
  const all = samplesOf(link);
  const { sampleTime } = opened(link).experiment;
  const lowest = Math.min(...all.map(({ lyapunov }) => lyapunov));
  assert.ok(lowest < all[0].lyapunov / 5, `${all[0].lyapunov}, ${lowest}`);
  assert.equal((await answered('stability', 'negative')).outcome.right, 2);
  const { experiment, handGains } = opened(link);
  for (let i = 1; i <= 20; i++) {
    const [{ x, y, theta }] = experiment.starts;
    const starts = [{ x: x + i * 1e-12, y, theta }];
    const values = samples({ ...experiment, starts }, handGains ?? [0, 0, 0]).map((one) => one.lyapunov);
    assert.ok(values[values.length - 1] > 2 * Math.min(...values), `${i}`);
  }
  // The command that is held does what the law promises at the instant: else the picture contradicts the words.
  const agree = all.slice(1).filter(({ lyapunov }, i) => {
    const [rate, change] = [all[i].lyapunovRate, (lyapunov - all[i].lyapunov) / sampleTime];
    return Math.abs(rate - change) < 0.1 * Math.max(Math.abs(rate), 0.05);
  });
  assert.ok(agree.length > 0.95 * all.length, `${agree.length} of ${all.length}`);
});

test('Kanayama’s rule stops beside a goal at rest and never turns, but follows a moving one, as the law does', () => {
  const parked = driven(linkOf(stability, 'kanayama'));
  const end = parked.x.length - 1;
  assert.ok(Math.hypot(parked.x[end] - 2, parked.y[end] - 2) > 1);
  assert.ok(parked.angular.every((value) => value === 0));
  for (const name of ['track', 'kanayamaTracks']) {
    const last = samplesOf(linkOf(stability, name)).at(-1);
    assert.ok((last?.lyapunov ?? 1) < 0.01, `${name}: V ${last?.lyapunov}`);
  }
});

test('where a try of the theory has the limits on, its words say so', () => {
  for (const block of stability.blocks)
    if (block.kind === 'tries')
      for (const [name, link] of block.tries) {
        const isLimited = opened(link).experiment.limits.speed !== null;
        for (const { tries } of [words, ko])
          assert.equal(/limits|제한/.test(/** @type {any} */ (tries)[name]), isLimited, name);
      }
});

test('from another start V rises at times; with kθ below zero the robot does not arrive', () => {
  assert.ok(risesOf(linkOf(stability, 'other')) > 0);
  assert.equal(driven(linkOf(stability, 'negativeTurn')).arrived, false);
});

test('early the blue part is the largest, near the goal the orange one the smallest', () => {
  const [kx, ky, kt] = opened(stability.link).handGains ?? [0, 0, 0];
  const parts = samplesOf(stability.link).map(({ error: { x, y, theta } }) => [
    kx * (x * Math.cos(theta)) ** 2,
    ky * y ** 4,
    kt * Math.sin(theta) ** 2,
  ]);
  assert.equal(Math.max(...parts[0]), parts[0][0]);
  assert.equal(Math.min(...parts[parts.length - 1]), parts[parts.length - 1][1]);
});

test('on the goal, turned by 180°, V stays at 2 for seconds, then the robot tips over', () => {
  const link = /180°\]\(([^)]+)\)/.exec(words.notice.join(' '))?.[1] ?? '';
  assert.ok(ko.notice.join(' ').includes(link));
  const all = samplesOf(link);
  for (const { lyapunov, time } of all) if (time < 5) assert.ok(Math.abs(lyapunov - 2) < 1e-4, `${time} s`);
  assert.equal(all[all.length - 1].outcome, 'arrived');
});

test('without limits J rises, because energy counts the square of a huge turn rate', () => {
  const free = driven(linkOf(limits, 'free'));
  const limited = driven(limits.link);
  assert.ok(free.cost.total > 100 * limited.cost.total);
  assert.ok(free.cost.energy > 0.9 * free.cost.total);
  assert.ok(risesOf(linkOf(limits, 'free')) > 0);
  assert.equal(risesOf(limits.link), 0);
});

test('limits of speed do not mend it: from most starts V rises at least once', async () => {
  const { raised, starts } = risesFromEverywhere(engine, paperGains('velocity-limits', 'ep'));
  assert.equal(starts, 100);
  assert.ok(raised > 60, `${raised}`);
  const { outcome, why } = await answered('limits', 'heals');
  assert.deepEqual([outcome.right, outcome.drives], [2, raised]);
  for (const text of why) assert.match(text, new RegExp(`\\b${raised}\\D`));
  // What is shown is one of that kind, and the shuffle comes near all the same.
  assert.ok(risesOf(linkOf(limits, 'heals')) > 20);
  assert.ok(risesOf(linkOf(limits, 'raised')) > 20);
  const all = samplesOf(linkOf(limits, 'raised'));
  assert.ok(all[all.length - 1].lyapunov < 0.1 * all[0].lyapunov);
  // Where the wheels can do what is asked, and samples are short, V falls.
  assert.equal(risesOf(stability.link), 0);
});

test('limits let V rise in two ways: they clip v and ω apart, and a command is held until the next sample', () => {
  const gains = paperGains('velocity-limits', 'ep');
  const { experiment } = opened(linkOf(limits, 'heals'));
  const { x, y } = experiment.goal;
  const rises = { clipped: 0, held: 0 };
  for (const start of engine.startsOnCircle({ x, y, radius: 3, count: 25, seed: 10 })) {
    const all = samples({ ...experiment, starts: [start] }, gains);
    for (const [i, { error, command, velocity, lyapunov, lyapunovRate }] of all.slice(0, -1).entries()) {
      const rateOf = (/** @type {typeof command} */ { linear, angular }) =>
        (error.y * Math.sin(error.theta) - error.x * Math.cos(error.theta)) * linear -
        Math.sin(error.theta) * angular;
      assert.ok(Math.abs(rateOf(velocity) - lyapunovRate) <= 1e-9 * Math.max(1, Math.abs(lyapunovRate)));
      // Slowed by one factor, v and ω would let V fall as the law does.
      const share = velocity.angular / command.angular;
      const slowed = { linear: share * command.linear, angular: share * command.angular };
      if (Math.abs(Math.sin(error.theta)) > 1e-5 && share > 0)
        assert.ok(rateOf(slowed) <= 1e-9 * Math.max(1, Math.abs(command.linear)), `${rateOf(slowed)}`);
      if (all[i + 1].lyapunov > lyapunov) rises[lyapunovRate > 0 ? 'clipped' : 'held'] += 1;
    }
  }
  assert.ok(rises.clipped > 100 && rises.held > 100, JSON.stringify(rises));
});

test('on the goal, turned by 180°, it is a saddle: V rises sideways and falls by turning', () => {
  const { experiment } = opened(stability.link);
  const { goal } = experiment;
  const V = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ theta) => {
    const starts = [{ x: goal.x + x, y: goal.y + y, theta: goal.theta + theta }];
    return samples({ ...experiment, starts }, [3, 1, 5])[0].lyapunov;
  };
  for (const d of [1e-3, -1e-3]) {
    assert.ok(V(d, 0, Math.PI) > 2 && V(0, d, Math.PI) > 2);
    assert.ok(V(0, 0, Math.PI + d) < 2);
  }
});

test('the turn rate of the paper is told as 2π, as the later steps do', async () => {
  const { w } = await toldBy(limits, liveOf(limits.link));
  const { turnRate } = opened(limits.link).experiment.limits;
  assert.equal(turnRate, 2 * Math.PI);
  assert.equal(w, `2π (${turnRate.toFixed(3)})`);
});

test('the robot of the paper drives at full speed for most of its way', () => {
  const { linear } = driven(limits.link);
  assert.ok(linear.filter((v) => v === 2).length > linear.length / 2);
});

test('with acceleration limits bold gains arrive much later and let V rise', () => {
  const slow = driven(linkOf(limits, 'brakes'));
  const quick = simulate(opened('lab').experiment, [10, 10, 10]);
  assert.ok(slow.finalTime > 1.3 * quick.finalTime);
  assert.ok(risesOf(linkOf(limits, 'brakes')) > 0);
});

test('in Figure 7 the arbitrary robot never arrives, and speed climbs along a straight line', () => {
  const arbitrary = driven('curves&preset=acceleration-limits&drives=paper-arbitrary');
  assert.equal(arbitrary.arrived, false);
  const { linear } = driven(linkOf(limits, 'figure7'));
  for (let i = 0; i < 20; i++) assert.ok(Math.abs(linear[i] - 0.05 * (i + 1)) < 1e-9);
});
