// Exercises as students solve them: in the page and in a frame, handed in, told to the host, opened by who checks.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { sizes } from '../../../www/embed/frame.js';
import { Key, pageTest } from '../harness/browsers.js';
import { experiment, simulate } from '../harness/core.js';
import { heardFrom, inHost, within } from '../harness/host.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const exercise =
  'lab&v=1&drives=hand&gains=3,0,0&lock=postures,seed,settings&hide=paper,run,parts&task=J%20below%207.75.&aim=J%3C7.75&points=9:0,7.75:10';
const free = 'lab&v=1&task=Find%20gains.&aim=J%3C8;drives%3C%3D4000&points=9:0,7.75:10';

/** @param {Page} page @param {string} link @param {readonly number[]} size */
const frameOf = (page, link, [width, height]) =>
  `<iframe src="${page.site.address}?embed#${link.replaceAll('&', '&amp;')}" width="${width}" height="${height}" style="border: 0"></iframe>`;

/** In a frame: what of the exercise is not wholly in sight, or lies on something else. @param {readonly string[]} selectors */
function outOfSight(selectors) {
  const { clientWidth, clientHeight, scrollWidth, scrollHeight } = document.documentElement;
  const problems = [];
  if (scrollWidth > clientWidth || scrollHeight > clientHeight)
    problems.push(`${scrollWidth} × ${scrollHeight}`);
  const boxes = selectors.map((selector) => {
    const element = document.querySelector(selector);
    if (!element?.checkVisibility()) problems.push(`${selector} is not shown`);
    const box = /** @type {Element} */ (element).getBoundingClientRect();
    const holder = element?.closest('.exercise, .driver')?.getBoundingClientRect() ?? box;
    if (box.left < 0 || box.top < 0 || box.right > clientWidth + 0.5 || box.bottom > clientHeight + 0.5)
      problems.push(`${selector} sticks out`);
    if (box.bottom > holder.bottom + 1) problems.push(`${selector} is scrolled away`);
    if (box.height < 24) problems.push(`${selector} is ${box.height} high`);
    return { selector, box };
  });
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1))
      if (
        a.box.left < b.box.right - 1 &&
        b.box.left < a.box.right - 1 &&
        a.box.top < b.box.bottom - 1 &&
        b.box.top < a.box.bottom - 1
      )
        problems.push(`${a.selector} lies on ${b.selector}`);
  return problems;
}

const needed = [
  '#hand-in',
  '#plane',
  '#slider-kx',
  '#slider-ky',
  '#slider-ktheta',
  '#gain-kx',
  '#gain-ky',
  '#gain-ktheta',
];

pageTest(
  'the figure of an exercise shows what its task needs at every size, in both languages',
  async (page) => {
    const links = [
      { link: exercise, more: [] },
      { link: free, more: ['#run', '#drives-evolved + span'] },
      { link: free.replace('&v=1', '&v=1&lang=ko'), more: ['#run', '#drives-evolved + span'] },
    ];
    const frames = sizes.flatMap((size) => links.map(({ link, more }) => ({ size, link, more })));
    const html = frames.map(({ link, size }) => frameOf(page, link, size)).join('');
    await inHost(page, html, async () => {
      for (const [frame, { size, link, more }] of frames.entries())
        await within(page, frame, async () => {
          await page.until('its work is there', () => document.getElementById('hand-in'));
          assert.deepEqual(await page.evaluate(outOfSight, [...needed, ...more]), [], `${size} ${link}`);
          assert.ok((await page.text('#aim')).length > 10);
        });
    });
  },
);

