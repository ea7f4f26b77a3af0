// Somebody presses, types, drags and opens whatever there is, without a thought. Sent into the page as text: nothing here may name
// anything else.

/**
 * So many random actions, one after the other, each in a frame of its own.
 * @param {number} seed @param {number} count @param {readonly string[]} links
 * @returns {Promise<string[]>} What was done.
 */
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: it is sent into the page as one text.
export async function monkey(seed, count, links) {
  // mulberry32
  let state = seed | 0;
  const random = () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
  /** @template T @param {ArrayLike<T>} list */
  const one = (list) => list[Math.floor(random() * list.length)];
  const frame = () =>
    new Promise((resolve) => {
      requestAnimationFrame(resolve);
      setTimeout(resolve, 200);
    });

  // The dialogue of a printer would hold the page.
  window.print = () => {
    for (const name of ['beforeprint', 'afterprint']) dispatchEvent(new Event(name));
  };

  /** @type {string[]} */
  const done = [];
  const keys = [
    ' ',
    'Enter',
    'Escape',
    'ArrowLeft',
    'ArrowRight',
    'ArrowUp',
    'ArrowDown',
    'Home',
    'End',
    'r',
    'n',
    'p',
    '?',
    'z',
    '+',
  ];
  const texts = [
    '',
    '0',
    '-1',
    '1',
    '3',
    '12',
    '0.5',
    '1e9',
    '-1e-9',
    // None to the page, and no word that it may say.
    'nan',
    'Infinity',
    'x',
    '٣',
    '1,5',
    '𝒦',
    '<b>',
    '2'.repeat(400),
  ];
  const types = { bubbles: true, cancelable: true, composed: true };

  /** @param {Element} element @param {string} type @param {number} x @param {number} y */
  const point = (element, type, x, y) =>
    element.dispatchEvent(
      new PointerEvent(type, {
        ...types,
        pointerId: 1,
        isPrimary: true,
        pointerType: 'mouse',
        button: 0,
        buttons: 1,
        clientX: x,
        clientY: y,
      }),
    );

  /** @param {HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement} field */
  const fill = (field) => {
    if (field instanceof HTMLSelectElement) field.selectedIndex = Math.floor(random() * field.options.length);
    else if (field instanceof HTMLInputElement && field.type === 'range') {
      const [low, high] = [Number(field.min), Number(field.max)];
      field.value = String(low + random() * (high - low));
    } else if (field.type === 'radio' || field.type === 'checkbox') return field.click();
    else field.value = one(texts);
    field.dispatchEvent(new Event('input', types));
    field.dispatchEvent(new Event('change', types));
  };

  /** @param {Element} element */
  const drag = (element) => {
    const { left, top, width, height } = element.getBoundingClientRect();
    const anywhere = () => [left + (random() * 3 - 1) * width, top + (random() * 3 - 1) * height];
    let [x, y] = [left + random() * width, top + random() * height];
    const target = document.elementFromPoint(x, y) ?? element;
    point(target, 'pointerdown', x, y);
    for (let i = 0; i < 3; i++) {
      [x, y] = anywhere();
      point(target, 'pointermove', x, y);
    }
    point(target, random() < 0.9 ? 'pointerup' : 'pointercancel', x, y);
  };

  // Files are neither saved nor asked for: a window of the browser would stand before the page.
  for (const { prototype } of [HTMLInputElement, HTMLAnchorElement]) {
    const { click } = prototype;
    prototype.click = function () {
      if (!this.matches('[type="file"], [download]')) click.call(this);
    };
  }

  // No pointer of the browser is behind what is dispatched here.
  Element.prototype.setPointerCapture = () => {};
  // Back beyond them would leave the page.
  let followed = 0;
  const seen = (/** @type {Element} */ element) => element.checkVisibility() && !element.closest('[inert]');
  for (let i = 0; i < count; i++) {
    const open = document.querySelector('dialog[open]') ?? document;
    // What leads away is left alone.
    const pressed = 'button:not(:disabled), a[href^="#"]:not(#language), summary';
    const controls = [
      ...open.querySelectorAll(
        `${pressed}, input:not([type="file"], :disabled), select:not(:disabled), textarea, canvas, svg, [role="slider"]`,
      ),
    ].filter(seen);
    const element = one(controls) ?? document.body;
    const name = `${element.tagName.toLowerCase()}#${element.id || element.className}`;
    const dice = random();
    if (dice < 0.03) {
      const link = one(links);
      location.hash = link;
      done.push(`opens ${link.slice(0, 200)}`);
      followed += 1;
    } else if (dice < 0.06 && followed > 0) {
      history.back();
      followed -= 1;
      done.push('goes back');
    } else if (dice < 0.14) {
      const key = one(keys);
      const at = document.activeElement ?? document.body;
      for (const type of ['keydown', 'keyup'])
        at.dispatchEvent(new KeyboardEvent(type, { ...types, key, ctrlKey: key === 'z' }));
      done.push(`key ${key}`);
    } else if (element.matches('canvas, svg, [role="slider"]') || dice < 0.2) {
      drag(element);
      done.push(`drags ${name}`);
    } else if (element.matches('input, select, textarea')) {
      fill(/** @type {HTMLInputElement} */ (element));
      done.push(`fills ${name}`);
    } else {
      /** @type {HTMLElement} */ (element).focus();
      /** @type {HTMLElement} */ (element).click();
      done.push(`presses ${name} ${element.textContent?.trim().slice(0, 30)}`);
    }
    await frame();
  }
  return done;
}
