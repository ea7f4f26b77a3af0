// The sheet of keys, and the single keys that press buttons.
import { html } from 'lit-html';
import { byId, isSeen } from '../kit/elements.js';
import { checkOf } from '../kit/fields.js';
import { isEmbedded } from '../kit/host.js';
import { letterOf } from '../kit/keyboard.js';
import { createSheet } from '../kit/sheet.js';
import { withStorage } from '../kit/tab.js';
import { keys as words, opening } from '../words/index.js';

const { texts } = words;

/** Whoever needs them off, as with speech input, says so once: the page may load itself again. */
const name = 'ep-locomotion keys';
const off = 'off';

/** @param {() => void} openChecks */
export function createKeys(openChecks) {
  let areAllowed = withStorage((storage) => storage.getItem(name)) !== off;
  const sheet = createSheet('keys', '', texts.keysTitle, opening.texts.close);
  const check = () => {
    sheet.dialog.close();
    openChecks();
  };
  const allow = (/** @type {boolean} */ isOn) => {
    areAllowed = isOn;
    withStorage((storage) => storage.setItem(name, areAllowed ? '' : off));
    fill();
  };
  const fill = () =>
    sheet.draw(html`
      <p class="muted">${texts.keysEverywhere}</p>
      <dl id="keys-list" class="keys-list">${[...words.single.filter(buttonOf), ...words.focused].map(
        ([key, meaning]) => html`<dt>${key}</dt><dd>${meaning}</dd>`,
      )}</dl>
      ${checkOf('keys-single', texts.keysSingle, areAllowed, allow)}
      <p class="sheet-foot"><button id="keys-checks" type="button" @click=${check}>${opening.texts.checksButton}</button></p>`);
  const open = () => {
    fill();
    sheet.open();
  };
  byId('keys-button').hidden = false;
  byId('keys-button').addEventListener('click', open);

  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector('dialog[open]')) return;
    // In a frame they belong to the host until the figure is used.
    if (isEmbedded && event.target === document.body) return;
    if (event.target instanceof Element && event.target.matches('input[type="text"], textarea, select'))
      return;
    if (event.key === '?') open();
    else if (areAllowed) {
      const found = words.single.find(([key]) => key.toLowerCase() === letterOf(event));
      const button = found && buttonOf(found);
      if (!button || event.defaultPrevented) return;
      if (scrolls(found) ? isOfOthers(event) : event.shiftKey) return;
      // Held, a switch would go to and fro.
      if (event.repeat && !steps(found)) return;
      if (scrolls(found)) event.preventDefault();
      button.click();
    }
  });
}

/** @typedef {typeof words.single[number]} Row */

/** What is no letter scrolls, as everywhere, where there is more of the page above or below. @param {Row} row */
const scrolls = ([key]) => key.length > 1;

/** What is pressed again and again while its key is held. @param {Row} row */
const steps = (row) => scrolls(row) || 'nb'.includes(row[0]);

/** Who has such keys itself. */
const having =
  'input:not([type="radio"], [type="checkbox"]), textarea, select, [role="slider"], [role="application"]';

/** Whether such a key still moves what has the focus, what scrolls around that, or the page. @param {KeyboardEvent} event */
function isOfOthers({ key, target }) {
  let at = target instanceof Element ? target : null;
  if (at?.matches(having)) return true;
  while (at && !hasRoom(at, key)) at = at.parentElement;
  return at !== null;
}

/** @param {Element} element @param {string} key */
function hasRoom(element, key) {
  const { scrollTop, scrollHeight, clientHeight } = element;
  if ((key === 'PageUp' ? scrollTop : scrollHeight - clientHeight - scrollTop) < 1) return false;
  return element === document.documentElement || /auto|scroll/.test(getComputedStyle(element).overflowY);
}

/** What a key presses: what is not in sight is not pressed. @param {Row} row */
function buttonOf([, , id]) {
  /** @type {NodeListOf<HTMLElement>} */
  const all = document.querySelectorAll(`#${id}, [data-key-of="${id}"]`);
  return [...all].find((button) => isSeen(button) && !button.closest('[inert]'));
}
