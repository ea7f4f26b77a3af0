// What a person would call ugly at once, found in the page. It is sent there as text, so it names nothing else.

/** Texts that lie on others or are cut, pictures without room, buttons too narrow to press. @returns {Promise<string[]>} */
export async function cluttered() {
  const later = () => pageFrames.settled();
  await later();
  /** What cuts, by its element, of one look. @type {Map<Element, { overflowX: string, overflowY: string, textOverflow: string, room: DOMRect } | null>} */
  const cutting = new Map();
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

  /** @param {Element} element */
  function cutOf(element) {
    let cut = cutting.get(element);
    if (cut === undefined) {
      const { overflowX, overflowY, textOverflow } = getComputedStyle(element);
      const isOpen = overflowX === 'visible' && overflowY === 'visible';
      cut = isOpen ? null : { overflowX, overflowY, textOverflow, room: element.getBoundingClientRect() };
      cutting.set(element, cut);
    }
    return cut;
  }

  /** What is left of a box in what scrolls or clips around it, and who cuts it for good. @param {Element} element @param {DOMRect} box */
  function within(element, box) {
    let { left, right, top, bottom } = box;
    /** @type {Element | null} */
    let cutter = null;
    for (let at = element.parentElement; at && at !== document.body; at = at.parentElement) {
      const cut = cutOf(at);
      if (!cut) continue;
      const { overflowX, overflowY, textOverflow, room } = cut;
      const cuts = (/** @type {string} */ overflow) => overflow === 'hidden' || overflow === 'clip';
      const isCutAcross =
        cuts(overflowX) && textOverflow !== 'ellipsis' && (left < room.left - 2 || right > room.right + 2);
      const isCutDown = cuts(overflowY) && (top < room.top - 5 || bottom > room.bottom + 5);
      if (isCutAcross || isCutDown) cutter ??= at;
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
    cutting.clear();
    const { scrollWidth, clientWidth } = document.documentElement;
    if (scrollWidth > clientWidth) all.add(`the page is ${scrollWidth} px wide`);

    /** @type {(Box & { text: string, element: Element, place: number, isSeen: boolean })[]} */
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
        const [top, bottom] = [seen.top + lead, seen.bottom - lead];
        texts.push({ ...seen, top, bottom, text, element, place: texts.length, isSeen: false });
      }
    }
    for (const one of texts) {
      const [x, y] = [(one.left + one.right) / 2, (one.top + one.bottom) / 2];
      one.isSeen = x >= 0 && y >= 0 && x <= innerWidth && y <= innerHeight;
      if (!one.isSeen) continue;
      const covers = document.elementFromPoint(x, y);
      one.isSeen = !hides(covers, one.element);
      if (
        getComputedStyle(one.element).pointerEvents !== 'none' &&
        covers?.matches('canvas, svg *, svg') &&
        // A picture may have its name on it.
        !covers.contains(one.element) &&
        !covers.closest('button, label, li, figure')?.contains(one.element)
      )
        all.add(`“${one.text}” lies under ${nameOf(covers)}`);
    }
    // Who begins below another ends lies on nothing of it. Of two the first in the document has to be seen.
    const down = [...texts].sort((a, b) => a.top - b.top);
    for (const [i, one] of down.entries())
      for (let j = i + 1; j < down.length && down[j].top < one.bottom - 2; j += 1) {
        const other = down[j];
        const [first, last] = one.place < other.place ? [one, other] : [other, one];
        const across = Math.min(one.right, other.right) - Math.max(one.left, other.left);
        const deep = Math.min(one.bottom, other.bottom) - other.top;
        if (across > 2 && deep > 2 && first.isSeen && one.element !== other.element)
          all.add(`“${first.text}” and “${last.text}” lie on each other`);
      }
    for (const [selector, wide, high] of /** @type {const} */ ([
      ['.stage, [data-picture]:not(p):has(canvas, svg:not(.swatch))', 80, 48],
      ['button:not(.handle), select', 24, 20],
    ]))
      for (const element of document.querySelectorAll(selector)) {
        const { width, height } = element.getBoundingClientRect();
        if (isSeen(element) && (width < wide || height < high))
          all.add(`${nameOf(element)} has ${Math.round(width)} × ${Math.round(height)} px`);
      }
    return [...all];
  }
}