pageTest('an exercise is solved and handed in where it is given, and the host hears of it', async (page) => {
  let address = '';
  await inHost(page, frameOf(page, exercise, sizes[0]), async () => {
    address = await within(page, 0, async () => {
      await page.until('its work is there', () => document.getElementById('hand-in'));
      assert.match(await page.text('#aim'), /not yet met/);
      // Only a frame that is used gets keys.
      await page.click('#task');
      for (const [id, value] of /** @type {const} */ ([
        ['kx', '3.3'],
        ['ktheta', '4.5'],
      ])) {
        await page.focus(`#gain-${id}`);
        await page.press(...value, Key.ENTER);
        await page.until(
          'it drives',
          (gain) =>
            document.getElementById(`gain-${gain[0]}`)?.closest('.gain')?.querySelector('input')
              ?.valueAsNumber === Number(gain[1]),
          [id, value],
        );
      }
      await page.until('the aim is met', () => document.querySelector('#aim.met'));
      await page.click('#hand-in');
      await page.until('it asks who', () => document.getElementById('handin-who'));
      await page.focus('#handin-who');
      await page.press(...'s\u200b 4711', Key.ENTER);
      await page.until('the receipt is there', () => document.getElementById('handin-text'));
      if (page.engine === 'chromium') assert.deepEqual(await page.obstacles('#handin'), []);
      return page.evaluate(
        () => /** @type {HTMLInputElement} */ (document.getElementById('handin-link')).value,
      );
    });
    const heard = await heardFrom(page, 0);
    const drives = heard.filter(({ type }) => type === 'drive');
    assert.deepEqual(
      drives.map(({ gains }) => gains),
      [
        [3.3, 0, 0],
        [3.3, 0, 4.5],
      ],
    );
    const { cost, finalTime } = simulate(experiment('velocity-limits'), [3.3, 0, 4.5]);
    assert.deepEqual(
      [drives[1].cost.total, drives[1].finalTime, drives[1].drives],
      [cost.total, finalTime, 2],
    );
    const [handed, ...others] = heard.filter(({ type }) => type === 'handin');
    assert.deepEqual(others, []);
    assert.deepEqual(
      [
        handed.who,
        handed.gains,
        handed.cost,
        handed.met,
        handed.points,
        handed.most,
        handed.drives,
        handed.link,
      ],
      ['s 4711', [3.3, 0, 4.5], cost.total, true, 10, 10, 2, address],
    );
    assert.match(handed.text, /^ep-locomotion hand-in · [^\n]*\nName: s 4711\nJ = 7\.71/);
    assert.ok(handed.text.endsWith(address));
  });
  await page.visit(address);
  await page.until('it is checked', () => document.querySelector('.work-said'));
  assert.match(await page.text('.work-said'), /^Handed in by s 4711: J = 7\.71\d+\. It holds/);
  assert.match(await page.evaluate(() => location.hash), /&handin=1~7\.71/);
  // Whoever goes on from it has a run of their own.
  await page.focus('#gain-kx');
  await page.press('4', Key.ENTER);
  await page.until('it is no receipt any more', () => !document.querySelector('.work-said'));
  await page.until('nor is its address', () => !location.hash.includes('handin'));
  await page.visit(address.replace('gains=3.3', 'gains=3.2'));
  await page.until('it is checked', () => document.querySelector('.work-said'));
  assert.match(await page.text('.work-said'), /was cut or changed/);
});

pageTest('what is drawn for a student waits for who it is, and follows from it', async (page) => {
  const link = 'lab&v=1&task=Park.&aim=J%3C9&vary=goal,seed&lock=postures';
  await page.open(`#${link}`);
  await page.until('it asks', () => document.getElementById('work-who'));
  const ends = () =>
    page.evaluate(() => [
      document.getElementById('goal-text')?.textContent,
      document.getElementById('seed')?.textContent,
    ]);
  const before = await ends();
  await page.focus('#work-who');
  await page.press(...'s47');
  // In Safari the Enter that ends a composition is no longer part of it.
  await page.evaluate(() =>
    document.activeElement?.dispatchEvent(
      new KeyboardEvent('keydown', { key: 'Enter', keyCode: 229, bubbles: true }),
    ),
  );
  // Copied with what nobody sees.
  await page.press(...'\u206311', Key.ENTER);
  await page.until('it begins', () => document.getElementById('hand-in'));
  const drawn = await ends();
  assert.notDeepEqual(drawn, before);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'hand-in');
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.driver.actions().keyDown(Key.CONTROL).sendKeys('z').keyUp(Key.CONTROL).perform();
  assert.deepEqual(await ends(), drawn, 'it is not taken back');
  await page.until('the address says who', () => /&vary=goal,seed&who=s4711$/.test(location.hash));
  // As a learning platform writes it: before the # and behind all.
  await page.open(`?who=S4711#${link}`);
  await page.until('it begins', () => document.getElementById('hand-in'));
  assert.deepEqual(await ends(), drawn);
  await page.open(`#${link.replaceAll('&', '&amp;')}?who=s4711`);
  await page.until('it begins', () => document.getElementById('hand-in'));
  assert.deepEqual(await ends(), drawn);
  // Drawn for a name that is typed, the run comes as far as the link says; and the name stays that for which it is drawn.
  await page.open(`#${link}&generation=12`);
  await page.until('it asks', () => document.getElementById('work-who'));
  await page.focus('#work-who');
  await page.press(...'s4711', Key.ENTER);
  await page.until('it has come as far', () => document.getElementById('generation')?.textContent === '12');
  await page.click('#hand-in');
  await page.until('it says who', () => document.getElementById('handin-who'));
  assert.equal(
    await page.evaluate(
      () => /** @type {HTMLInputElement} */ (document.getElementById('handin-who')).readOnly,
    ),
    true,
  );
  // On a phone there is nothing to hover over.
  assert.match(await page.text('#handin-drawn'), /for another, open the link that your lecturer gave/);
  assert.deepEqual(await page.problems(), []);
});

