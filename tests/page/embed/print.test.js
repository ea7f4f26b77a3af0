// A page that holds figures, on paper: they are as they stand on the screen, without what is pressed.
import assert from 'node:assert/strict';
import { pageNames } from '../../../www/parts/parts.js';
import { pageTest } from '../harness/browsers.js';
import { frameOf, inHost, inNextFrame, within } from '../harness/host.js';
import { turnToPaper } from '../whole/on-paper.js';

/** Of the lesson those whose figure shows its stage, its part and its robot. */
const steps = ['drive', 'law', 'limits', 'landscape', 'lecturers'].map((step) => `lesson&step=${step}`);

/** In the frame: where its pictures are, and what can be pressed. */
const look = () => ({
  pictures: [...document.querySelectorAll('main canvas, main .picture')].flatMap((one) => {
    const { left, top, width, height } = one.getBoundingClientRect();
    return one.checkVisibility({ visibilityProperty: true }) ? [[one.id, left, top, width, height]] : [];
  }),
  words: [...document.querySelectorAll('.lesson p')].filter((one) => {
    const { top, bottom, left } = one.getBoundingClientRect();
    return left > 0 && top < innerHeight && bottom > top;
  }).length,
  pressed: [...document.querySelectorAll('button, select, input[type="range"]')].filter(
    (one) =>
      !one.matches('.training-name, .choice, .on-paper') && one.checkVisibility({ visibilityProperty: true }),
  ).length,
});

for (const [width, height] of [
  [640, 420],
  [1000, 620],
])
  pageTest(`a figure of ${width} × ${height} has its pictures on the paper of its host too`, async (page) => {
    await inHost(page, '', async () => {
      for (const name of [...pageNames, ...steps])
        await inNextFrame(page, frameOf(page, `${name}&v=1`, width, height), () =>
          within(page, 0, async () => {
            await page.until('there is something to see', () =>
              [...document.querySelectorAll('main :is(canvas, .picture), .lesson p')].some((one) =>
                one.checkVisibility({ visibilityProperty: true }),
              ),
            );
            // At once, for what is computed comes meanwhile.
            const [before, after] = /** @type {ReturnType<typeof look>[]} */ (
              await page.driver.executeScript(
                `const before = (${look})(); (${turnToPaper})(); return [before, (${look})()];`,
              )
            );
            assert.ok(before.pressed > 0 && before.pictures.length + before.words > 0, name);
            assert.deepEqual(after, { ...before, pressed: 0 }, name);
          }),
        );
    });
  });

pageTest('a figure that is narrower on paper is drawn as wide as it is there', async (page) => {
  await page.resize(1000, 700);
  const html = frameOf(page, 'lab&v=1', 900, 420).replace('width="900"', 'width="100%"');
  await inHost(page, html, async () => {
    await within(page, 0, () =>
      page.evaluate(() => {
        // The first that hears of it is the page itself.
        matchMedia('print').addEventListener('change', ({ matches }) => {
          if (!matches) return;
          const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('plane-paths'));
          const plane = /** @type {HTMLElement} */ (document.getElementById('plane'));
          Reflect.set(window, 'onPaper', [
            innerWidth,
            canvas.width / devicePixelRatio,
            plane.clientWidth,
            plane.clientHeight,
          ]);
        });
      }),
    );
    await page.driver.printPage(/** @type {any} */ ({ width: 21, height: 29.7 }));
    const [wide, drawn, width, height] = await within(page, 0, () =>
      page.evaluate(() => Reflect.get(window, 'onPaper')),
    );
    assert.ok(wide < 900, `the paper is ${wide} wide`);
    assert.equal(drawn, width);
    assert.ok(height > 200, `the plane is ${height} high`);
  });
});
