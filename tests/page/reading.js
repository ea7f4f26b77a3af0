// What a person reads on the page, in one look.

/** @typedef {import('./browsers.js').Page} Page */
/** @typedef {{ x: number, y: number, degrees: number }} PostureText */

/** Reads the page once it has drawn what happened last. @param {Page} page */
export function read(page) {
  return page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));

    /** @param {string} id */
    const element = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
    /** @param {string} id */
    const numbers = (id) =>
      (
        element(id)
          .innerText.replaceAll('−', '-')
          .match(/-?\d+(\.\d+)?/g) ?? []
      ).map(Number);
    /** @param {string} id */
    const posture = (id) => {
      const [x, y, degrees] = numbers(id);
      return { x, y, degrees };
    };
    /** @param {string} id */
    const chosen = (id) =>
      /** @type {HTMLInputElement} */ (document.querySelector(`#${id} input:checked`)).value;
    const [time, finalTime] = numbers('clock');

    return {
      generation: element('generation').innerText,
      seed: element('seed').innerText,
      cost: element('cost-total').innerText,
      gains: ['kx', 'ky', 'ktheta'].map(
        (gain) => /** @type {HTMLInputElement} */ (element(`gain-${gain}`)).value,
      ),
      driver: chosen('drives'),
      preset: chosen('preset'),
      time,
      finalTime,
      start: posture('start-text'),
      goal: posture('goal-text'),
    };
  });
}

/** What evolution shows, which the robot's clock must not touch. @param {Page} page */
export async function readEvolution(page) {
  const { generation, seed, cost, gains } = await read(page);
  return { generation, seed, cost, gains };
}

/** Waits until the robots' clock shows their final time. @param {Page} page */
export const arrival = (page) =>
  page.until('the robots arrive', () => {
    const [time, finalTime] = document.getElementById('clock')?.innerText.match(/\d+\.\d+/g) ?? [];
    return time !== undefined && time === finalTime;
  });

/** The middle of an element, in pixels from the top left corner of another one. @param {Page} page @param {string} id @param {string} [within] */
export function middleOf(page, id, within = 'plane-robots') {
  return page.evaluate(
    async (one, other) => {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const [box, around] = [one, other].map((name) =>
        /** @type {HTMLElement} */ (document.getElementById(name)).getBoundingClientRect(),
      );
      return { x: box.left + box.width / 2 - around.left, y: box.top + box.height / 2 - around.top };
    },
    id,
    within,
  );
}

/** Waits until the page has checked its own numbers, or has said why it cannot. @param {Page} page */
export const checked = (page) =>
  page.until('the checks have ended', () => {
    const { open } = /** @type {HTMLDialogElement} */ (document.getElementById('checks'));
    return open && document.getElementById('checks-progress')?.hidden;
  });
