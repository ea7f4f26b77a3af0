import assert from 'node:assert/strict';
import { named, pageNames } from '../../../www/parts/parts.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { samples } from '../parts/samples.js';
import { bred, counted, slide } from '../parts/parking.js';
import { asOnPaper, canvasesIn, paper, printed, sheet } from './on-paper.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Of those parts of which more is to be seen than their names open. @type {Readonly<Record<string, readonly string[]>>} */
const more = {
  lab: ['lab&v=1&generation=20'],
  generation: ['generation&v=1&generation=3&phase=mutation'],
  curves: ['curves', 'curves&v=1&view=compare'],
  luck: ['luck', 'luck&v=1&luck=contest'],
};

/** A chart, and a map: in every engine. */
const inAll = ['lab&v=1&generation=20', 'landscape'];

const linksOf = (/** @type {string} */ name) =>
  more[name] ?? [name, ...(samples[name].views ?? []).map((view) => `${name}&v=1&${view}`)];

for (const link of pageNames.flatMap(linksOf))
  (inAll.includes(link) ? engineTest : pageTest)(
    `on paper there is the plane and the open part, whole, and nothing to press: ${link}`,
    async (page) => {
      const [part] = link.split('&');
      await page.open(`#${link}`);
      const before = await canvasesIn(page);
      assert.ok((await asOnPaper(page)) > 0);
      const after = await canvasesIn(page);
      assert.ok(after.length >= before.length, `${after} of ${before}`);
      await page.resize(paper, 900);
      await page.until('everything is drawn', () =>
        [...document.querySelectorAll('canvas')].every(
          (canvas) => !canvas.checkVisibility() || canvas.width !== 300 || canvas.height !== 150,
        ),
      );
      const seen = await page.evaluate(() => {
        const all = (/** @type {string} */ selector) =>
          [...document.querySelectorAll(selector)].filter((element) => element.checkVisibility());
        const shapeOf = (/** @type {Element} */ canvas) => {
          const { width, height } = canvas.getBoundingClientRect();
          const bitmap = /** @type {HTMLCanvasElement} */ (canvas);
          return { id: canvas.id, shown: width / height, drawn: bitmap.width / bitmap.height };
        };
        return {
          controls: all('button, select, progress, input[type="range"], input[type="checkbox"]')
            .filter((element) => !element.matches('.training-name, .generation-details .link'))
            .map(({ id }) => id),
          chosen: all('.pages a, .segmented label').map(
            (element) => /** @type {HTMLElement} */ (element).innerText,
          ),
          excess: document.documentElement.scrollWidth - innerWidth,
          overprinted: all('main h2').filter((heading) => {
            const { top, bottom, left, right } = heading.getBoundingClientRect();
            return all('main .segmented').some((choice) => {
              const box = choice.getBoundingClientRect();
              return (
                box.top < bottom - 4 && box.bottom > top + 4 && box.left < right - 4 && box.right > left + 4
              );
            });
          }).length,
          shapes: all('main canvas').map(shapeOf),
          together: all('canvas + canvas:not(#training-unseen)').map((over) => {
            const [a, b] = [over, /** @type {Element} */ (over.previousElementSibling)].map((canvas) =>
              canvas.getBoundingClientRect(),
            );
            return Math.hypot(a.left - b.left, a.top - b.top, a.right - b.right, a.bottom - b.bottom);
          }),
          // Else what is rubbed out of the upper canvas is rubbed out of the lower one when Chromium prints.
          // A mouse is of no use there; and who reads it wants the gains of whom is shown.
          hints: all('#tagline, #gains-note, .hint').length,
          gains: all('.driver').length === all('#gains').length,
          // Firefox prints what the attributes say.
          told: [
            .../** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll('.segmented input')),
          ].every(({ checked, defaultChecked }) => checked === defaultChecked),
          groups: all('main canvas').every((canvas) => Number(getComputedStyle(canvas).opacity) < 1),
        };
      });
      assert.deepEqual(seen.controls, []);
      assert.equal(seen.hints, 0);
      assert.equal(seen.overprinted, 0);
      assert.equal(seen.gains, true);
      assert.equal(seen.told, true);
      assert.ok(seen.excess <= 0, `${seen.excess} px too wide`);
      // Park has limits of its own.
      for (const chosen of [named[part].name, ...(part === 'park' ? [] : ['Velocity limits'])])
        assert.ok(seen.chosen.includes(chosen), `${chosen}: ${seen.chosen}`);
      for (const { id, shown, drawn } of seen.shapes)
        assert.ok(Math.abs(shown / drawn - 1) < 0.05, `${id} is ${shown} wide for its height, not ${drawn}`);
      for (const apart of seen.together) assert.ok(apart < 1, `${apart} px apart`);
      assert.equal(seen.groups, true);
    },
  );

engineTest('the plane leaves room on the first sheet, however high it was on the screen', async (page) => {
  await page.resize(1280, 800);
  await page.open('#training');
  // By what stands under it, because WebKit tells the size of what is zoomed as if it were not.
  const box = () =>
    page.evaluate(() => {
      const [plane, under] = ['plane', 'robot-clock'].map(
        (id) => /** @type {Element} */ (document.getElementById(id)).getBoundingClientRect().top + scrollY,
      );
      return { height: under - plane, bottom: under };
    });
  assert.ok((await box()).height > 600);
  await asOnPaper(page);
  const { height, bottom } = await box();
  assert.ok(height < 600 && bottom < sheet, `${height} high, to ${bottom}`);
});

pageTest('Park is one sheet, with the numbers that drive and what evolution found', async (page) => {
  await page.open('#park');
  await page.setPace(8);
  for (const gain of ['kx', 'ky', 'ktheta']) await slide(page, gain, 5);
  await counted(page);
  await asOnPaper(page);
  await page.resize(paper, 900);
  const seen = () =>
    page.evaluate(() => {
      const shown = (/** @type {string} */ selector) =>
        [...document.querySelectorAll(selector)].filter((element) => element.checkVisibility());
      const texts = (/** @type {string} */ selector) =>
        shown(selector).map((element) => /** @type {HTMLElement} */ (element).innerText.trim());
      return {
        height: document.documentElement.scrollHeight,
        numbers: texts('.park .gain > span'),
        marks: shown('.park-mark, .park-key, .park-walk, #park a').length,
        whole: texts('#park').join(),
      };
    });
  const byHand = await seen();
  assert.deepEqual(byHand.numbers, ['5.0', '5.0', '5.0']);
  assert.match(byHand.whole, /Red and hollow: missed/);
  assert.doesNotMatch(byHand.whole, /Press|Stuck/);
  await page.evaluate(() => document.getElementById('park-evolve')?.click());
  await page.until('evolution has come to its end', () => document.querySelector('.park-table'));
  const evolved = await seen();
  const { gains, generation } = bred();
  assert.deepEqual(
    evolved.numbers,
    gains.map((gain) => gain.toFixed(1)),
  );
  for (const told of ['32 of 32', '22 of 32', `Best of generation ${generation}`])
    assert.ok(evolved.whole.includes(told), `${told} in ${evolved.whole}`);
  for (const { height, marks } of [byHand, evolved]) {
    assert.ok(height <= sheet, `${height} px of ${sheet}`);
    assert.equal(marks, 0);
  }
});

pageTest(
  'a step on paper has its plane, a bowl that leaves room for the words, and the terms they ask to put in',
  async (page) => {
    for (const step of ['drive', 'law', 'stability']) {
      await page.resize(1280, 900);
      await page.open(`#lesson&step=${step}`);
      await asOnPaper(page);
      await page.resize(paper, 900);
      const seen = await page.until('the plane', () => {
        const box = (/** @type {string} */ selector) => {
          const element = document.querySelector(selector);
          return element?.checkVisibility() ? element.getBoundingClientRect() : null;
        };
        const plane = box('#plane');
        const [bowl, letters, asked, terms] = ['#bowl', '.bowl-text', '.cancel-said', '.cancel-terms'].map(
          box,
        );
        return plane && { plane, bowl, letters, asked, terms };
      });
      assert.ok(seen.plane.height > 100, `${step}: the plane is ${seen.plane.height} px high`);
      assert.equal(
        await page.evaluate(() => document.querySelector('.lesson-way')?.checkVisibility()),
        false,
      );
      if (step !== 'stability') continue;
      const { bowl, letters, asked, terms } = seen;
      assert.ok(bowl && letters && asked && terms, JSON.stringify(seen));
      const centimetre = 96 / 2.54;
      assert.ok(bowl.height <= 8 * centimetre, `the bowl is ${bowl.height} px high`);
      assert.ok(letters.height < 26, `its letters are ${letters.height} px high`);
      assert.ok(terms.top >= asked.bottom && terms.height > 20, 'the terms stand after what asks for them');
    }
  },
);

pageTest('a step on paper has the pictures that it has on the screen, whole, and no others', async (page) => {
  for (const [width, height, steps] of /** @type {const} */ ([
    [1280, 900, ['limits', 'cost', 'generation', 'sigma', 'duel', 'contest', 'task']],
    [390, 844, ['limits', 'cost']],
  ]))
    for (const step of steps) {
      await page.resize(width, height);
      await page.open(`#lesson&step=${step}`);
      await page.until(
        'its pictures',
        (isOfStage) => {
          const all = [...document.querySelectorAll('main canvas')].filter((one) => one.checkVisibility());
          const drawn = all.every((one) => /** @type {HTMLCanvasElement} */ (one).height !== 150);
          return drawn && (!isOfStage || document.querySelector('.stage > *'));
        },
        !['contest', 'task'].includes(step),
      );
      const before = await canvasesIn(page);
      const seen = await printed(page, () => {
        const plane = /** @type {HTMLElement} */ (document.getElementById('plane'));
        const all = [...document.querySelectorAll('main canvas')].filter((one) => one.checkVisibility());
        return {
          all: [...document.querySelectorAll('main canvas')].flatMap((one, i) =>
            all.includes(one) ? i : [],
          ),
          isPlaneLeft: plane.checkVisibility() && !plane.querySelector('canvas')?.checkVisibility(),
          names: document.querySelectorAll('.standing-name').length,
          shown: [...document.querySelectorAll('.standing-name')].filter((one) => one.checkVisibility())
            .length,
          pictures: all.map((one) => {
            const canvas = /** @type {HTMLCanvasElement} */ (one);
            const [box, place] = [canvas, /** @type {Element} */ (canvas.parentElement)].map((element) =>
              element.getBoundingClientRect(),
            );
            return {
              name: canvas.id || canvas.parentElement?.className,
              isChart: canvas.matches('.chart > *'),
              cut: box.bottom - place.bottom,
              height: box.height,
              larger: (box.width * devicePixelRatio) / canvas.width,
              shape: box.width / box.height / (canvas.width / canvas.height),
              fit: getComputedStyle(canvas).objectFit,
            };
          }),
        };
      });
      assert.deepEqual(seen.all, before, step);
      assert.equal(seen.isPlaneLeft, false, step);
      assert.equal(seen.shown, seen.names, step);
      for (const { name, isChart, cut, height: high, larger, shape, fit } of seen.pictures) {
        const told = `${step} ${width}: ${name}, ${high} px high, ${cut} px cut, ${larger} as large`;
        assert.ok(cut < 2 && high > 20, told);
        assert.ok(!isChart || larger < 1.05, told);
        assert.ok(fit === 'contain' || Math.abs(shape - 1) < 0.05, told);
      }
    }
});

engineTest(
  'what is drawn gets the colours of paper before it is printed, and its own again',
  async (page) => {
    await page.open('#lab&v=1&generation=5');
    const reds = () =>
      page.evaluate(() => {
        const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('plane-robots'));
        const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(
          0,
          0,
          canvas.width,
          canvas.height,
        );
        return data.filter((value, i) => i % 4 === 0 && value > 200 && data[i + 1] < 50 && data[i + 3] > 200)
          .length;
      });
    assert.equal(await reds(), 0);
    // A printer waits for no frame: this is all in one.
    await page.evaluate(() => {
      document.styleSheets[0].insertRule('[data-printing] { --ink: #f00 !important }');
      dispatchEvent(new Event('beforeprint'));
    });
    assert.ok((await reds()) > 100);
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal(await reds(), 0);
  },
);
