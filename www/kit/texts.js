// The texts that stand in index.html by name alone.

/** Fills in those that are known; what belongs to a part that is not there yet stays empty. @param {Readonly<Record<string, string>>} texts */
export function fillTexts(texts) {
  for (const name of ['data-text', 'data-label', 'data-content'])
    for (const element of document.querySelectorAll(`[${name}]`)) {
      const text = texts[element.getAttribute(name) ?? ''];
      if (text === undefined) continue;
      if (name === 'data-text') element.textContent = text;
      else element.setAttribute(name === 'data-label' ? 'aria-label' : 'content', text);
    }
}
