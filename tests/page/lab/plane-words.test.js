// What is said on the plane can be read: in each step of the lesson, and in whatever a step lets one try or asks about.
import assert from 'node:assert/strict';
import { hrefOf, linkOfStep, stepNames } from '../../../www/lesson/path.js';
import { steps } from '../../../www/lesson/steps.js';
import { Key, pageTest } from '../harness/browsers.js';
import { endSurrounding, follow, surround } from '../whole/surround.js';

/** Every link of a step, with a name for it. */
const links = steps.flatMap(({ name, blocks }) => {
  const number = stepNames.indexOf(name) + 1;
  /** @type {[string, string][]} */
  const all = [[name, linkOfStep(number)]];
  for (const block of blocks) {
    const tries = block.kind === 'tries' ? block.tries : [];
    for (const [key, link] of tries) all.push([`${name}, ${key}`, hrefOf(link, number).slice(1)]);
    if (block.kind === 'quiz' && block.quiz.shows)
      all.push([`${name}, ${block.name}?`, hrefOf(block.quiz.shows, number).slice(1)]);
  }
  return all;
});

/** From now on the texts that stand on each canvas are kept. */
function keepTexts() {
  const { prototype } = CanvasRenderingContext2D;
  const { fillText, clearRect } = prototype;
  const kept = /** @type {{ texts: WeakMap<HTMLCanvasElement, object[]> }} */ (
    /** @type {unknown} */ (Object.assign(window, { texts: new WeakMap() }))
  ).texts;
  prototype.clearRect = function (...given) {
    kept.set(this.canvas, []);
    clearRect.apply(this, given);
  };
  prototype.fillText = function (text, x, y) {
    const { width } = this.measureText(text);
    const left = this.textAlign === 'center' ? x - width / 2 : this.textAlign === 'right' ? x - width : x;
    const top = this.textBaseline === 'middle' ? y - 7 : y - 12;
    kept.get(this.canvas)?.push({ text, left, right: left + width, top, bottom: top + 14 });
    fillText.call(this, text, x, y);
  };
}

/** The step and the part of a link: where it has no plane, none of the other links there has. @param {string} link */
const placeOf = (link) => link.replace(/&.*&lesson/, '&lesson');

/** The words on the plane that lie on others, or a name there on a start or a goal; null where no plane is. */
async function overlaid() {
  /** @typedef {{ text: string, left: number, right: number, top: number, bottom: number, whole?: Element }} Said */
  const plane = /** @type {HTMLElement} */ (document.getElementById('plane'));
  const { texts } = /** @type {{ texts: WeakMap<Element, Said[]> }} */ (/** @type {unknown} */ (window));
  if (!plane.checkVisibility()) return null;
  // Pictures follow a new size within some frames, and lie as they will once nothing of them moves.
  let found = [''];
  for (let i = 0, still = 0; i < 60 && still < 4; i += 1) {
    await pageFrames.settled();
    const now = flaws();
    still = String(now) === String(found) ? still + 1 : 0;
    found = now;
  }
  return found;

  function flaws() {
    const said = [...saidInElements(), ...saidOnCanvases()];
    const all = [];
    for (const [i, one] of said.entries())
      for (const other of said.slice(i + 1)) {
        const across = Math.min(one.right, other.right) - Math.max(one.left, other.left);
        const down = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
        // Of an arrow and its knob the second name keeps away, and of the knob what is paid: the others have their places.
        const isOnArrow = [one, other].some(({ whole }) => whole?.id === 'handles');
        const isDotted = [one, other].some(({ whole }) => whole?.matches('.dashed'));
        const isPaid = other.text.startsWith('J ') && one.text.endsWith('-heading');
        const isMet = isDotted || isPaid || !isOnArrow;
        if (across > 1 && down > 1 && one.whole !== (other.whole ?? null) && isMet)
          all.push(`“${one.text}” and “${other.text}”`);
      }
    return all;
  }

  function saidInElements() {
    const { left, top } = plane.getBoundingClientRect();
    const range = document.createRange();
    /** @type {Said[]} */
    const said = [];
    for (const whole of plane.querySelectorAll('li, .error-label, .handle')) {
      if (!whole.checkVisibility({ visibilityProperty: true })) continue;
      const text = (whole.textContent ?? '').replace(/\s+/g, ' ').trim() || whole.id;
      range.selectNodeContents(whole);
      const isHandle = whole.matches('.handle');
      const middle = whole.getBoundingClientRect();
      // What has a ground covers with it what is paid.
      const isWhole = isHandle || getComputedStyle(whole).backgroundColor !== 'rgba(0, 0, 0, 0)';
      const boxes = isWhole ? [middle] : text ? range.getClientRects() : [];
      // Of a handle what is drawn: the arrow, or the knob.
      const least = isHandle ? (whole.matches('.position') ? 13 : 17) : 0;
      for (const box of boxes) {
        const lead = isHandle ? least : box.height * 0.1;
        said.push({
          text,
          whole: isHandle ? /** @type {Element} */ (whole.parentElement) : whole,
          left: box.left - left - plane.clientLeft + least,
          right: box.right - left - plane.clientLeft - least,
          top: box.top - top - plane.clientTop + lead,
          bottom: box.bottom - top - plane.clientTop - lead,
        });
      }
    }
    return said;
  }

  function saidOnCanvases() {
    return [...plane.querySelectorAll('canvas')].flatMap((canvas) => texts.get(canvas) ?? []);
  }
}

