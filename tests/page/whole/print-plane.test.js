// The plane on paper: whole, no larger than on the screen, with room for what stands around it.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { asOnPaper, paper, printed } from './on-paper.js';

/** As high as a sheet of A4 between margins of a centimetre. */
const a4 = 1047;

pageTest('on paper all that lies on the plane lies where it lay, and no larger', async (page) => {
  for (const [width, height] of [
    [1280, 800],
    [2560, 1440],
  ]) {
    await page.resize(width, height);
    await page.open('#lesson&step=law');
    await page.until('the error', () => document.querySelector('#error-posture .error-label'));
    /** Where the name of x_e stands on the canvas, in shares of it, and how large both are. */
    const look = () => {
      const [canvas, marks, name] = ['#plane-paths', '#error-posture svg', '#error-posture .error-label'].map(
        (one) => /** @type {Element} */ (document.querySelector(one)).getBoundingClientRect(),
      );
      return {
        at: [(name.left - canvas.left) / canvas.width, (name.top - canvas.top) / canvas.height],
        apart: Math.hypot(marks.left - canvas.left, marks.right - canvas.right, marks.bottom - canvas.bottom),
        wide: canvas.width,
        high: canvas.height,
        postures: document.getElementById('postures')?.checkVisibility(),
      };
    };
    const before = await page.evaluate(look);
    const after = await printed(page, look);
    assert.ok(after.apart < 1, `${after.apart} px apart`);
    for (const axis of [0, 1]) assert.ok(Math.abs(after.at[axis] - before.at[axis]) < 0.005, `${after.at}`);
    assert.ok(after.wide <= Math.min(640, before.wide) + 1 && after.high < 430, JSON.stringify(after));
    assert.equal(after.postures, before.wide > 440);
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
