// The plane on paper: whole, no larger than on the screen, with room for what stands around it.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { asOnPaper, paper, printed } from './on-paper.js';

/** As high as a sheet of A4 between margins of a centimetre. */
const a4 = 1047;

pageTest('on paper all that lies on the plane lies where it lay, with letters as large', async (page) => {
  for (const [width, height] of [
    [1280, 800],
    [2560, 1440],
  ]) {
    await page.resize(width, height);
    await page.open('#lesson&step=law');
    await page.until('the error', () => document.querySelector('#error-posture .error-label'));
    /** Whether the name of x_e stands on the canvas, how large it is, and how large both are. */
    const look = () => {
      const [canvas, marks, name] = ['#plane-paths', '#error-posture svg', '#error-posture .error-label'].map(
        (one) => /** @type {Element} */ (document.querySelector(one)).getBoundingClientRect(),
      );
      const drawn = /** @type {HTMLCanvasElement} */ (document.getElementById('plane-paths')).width;
      return {
        drawn,
        isOn: name.left > canvas.left && name.right < canvas.right && name.bottom < canvas.bottom,
        apart: Math.hypot(marks.left - canvas.left, marks.right - canvas.right, marks.bottom - canvas.bottom),
        letter: name.height,
        scale: (canvas.width * devicePixelRatio) / drawn,
        wide: canvas.width,
        high: canvas.height,
        postures: document.getElementById('postures')?.checkVisibility(),
      };
    };
    const before = await page.evaluate(look);
    const again = await page.evaluate(() => {
      for (const name of ['beforeprint', 'afterprint']) dispatchEvent(new Event(name));
      return /** @type {HTMLCanvasElement} */ (document.getElementById('plane-paths')).width;
    });
    assert.equal(again, before.drawn);
    const after = await printed(page, look);
    assert.ok(after.isOn, JSON.stringify(after));
    assert.ok(after.apart < 1, `${after.apart} px apart`);
    assert.ok(Math.abs(after.letter - before.letter) < 0.5, `${after.letter} px, not ${before.letter}`);
    assert.ok(Math.abs(after.scale - 1) < 0.02, `${after.scale} as large as it was drawn`);
    assert.ok(after.wide <= Math.min(640, before.wide) + 1 && after.high < 430, JSON.stringify(after));
    assert.equal(after.postures, before.wide > 440);
  }
});

pageTest('what a wide window draws has letters on paper that one can read', async (page) => {
  await page.resize(2560, 1440);
  for (const link of [
    'lab&v=1&generation=20',
    'generation&v=1&generation=3',
    'landscape',
    'curves',
    'luck',
  ]) {
    await page.open(`#${link}`);
    await page.until('its pictures', () =>
      [...document.querySelectorAll('main canvas')].every(
        (one) => !one.checkVisibility() || /** @type {HTMLCanvasElement} */ (one).height !== 150,
      ),
    );
    const scales = await printed(page, () =>
      [...document.querySelectorAll('main canvas, main .picture > svg')].flatMap((one) => {
        if (!one.checkVisibility()) return [];
        const wide = one.getBoundingClientRect().width;
        const drawn =
          one instanceof HTMLCanvasElement
            ? one.width / devicePixelRatio
            : /** @type {SVGSVGElement} */ (one).viewBox.baseVal.width;
        return [{ name: one.id || one.parentElement?.id, scale: wide / drawn }];
      }),
    );
    assert.ok(scales.length > 2, link);
    for (const { name, scale } of scales) assert.ok(scale > 0.95, `${link}: ${name} ${scale} as large`);
  }
});

pageTest('the lab is one sheet, and the lecturers’ sheets come without it', async (page) => {
  // As a laptop shows it; where the window is higher, so is the curve.
  await page.resize(1366, 768);
  await page.open('#lab&v=1&generation=20');
  await asOnPaper(page);
  await page.resize(paper, 768);
  const high = await page.evaluate(() => document.documentElement.scrollHeight);
  assert.ok(high <= a4, `${high} px of ${a4}`);
  await page.resize(1366, 768);
  await page.open('#lesson&step=lecturers');
  await page.until('its sheets', () => document.querySelector('.sheet-list'));
  const isSeen = () => document.getElementById('plane')?.checkVisibility();
  assert.equal(await page.evaluate(isSeen), true);
  await asOnPaper(page);
  assert.equal(await page.evaluate(isSeen), false);
});