pageTest('on a laptop no words on the plane lie on others in any step of the lesson', async (page) => {
  if (page.engine !== 'chromium') return;
  /** @type {string[]} */
  const found = [];
  /** @type {Set<string>} */
  const planeless = new Set();
  try {
    await page.open('#lab&v=1');
    await surround(page, [1366, 768]);
    await page.evaluate(keepTexts);
    for (const [name, link] of links) {
      if (planeless.has(placeOf(link))) continue;
      await follow(page, link);
      const flaws = await page.evaluate(overlaid);
      if (!flaws) planeless.add(placeOf(link));
      for (const flaw of flaws ?? []) found.push(`${name}: ${flaw}`);
    }
  } finally {
    await endSurrounding(page);
  }
  assert.equal(found.join('\n'), '');
});

/** How many words along the path say what is paid. */
function paidThere() {
  const { texts } = /** @type {{ texts: WeakMap<Element, { text: string }[]> }} */ (
    /** @type {unknown} */ (window)
  );
  const canvas = document.getElementById('plane-paths');
  return (canvas && texts.get(canvas))?.filter(({ text }) => text.startsWith('J ')).length ?? 0;
}

pageTest('where there is room for what is paid along the path, none of it lies on a knob', async (page) => {
  if (page.engine !== 'chromium') return;
  try {
    await page.open('#lab&v=1');
    await surround(page, [1366, 900]);
    await page.evaluate(keepTexts);
    const wanted = ['limits', 'stability', 'paper, literal?'];
    for (const [name, link] of links.filter(([one]) => wanted.includes(one))) {
      await follow(page, link);
      assert.deepEqual(await page.evaluate(overlaid), [], name);
      const paid = await page.evaluate(paidThere);
      assert.ok(paid >= 3, `${name}: ${paid}`);
    }
  } finally {
    await endSurrounding(page);
  }
});

pageTest('on a telephone what is paid along the path is read whole', async (page) => {
  if (page.engine !== 'chromium') return;
  try {
    await page.open('#curves&v=1&view=stability&generation=20');
    await surround(page, [390, 844]);
    await page.evaluate(keepTexts);
    await follow(page, 'curves&v=1&view=numbers&generation=20&drives=paper-ep');
    await follow(page, 'curves&v=1&view=stability&generation=20');
    assert.deepEqual(await page.evaluate(overlaid), []);
    assert.ok((await page.evaluate(paidThere)) > 0);
  } finally {
    await endSurrounding(page);
  }
});

pageTest('where x_e and y_e are drawn, the corner in which they meet is on the plane', async (page) => {
  if (page.engine !== 'chromium') return;
  const withErrors = steps.filter(({ overlay }) => overlay);
  let drawn = 0;
  try {
    await page.open('#lab&v=1');
    await surround(page, [1366, 768]);
    for (const [name, link] of links.filter(([one]) =>
      withErrors.some((step) => one.startsWith(step.name)),
    )) {
      await follow(page, link);
      await page.focus('#scrub');
      await page.press(Key.HOME);
      const far = await page.evaluate(() => {
        const plane = /** @type {HTMLElement} */ (document.getElementById('plane'));
        const { clientWidth, clientHeight } = plane;
        const path = plane.querySelector('.error-line.of-y')?.getAttribute('d') ?? '';
        const [, x, y] = /L([-\d.]+),([-\d.]+)/.exec(path) ?? [];
        return path ? Math.min(+x, clientWidth - +x, +y, clientHeight - +y) : null;
      });
      assert.ok(far === null || far > 16, `${name}: ${far} px within the edge`);
      if (far !== null) drawn += 1;
    }
    assert.ok(drawn >= withErrors.length, `y_e was drawn ${drawn} times`);
  } finally {
    await endSurrounding(page);
  }
});
