// The sheet of keys, and the single keys that press buttons.
import { byId } from '../kit/elements.js';
import { isEmbedded } from '../kit/host.js';
import { keys as words } from '../words/index.js';

export function createKeys() {
  /** @type {HTMLDialogElement} */
  const dialog = byId('keys');
  /** @type {HTMLInputElement} */
  const allowed = byId('keys-single');
  byId('keys-list').replaceChildren(
    ...[...words.single, ...words.focused].flatMap(([key, meaning]) => {
      const [term, description] = ['dt', 'dd'].map((tag) => document.createElement(tag));
      term.textContent = key;
      description.textContent = meaning;
      return [term, description];
    }),
  );
  byId('keys-button').hidden = false;
  byId('keys-button').addEventListener('click', () => dialog.showModal());
  byId('keys-close').addEventListener('click', () => dialog.close());

  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector('dialog[open]')) return;
    // In a frame they belong to the host until the figure is used.
    if (isEmbedded && event.target === document.body) return;
    if (event.target instanceof Element && event.target.matches('input[type="text"], textarea, select'))
      return;
    if (event.key === '?') dialog.showModal();
    else if (allowed.checked) {
      const found = words.single.find(([key]) => key === letterOf(event));
      const button = found && byId(found[2]);
      // What is not in sight is not pressed.
      if (button?.checkVisibility()) button.click();
    }
  });
}

/** The Latin letter of a key, also where it writes Korean. @param {KeyboardEvent} event */
const letterOf = ({ key, code }) =>
  /^[\x20-\x7e]$/.test(key) ? key : code.replace(/^Key/, '').toLowerCase();
