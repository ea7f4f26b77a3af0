/** @typedef {import('../harness/browsers.js').Page} Page */

/** At each of these sizes, of which the last is a wide one: makes every text on the page 40 % longer, says what then finds no place, and takes it back. @param {Page} page @param {string} where */
export const overflowing = (page, where) =>
  page.evaluate(
    async (place, sizes) => {
      for (const details of document.querySelectorAll('details')) details.open = true;
      /** What is longer, what it then says, and what it said. @type {Map<Node, { longer: string, own: string | null }>} */
      const texts = new Map();
      /** @type {string[]} */
      const problems = [];
      // Beginning with the size that it has.
      const order = sizes[0][0] === innerWidth ? sizes : [...sizes].reverse();
      for (const [width, height] of order) {
        Object.assign(/** @type {object} */ (frameElement), { width, height });
        // The page learns its size, then draws for it.
        await pageFrames.settled();
        lengthen();
        // Pictures follow the new size within some frames.
        let found = [...whatHasNoPlace(width)];
        for (let i = 0; i < 30 && found.length > 0; i += 1) {
          await pageFrames.settled();
          found = [...whatHasNoPlace(width)];
        }
        for (const problem of found) problems.push(`${place} at ${width} × ${height}: ${problem}`);
      }
      for (const [node, { longer, own }] of texts) if (node.nodeValue === longer) node.nodeValue = own;
      return problems;

      function lengthen() {
        const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        while (walker.nextNode()) {
          const node = walker.currentNode;
          const { nodeValue: own } = node;
          if (texts.get(node)?.longer === own) continue;
          const text = (own ?? '').trim();
          // Korean has words of two letters.
          if (!/\p{L}{3}|\p{Script=Hangul}{2}/u.test(text)) continue;
          const longer = `${text}${text.slice(0, Math.ceil(0.4 * text.length))}`;
          node.nodeValue = longer;
          texts.set(node, { longer, own });
        }
      }

      /** @param {number} width */
      function* whatHasNoPlace(width) {
        const { clientWidth, scrollWidth: whole } = document.documentElement;
        if (clientWidth > width || innerWidth !== width) yield `the window is ${innerWidth} px wide`;
        if (whole > clientWidth) {
          const last = [...document.body.querySelectorAll('*')].filter(
            (element) => Math.ceil(element.getBoundingClientRect().right) >= whole,
          );
          const name = last.map(({ tagName, id, className }) => `${tagName}#${id}.${className}`).join(', ');
          yield `the page is ${whole} px wide: ${name}`;
        }
        const scrolling =
          'nav, .generation-scroll, .curves-scroll, .luck-scroll, .lesson-scroll, .table-scroll';
        for (const face of document.querySelectorAll('button, .segmented span, nav a, #language')) {
          if (!face.checkVisibility() || !face.textContent?.trim()) continue;
          // What is only read aloud has no place to find.
          const end = face.querySelector('span:not(.symbol)');
          const range = document.createRange();
          range.selectNodeContents(face);
          if (end && getComputedStyle(end).clipPath !== 'none') range.setEndBefore(end);
          const [text, box] = [range.getBoundingClientRect(), face.getBoundingClientRect()];
          const cut = text.left < box.left - 1 || text.right > box.right + 1;
          if (cut || (!face.closest(scrolling) && (text.left < 0 || text.right > clientWidth)))
            yield `${face.id || face.parentElement?.id || face.className}: ${face.textContent}`;
        }
        for (const box of document.querySelectorAll('select, .bar, .heading, .segmented, p, ul, table')) {
          const { left, right } = box.getBoundingClientRect();
          if (box.closest(`${scrolling}, .visually-hidden`) || !box.checkVisibility()) continue;
          if (left < -1 || right > clientWidth + 1) yield `${box.id || box.className} ends at ${right}`;
        }
      }
    },
    where,
    /** @type {const} */ ([
      [1440, 900],
      [390, 844],
      [1024, 768],
    ]),
  );
