// What a formula reads with the numbers of now.
import assert from 'node:assert/strict';
import { lawFormula, rateFormula, robustFormula } from '../../../www/lesson/formulas/formulas.js';
import { stability } from '../../../www/lesson/words/en/stability.js';
import { engineTest, Key, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { follow } from '../whole/surround.js';
import { liveOf } from './live.js';

test('another rule has no numbers in the formulas of law (5), and no disturbance has the bound 0', () => {
  for (const [law, isNumber] of /** @type {const} */ ([
    ['shim-kim', true],
    ['kanayama', false],
  ])) {
    const live = liveOf(`lab&law=${law}`);
    const [{ v, w }, { Vdot }] = [lawFormula, rateFormula].map((one) => one.numbers?.(live) ?? {});
    for (const text of [v, w, Vdot]) assert.equal(text !== undefined, isNumber, `${law}: ${text}`);
  }
  const bounds = ['slip', 'none'].map((kind) => {
    const live = liveOf(`lab&disturbance.kind=${kind}&disturbance.linear=0.1&disturbance.angular=0.2`);
    const { e1, e2 } = robustFormula.numbers?.(live) ?? {};
    return [e1, e2];
  });
  assert.deepEqual(bounds, [
    ['0.100', '0.200'],
    ['0.000', '0.000'],
  ]);
});

const steps = ['error', 'law', 'stability', 'cost', 'generation', 'sigma', 'disturbance'];

pageTest('with numbers every product has its sign, and what is below zero its brackets', async (page) => {
  let below = 0;
  await page.open('#lesson');
  for (const step of steps) {
    await follow(page, `lesson&step=${step}`);
    const { lines, unsigned } = await page.evaluate(async () => {
      for (const button of document.querySelectorAll('.formula-button'))
        button.dispatchEvent(new Event('click'));
      await pageFrames.settled();
      const isSign = (/** @type {Element} */ one) => one.localName === 'mo' && one.textContent !== '(';
      const unsigned = [...document.querySelectorAll('.formula-now mrow > * + *')].filter((one) =>
        [one, one.previousElementSibling].every((of) => of && !isSign(of) && of.textContent !== '('),
      );
      const opening = [...document.querySelectorAll('.formula-now mo')].filter(
        ({ textContent, previousElementSibling: before }) => textContent === '(' && before && !isSign(before),
      );
      return {
        lines: [...document.querySelectorAll('.formula-now mtr')].map((line) => line.textContent ?? ''),
        unsigned: [...unsigned, ...opening].map(({ parentElement }) => parentElement?.textContent),
      };
    });
    assert.ok(lines.length > 0, step);
    assert.deepEqual(unsigned, [], step);
    for (const line of lines) {
      assert.doesNotMatch(line, /[·+−\u2061]−|\u2062/, line);
      below += line.split('(−').length - 1;
    }
  }
  assert.ok(below > 0, 'some number is below zero');
});

pageTest(
  'what cancels in the rate of V is something, though the drive is over, and is told where the clock stands',
  async (page) => {
    await page.open('#lesson&step=stability');
    const amounts = async () => {
      await page.click('#cancel-press');
      const texts = await page.evaluate(() =>
        [...document.querySelectorAll('#cancel li span')].map(({ textContent }) => textContent ?? ''),
      );
      return texts.map((text) => Number(text.replace('−', '-')));
    };
    const clock = () => page.text('#clock');
    const end = await clock();
    const [, steep, cross, , , steepAgain, crossAgain] = await amounts();
    assert.notEqual(await clock(), end);
    assert.ok(Math.abs(steep) >= 0.1 && Math.abs(cross) >= 0.1, `${steep}, ${cross}`);
    assert.deepEqual([steepAgain, crossAgain], [-steep, -cross]);
    // Whoever has moved the clock keeps it.
    for (let press = 0; press < 3; press += 1) await page.click('#cancel-press');
    const moved = await clock();
    await amounts();
    assert.equal(await clock(), moved);
  },
);

pageTest(
  'where numbers stand under the terms they are told of, and under another law why none do',
  async (page) => {
    await page.open('#lesson&step=stability');
    await page.click('#cancel-press');
    const { amounts, otherLaw } = stability.cancel;
    for (const [law, isNumber, told, untold] of /** @type {const} */ ([
      ['shim-kim', true, amounts, otherLaw],
      ['kanayama', false, otherLaw, amounts],
    ])) {
      await page.evaluate((to) => {
        location.hash = location.hash.replace(/&law=[^&]*|$/, `&law=${to}`);
      }, law);
      await page.until(
        `the numbers of ${law}`,
        (wanted) => {
          const spans = [...document.querySelectorAll('#cancel li span')];
          return spans.length === 7 && spans.every(({ textContent }) => (textContent !== '') === wanted);
        },
        isNumber,
      );
      const said = String(await page.text('.cancel-said'));
      assert.ok(said.includes(told) && !said.includes(untold), said);
    }
  },
);

engineTest(
  'the dot of a rate stands over its letter, not at its shoulder as a prime, and V is the same with it',
  async (page) => {
    await page.open('#lesson&step=stability');
    const { dots, widths } = await page.evaluate(() => {
      const box = (/** @type {Element | null} */ element) => {
        if (!element) throw new Error('it is not there');
        return element.getBoundingClientRect();
      };
      const shown = '.formula-lines:not(.formula-now) [data-term';
      return {
        dots: [...document.querySelectorAll('.formula-lines mover')].map((over) => {
          const [letter, dot] = [box(over.querySelector('mi')), box(over.querySelector('mo'))];
          const off = (dot.left + dot.right - letter.left - letter.right) / 2 / letter.width;
          const term = over.closest('[data-term]') ?? over.querySelector('[data-term]');
          const high = box(over).height / Number.parseFloat(getComputedStyle(over).fontSize);
          return { of: term?.getAttribute('data-term'), off: Math.abs(off), high };
        }),
        widths: ['V', 'Vdot'].map(
          (name) => box(document.querySelector(`${shown}="${name}"] mi, ${shown}="${name}"]:is(mi)`)).width,
        ),
      };
    });
    assert.deepEqual([...new Set(dots.map(({ of }) => of))].sort(), [
      'Vdot',
      'te',
      'theta',
      'x',
      'xe',
      'y',
      'ye',
    ]);
    // The boxes of Firefox reach beyond what is drawn in them.
    const most = page.engine === 'firefox' ? 1.7 : 1.2;
    for (const { of, off, high } of dots) {
      assert.ok(off < 0.3, `${of}: ${off} of its width beside it`);
      assert.ok(high < most, `${of}: with its dot ${high} of the letters’ size`);
    }
    assert.ok(Math.abs(widths[0] - widths[1]) < 0.5, `V is ${widths} wide`);
  },
);

pageTest(
  'a formula that has no numbers offers none, and has them again when there are some',
  async (page) => {
    const shown = (/** @type {boolean} */ isShown) =>
      page.until(
        isShown ? 'the numbers' : 'no numbers',
        (wanted) =>
          ['.formula-button', '.formula-now'].every(
            (name) => document.querySelector(name)?.checkVisibility() === wanted,
          ),
        isShown,
      );
    await page.open('#lesson&step=7');
    await page.click('.formula-button');
    await shown(true);
    await page.click('#one-back');
    await shown(false);
    await page.click('#one-generation');
    await shown(true);
  },
);

engineTest(
  'a formula is one stop of the keyboard, in which arrows light up term after term',
  async (page) => {
    await page.open('#lesson&step=law');
    const focused = () =>
      page.evaluate(() => ({
        term: document.activeElement?.getAttribute('data-term') ?? null,
        lit: document.activeElement?.classList.contains('lit'),
        slider: document.querySelector('.gain.lit')?.classList[1] ?? null,
      }));
    await page.focus('.formula-lines:not(.formula-now)');
    assert.deepEqual(await focused(), { term: null, lit: false, slider: null });
    const terms = [];
    for (let press = 0; press < 4; press += 1) {
      await page.press(Key.RIGHT);
      terms.push(await focused());
    }
    assert.deepEqual(
      terms.map(({ term }) => term),
      ['v', 'kx', 'ky', 'w'],
    );
    await page.press(Key.LEFT);
    assert.deepEqual(await focused(), terms[2]);
    assert.ok(terms.every(({ lit }) => lit));
    await page.press(Key.TAB);
    assert.equal(
      await page.evaluate(() => document.activeElement?.closest('.formula-lines') === null),
      true,
      'Tab leaves the formula',
    );
    // What is pressed is lit, also once the press has moved the focus.
    await page.click('.formula-lines:not(.formula-now) mrow[data-term="kt"]');
    assert.equal((await focused()).slider, 'ktheta');
  },
);

pageTest(
  'each symbol of the error posture that is pointed at lights up in formula and picture',
  async (page) => {
    await page.open('#lesson&step=error');
    for (const name of ['xe', 'te', 'xr', 'yr', 'tr', 'xc', 'yc', 'tc', 'ye']) {
      const seen = await page.evaluate((term) => {
        const symbol = document.querySelector(`.formula [data-term="${term}"]`);
        symbol?.dispatchEvent(new PointerEvent('pointerover', { bubbles: true }));
        const lit = [...document.querySelectorAll('#error-posture .lit[data-term]')];
        return lit
          .filter((one) => one.querySelector('path')?.checkVisibility({ visibilityProperty: true }))
          .map((one) => one.getAttribute('data-term'));
      }, name);
      assert.deepEqual(seen, [name]);
    }
    /** How many are lit in the formula and in the picture. @param {string} [pointerType] What leaves the page before. */
    const lit = (pointerType = '') =>
      page.evaluate((type) => {
        if (type) document.dispatchEvent(new PointerEvent('pointerleave', { pointerType: type }));
        return ['#lesson .formula', '#error-posture'].map(
          (one) => document.querySelectorAll(`${one} .lit`).length,
        );
      }, pointerType);
    const now = await lit();
    assert.ok(now[0] >= 1 && now[1] >= 2, `${now}`);
    assert.deepEqual(await lit('touch'), now, 'a finger that was lifted leaves it lit');
    assert.deepEqual(await lit('mouse'), [0, 0]);
  },
);
