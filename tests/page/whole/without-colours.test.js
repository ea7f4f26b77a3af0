// What colours tell is told besides: by dashes, by names where they belong, by words.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dashes } from '../../../www/kit/palette.js';
import { layoutOf } from '../../../www/parts/curves/layout.js';
import { placesApart } from '../../../www/parts/curves/plot-names.js';
import { linesOf } from '../../../www/parts/curves/plots.js';
import { drawnOf, layoutOf as stabilityLayoutOf } from '../../../www/parts/curves/stability/layout.js';
import { roomIn } from '../../../www/parts/curves/stability/part-names.js';
import { styles } from '../../../www/run/pins.js';
import { experiment, paperGains, simulate, stability } from '../harness/core.js';
import { test } from '../harness/once.js';

const usual = experiment('velocity-limits');
const ep = paperGains('velocity-limits', 'ep');

test('the lines of the gains differ by their dashes, whose gaps are narrower than those of pins and comparisons', () => {
  const own = Object.values(dashes);
  assert.equal(new Set(own.map(String)).size, 3);
  const widest = Math.max(...own.flatMap((dash) => dash.filter((_, i) => i % 2)));
  const lines = linesOf({ driving: 0, comparison: 0, pins: [], pinned: [] });
  const others = [...styles, ...lines].map(({ dash }) => dash).filter(({ length }) => length > 0);
  assert.equal(others.length, 5);
  for (const dash of others)
    assert.ok(
      dash.every((gap, i) => i % 2 === 0 || gap > widest),
      `${dash}`,
    );
  // And nobody takes the one of them for the other.
  const [longer, shorter] = [dashes['--y'], dashes['--theta']].map(([length]) => length);
  assert.ok(longer >= 2 * shorter);
});

test('a name of a gain lies whole within its part of V̇, and none stands where there is no room', () => {
  const free = experiment({ limits: { speed: null, turnRate: null } });
  let named = 0;
  for (const [run, isLog] of /** @type {const} */ ([
    [stability(usual, ep), false],
    [stability(usual, ep), true],
    [stability(free, [3, 1, 5]), false],
    [stability(free, [3, -0.5, 5]), false],
    [stability(usual, [3, 8, 5]), true],
  ])) {
    const { rate: axes } = stabilityLayoutOf({ width: 540, height: 420 }, run, [], isLog);
    const { frame, x, y } = axes;
    const inside = (/** @type {number} */ value) => Math.min(Math.max(y(value), frame.top), frame.bottom);
    for (const area of drawnOf(run, isLog).areas) {
      const edgesAt = (/** @type {number} */ i) =>
        [area.from[i], area.to[i]].map(inside).sort((a, b) => a - b);
      const heightAt = (/** @type {number} */ i) => edgesAt(i)[1] - edgesAt(i)[0];
      const place = roomIn(axes, run.time, area);
      if (!place) continue;
      named += 1;
      const near = [...run.time.keys()].filter((i) => Math.abs(x(run.time[i]) - place.x) < 10);
      for (const [top, bottom] of near.map(edgesAt))
        assert.ok(top <= place.y - 8 && bottom >= place.y + 8, `${place.y} is not in ${top} to ${bottom}`);
      assert.ok(Math.max(...near.map(heightAt)) >= 22);
    }
  }
  assert.equal(named, 5);
  const still = stability(usual, [3, 0, 0]);
  const { rate } = stabilityLayoutOf({ width: 540, height: 60 }, still, [], false);
  assert.deepEqual(
    drawnOf(still, false).areas.map((area) => roomIn(rate, still.time, area)),
    [null],
  );
});

test('where x and y end as one, each has its name beside its own line, where the lines are apart', () => {
  const there = { x: 2, y: 2, theta: Math.PI / 4 };
  for (const [start, goal, count] of /** @type {const} */ ([
    [{ x: 0, y: 0, theta: 0 }, there, 2],
    [{ x: 0, y: 2, theta: 0.1 }, there, 2],
    // They are one all the way.
    [{ x: 0, y: 0, theta: Math.PI / 4 }, there, 0],
    // They end apart.
    [{ x: 0, y: 0, theta: 0 }, { ...there, y: 1 }, 0],
  ])) {
    const run = simulate({ ...usual, starts: [start], goal }, [3, 8, 5]);
    for (const height of [330, 700]) {
      const { time, plots } = layoutOf({ width: 560, height }, run, [], usual.limits);
      const { scale: y, frame } = plots[0];
      const places = placesApart({ x: time, y, frame }, run);
      assert.equal(places.length, count, `${JSON.stringify([start, goal])} at ${height}`);
      for (const { symbol, x: px, y: py } of places) {
        const i = run.time.findIndex((at) => time(at) >= px - 8);
        const [own, other] = [run.x, run.y].map((values) => Math.abs(y(values[i]) - py));
        assert.ok(symbol === 0 ? own < other : other < own, `${own} from x, ${other} from y`);
        assert.ok(py >= frame.top && py <= frame.bottom && px >= frame.left && px <= frame.right);
      }
    }
  }
});

test('no sentence of the curves, nor of the steps beside them, names what it means by a colour', () => {
  const colours = {
    en: /\b(?:red|orange|blue|green|purple|grey)\b/i,
    ko: /빨간|빨강|주황|파란|파랑|초록|녹색|보라|회색/,
  };
  for (const [language, colour] of Object.entries(colours))
    for (const name of [
      `parts/curves/words/${language}`,
      `parts/curves/stability/words/${language}`,
      `lesson/words/${language}/stability`,
      `lesson/words/${language}/limits`,
      `lesson/words/${language}/sigma`,
    ]) {
      const text = readFileSync(new URL(`../../../www/${name}.js`, import.meta.url), 'utf8');
      assert.doesNotMatch(text, colour, name);
    }
});