pageTest('who makes an exercise sees the very figure that students get', async (page) => {
  await page.open('#lab&v=1&drives=hand&gains=3,0,0');
  await page.click('#keep-button');
  await page.click('#keep-exercise');
  await page.press(...'Park.');
  await page.evaluate(() => {
    const kind = /** @type {HTMLSelectElement} */ (document.getElementById('maker-aim'));
    kind.value = 'cost';
    kind.dispatchEvent(new Event('change', { bubbles: true }));
  });
  await page.focus('#maker-value');
  await page.press(Key.END, '.', 'x');
  assert.match(await page.text('#maker-aim-error'), /must be a number/);
  await page.press(Key.BACK_SPACE, '5');
  // From here on nothing comes and goes above what is pressed.
  const hint = await page.until('the hint', () => document.getElementById('maker-easy')?.innerText);
  const points = /** @type {const} */ ([
    ['points-0', '0'],
    ['at-0', '9'],
    ['points-1', '10'],
    ['at-1', '7.75'],
  ]);
  for (const [id, value] of points) {
    await page.focus(`#maker-${id}`);
    await page.press(...value);
  }
  assert.equal(await page.text('#maker-easy'), hint);
  await page.click('#maker-vary-seed');
  const link = await page.until('the link has it all', () => {
    const { value } = /** @type {HTMLInputElement} */ (document.getElementById('maker-link'));
    return value.includes('vary=seed') && value;
  });
  assert.match(new URL(link).hash, /&task=Park\.&aim=J%3C8\.5&points=9%3A0,7\.75%3A10&vary=seed$/);
  await page.click('#maker-preview-size-400x300');
  await page.until('the figure stands there', () => {
    const figure = /** @type {HTMLIFrameElement | null} */ (document.getElementById('maker-figure'));
    return figure?.contentDocument?.getElementById('task')?.textContent === 'Park.';
  });
  const [width, height, hash] = await page.evaluate(() => {
    const figure = /** @type {HTMLIFrameElement} */ (document.getElementById('maker-figure'));
    return [figure.clientWidth, figure.clientHeight, figure.contentWindow?.location.hash];
  });
  assert.deepEqual([width, height, hash], [400, 300, new URL(link).hash]);
  const frame = await page.evaluate(
    () => /** @type {HTMLInputElement} */ (document.getElementById('maker-frame')).value,
  );
  assert.match(frame, /width="400" height="300"/);
  await page.press(Key.ESCAPE);
  assert.equal(await page.evaluate(() => document.querySelector('iframe')), null);
  assert.deepEqual(await page.problems(), []);
});

pageTest(
  'an answer to the lesson’s question is told to the host, and stands in what is handed in',
  async (page) => {
    const html = frameOf(page, `${links.linkOfStep(3)}&task=Predict.`, sizes[2]);
    await inHost(page, html, async () => {
      await within(page, 0, async () => {
        await page.until('a question is there', () => document.querySelector('.quiz .choice'));
        await page.evaluate(() =>
          /** @type {HTMLElement} */ (document.querySelector('.quiz .choice')).click(),
        );
        await page.until('it is answered', () => document.querySelector('.quiz .choice.right'));
        await page.until('it can be handed in', () => document.getElementById('hand-in'));
        await page.evaluate(() => document.getElementById('hand-in')?.click());
        await page.until('it asks who', () => document.getElementById('handin-who'));
        await page.evaluate(() => {
          /** @type {HTMLInputElement} */ (document.getElementById('handin-who')).value = 's7';
          document.getElementById('handin-make')?.click();
        });
        await page.until('the receipt is there', () => document.getElementById('handin-text'));
      });
      const heard = await heardFrom(page, 0);
      const [answer, ...others] = heard.filter(({ type }) => type === 'answer');
      assert.deepEqual(others, []);
      assert.match(answer.question, /^law\./);
      assert.ok(answer.choice >= 0 && answer.right >= 0);
      const [{ text, link }] = heard.filter(({ type }) => type === 'handin');
      const mark = answer.choice === answer.right ? '+' : '-';
      assert.ok(text.includes(`Answers: ${answer.question}:${answer.choice}${mark}`), text);
      assert.match(link, /lesson=3.*&handin=/);
    });
  },
);
