// What a person would call ugly at once, found in the page. It is sent there as text, so it names nothing else.

/** Texts that lie on others or are cut, pictures without room, buttons too narrow to press. @returns {Promise<string[]>} */
export async function cluttered() {
  // Pictures follow a new size within some frames.
  const later = () => new Promise((resolve) => requestAnimationFrame(resolve));
  for (let i = 0; i < 3; i += 1) await later();
  // What a worker computes has its texts when it is there.
  while ([...document.querySelectorAll('progress')].some((bar) => isSeen(bar))) await later();
  let found = flaws();
  for (let i = 0; i < 30 && found.length > 0; i += 1) {
    await later();
    found = flaws();
  }
  return found;

  /** @typedef {{ left: number, right: number, top: number, bottom: number }} Box */

  /** @param {Element} element */
  function isSeen(element) {
    return (
      element.checkVisibility({ opacityProperty: true, visibilityProperty: true }) &&
      !element.closest('.visually-hidden, [aria-hidden="true"] *, option, script, style, math') &&
      ![element, element.parentElement].some((one) => one && getComputedStyle(one).clipPath !== 'none')
    );
  }

  /** What is left of a box in what scrolls or clips around it, and who cuts it for good. @param {Element} element @param {DOMRect} box */
  function within(element, box) {
    let { left, right, top, bottom } = box;
    /** @type {Element | null} */
    let cutter = null;
    for (
      let around = element.parentElement;
      around && around !== document.body;
      around = around.parentElement
    ) {
      const { overflowX, overflowY, textOverflow } = getComputedStyle(around);
      if (overflowX === 'visible' && overflowY === 'visible') continue;
      const room = around.getBoundingClientRect();
      const cuts = (/** @type {string} */ overflow) => overflow === 'hidden' || overflow === 'clip';
      const isCutAcross =
        cuts(overflowX) && textOverflow !== 'ellipsis' && (left < room.left - 2 || right > room.right + 2);
      const isCutDown = cuts(overflowY) && (top < room.top - 5 || bottom > room.bottom + 5);
      if (isCutAcross || isCutDown) cutter ??= around;
      [left, right] = [Math.max(left, room.left), Math.min(right, room.right)];
      [top, bottom] = [Math.max(top, room.top), Math.min(bottom, room.bottom)];
    }
    return { left, right, top, bottom, cutter };
  }

  /** What scrolls under a head or a foot that stays is out of sight. @param {Element | null} top @param {Element} element */
  function hides(top, element) {
    for (
      let cover = top;
      cover && !cover.contains(element) && !element.contains(cover);
      cover = cover.parentElement
    )
      if (getComputedStyle(cover).backgroundColor !== 'rgba(0, 0, 0, 0)') return true;
    return false;
  }

  /** @param {Element} element */
  function nameOf({ tagName, id, classList }) {
    return `${tagName.toLowerCase()}${id ? `#${id}` : ''}${[...classList].map((name) => `.${name}`).join('')}`;
  }

  function flaws() {
    /** @type {Set<string>} */
    const all = new Set();
    const { scrollWidth, clientWidth } = document.documentElement;
    if (scrollWidth > clientWidth) all.add(`the page is ${scrollWidth} px wide`);

    /** @type {(Box & { text: string, element: Element })[]} */
    const texts = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const range = document.createRange();
    while (walker.nextNode()) {
      const text = (walker.currentNode.nodeValue ?? '').trim();
      const element = walker.currentNode.parentElement;
      if (!text || !element || !isSeen(element)) continue;
      range.selectNodeContents(walker.currentNode);
      for (const box of range.getClientRects()) {
        const { cutter, ...seen } = within(element, box);
        if (seen.right - seen.left < 3 || seen.bottom - seen.top < 3) continue;
        if (cutter && !cutter.closest('svg')) all.add(`“${text}” is cut by ${nameOf(cutter)}`);
        const lead = (seen.bottom - seen.top) * 0.25;
        texts.push({ ...seen, top: seen.top + lead, bottom: seen.bottom - lead, text, element });
      }
    }
    for (const [i, one] of texts.entries()) {
      const [x, y] = [(one.left + one.right) / 2, (one.top + one.bottom) / 2];
      if (x < 0 || y < 0 || x > innerWidth || y > innerHeight) continue;
      const covers = document.elementFromPoint(x, y);
      const isHidden = hides(covers, one.element);
      const isOverlay = getComputedStyle(one.element).pointerEvents === 'none';
      if (
        !isOverlay &&
        covers?.matches('canvas, svg *, svg') &&
        // A picture may have its name on it.
        !covers.contains(one.element) &&
        !covers.closest('button, label, li, figure')?.contains(one.element)
      )
        all.add(`“${one.text}” lies under ${nameOf(covers)}`);
      for (const other of texts.slice(i + 1)) {
        const [across, down] = [
          Math.min(one.right, other.right) - Math.max(one.left, other.left),
          Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top),
        ];
        if (across > 2 && down > 2 && !isHidden && one.element !== other.element)
          all.add(`“${one.text}” and “${other.text}” lie on each other`);
      }
    }
    for (const picture of document.querySelectorAll(
      '.stage, [data-picture]:not(p):has(canvas, svg:not(.swatch))',
    )) {
      if (!isSeen(picture)) continue;
      const { width, height } = picture.getBoundingClientRect();
      if (width < 80 || height < 48)
        all.add(`${nameOf(picture)} has ${Math.round(width)} × ${Math.round(height)} px`);
    }
    for (const button of document.querySelectorAll('button:not(.handle), select')) {
      if (!isSeen(button)) continue;
      const { width, height } = button.getBoundingClientRect();
      if (width < 24 || height < 20)
        all.add(`${nameOf(button)} has ${Math.round(width)} × ${Math.round(height)} px`);
    }
    return [...all];
  }
}
