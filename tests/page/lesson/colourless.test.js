// The lesson for who sees no colours: what is told by one is told by something else, too.
import assert from 'node:assert/strict';
import { reach } from '../../../www/lesson/views/push-terms.js';
import * as en from '../../../www/lesson/words/en/all.js';
import * as ko from '../../../www/lesson/words/ko/all.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { follow } from '../whole/surround.js';

test('where words name a colour, they name what one sees without it', () => {
  const told = [en, ko].map(({ generation, law, landscape, disturbance }) => [
    generation.newborn.title(8, 20),
    law.texts.one,
    landscape.texts.shape,
    disturbance.texts.sets,
  ]);
  const signs = [
    [/bold/, /dashed/, /bright yellow/, /dashed edge/],
    [/굵은/, /파선/, /밝은 노란색/, /가장자리는 파선/],
  ];
  for (const [language, texts] of told.entries())
    for (const [i, text] of texts.entries()) assert.match(text, signs[language][i]);
});

pageTest('the better offspring are as many as the letters of their J say', async (page) => {
  await page.open('#lesson&step=generation');
  for (const [phase, isBorn] of /** @type {const} */ ([
    ['drive', true],
    ['parents', false],
  ])) {
    await follow(page, `lesson&step=generation&phase=${phase}`);
    const { bold, title } = await page.until(
      `drives of ${phase}`,
      (born) => {
        const [name, ...cells] = document.querySelectorAll('.newborn-title, .newborn li strong');
        return (
          name?.textContent?.includes('bold') === born && {
            title: name.textContent,
            bold: cells.filter((cell) => Number(getComputedStyle(cell).fontWeight) > 500).length,
          }
        );
      },
      isBorn,
    );
    assert.equal(bold, isBorn ? Number(/(\d+)\.$/.exec(title ?? '')?.[1]) : 0);
  }
});

pageTest('what the wheels cannot do begins at dashes, and without limits there are none', async (page) => {
  await page.open('#lesson&step=law');
  const dashes = () =>
    page.until('the bars', () => {
      const track = document.querySelector('.push-track');
      const free = track?.querySelector('.push-free');
      if (!track || !free) return null;
      const { left: from, width } = track.getBoundingClientRect();
      const { left, right } = free.getBoundingClientRect();
      const dash = free.clientLeft;
      return dash > 0 ? [left + dash, right - dash].map((x) => Math.round((1000 * (x - from)) / width)) : [];
    });
  const part = 500 * (2 / reach.linear);
  assert.deepEqual(await dashes(), [Math.round(500 - part), Math.round(500 + part)]);
  await follow(page, 'lesson&step=law&limits.speed=off');
  assert.deepEqual(await dashes(), []);
});

pageTest(
  'each strip at the goal has its number where the other is not, and pieces of J have gaps',
  async (page) => {
    await page.open('#lesson&step=disturbance');
    const strips = await page.until('the strips', () => {
      const names = [...document.querySelectorAll('.near-name')];
      return (
        names.length === 2 &&
        names.map((name) => {
          const { left, top, width, height } = name.getBoundingClientRect();
          const under = document.elementsFromPoint(left + width / 2, top + height / 2);
          const on = under.filter((one) => one.matches('.near-set'));
          return [name.textContent, ...on.map((one) => one.getAttribute('class'))];
        })
      );
    });
    assert.deepEqual(strips, [
      ['(7)', 'near-set of-y'],
      ['(6)', 'near-set of-x'],
    ]);
    // Theorem 2 is about the law (5), with gains above zero.
    for (const link of ['&law=kanayama', '&drives=hand&gains=3,0,5']) {
      await follow(page, `lesson&step=disturbance${link}`);
      await page.until(`no strips with ${link}`, () => !document.querySelector('.near-name'));
    }
    await follow(page, 'lesson&step=cost');
    const gaps = await page.until('the bars', () => {
      const all = [...document.querySelectorAll('.standing-segment:not(:first-child)')];
      return all.length > 0 && all.map((one) => getComputedStyle(one).boxShadow);
    });
    for (const gap of gaps) assert.match(gap, /1px 0px 0px 0px inset/);
  },
);
