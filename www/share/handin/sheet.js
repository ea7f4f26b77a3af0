// The sheet on which an exercise is handed in: who it is, once, and then the receipt.
/** @import { Receipt } from './receipt.js' */
/** @import { WorkTools } from './work.js' */
import { seenText } from '../../kit/text.js';
import { html, nothing } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { copy } from '../../kit/copy.js';
import { download } from '../../kit/download.js';
import { isEmbedded } from '../../kit/host.js';
import { createSheet } from '../../kit/sheet.js';
import { onEnter, selectAll } from '../../kit/templates.js';
import { mostOfWho } from '../../run/variant.js';
import { messageOf } from '../../words/errors.js';
import { handedAddress } from '../frame-text.js';
import { receiptOf } from './receipt.js';
import words from './words/index.js';

const { texts } = words;

/** A receipt, as text and with its whole address. @typedef {{ receipt: Receipt, text: string, address: string }} HandedIn */

/** @param {WorkTools} tools */
export function createHandInSheet(tools) {
  const { store, actions, answersOf, onHandIn } = tools;
  const sheet = createSheet('handin', 'handin', texts.title, texts.close);
  /** @type {HandedIn | null} */
  let handed = null;
  let status = '';
  let typed = '';
  const say = (/** @type {string} */ text) => {
    status = text;
    draw();
  };

  /** Of the one that is made; a sheet that is closed gives it up. */
  let number = 0;
  const make = async () => {
    number += 1;
    const own = number;
    const isWanted = () => own === number && sheet.dialog.open;
    handed = null;
    say(texts.computing);
    try {
      await actions.whenIdle();
      if (!isWanted()) return;
      const state = store.get();
      const receipt = await receiptOf(tools, state, answersOf(state));
      if (!isWanted()) return;
      const address = handedAddress(receipt.link);
      handed = { receipt, address, text: words.receiptText(receipt, address) };
      say(texts.made);
      onHandIn(handed);
    } catch (error) {
      if (isWanted()) say(words.failed(messageOf(error)));
    }
  };

  const on = {
    /** A receipt is one person's. @param {Event & { target: HTMLInputElement }} event */
    type({ target }) {
      typed = target.value;
      number += 1;
      handed = null;
      say('');
    },
    name() {
      const field = /** @type {HTMLInputElement} */ (document.getElementById('handin-who'));
      const who = field.readOnly ? store.get().student.who : seenText(field.value);
      if (!who) return field.focus();
      typed = who;
      actions.setWho(who);
      make();
    },
    copyText: () => copy('handin-text', words.copied, words.notCopied).then(say),
    copyLink: () => copy('handin-link', words.copied, words.notCopied).then(say),
    save: () => handed && download(words.fileName(handed.receipt.who), 'text/plain', `${handed.text}\n`),
  };

  const draw = () => sheet.draw(contentOf(store.get(), typed, handed, status, on));

  return {
    open() {
      actions.pauseEvolution();
      number += 1;
      handed = null;
      status = '';
      typed = store.get().student.who;
      draw();
      sheet.open();
      if (store.get().student.who) make();
    },
  };
}

/** @param {import('../../run/state.js').State} state @param {string} typed @param {HandedIn | null} handed @param {string} status @param {{ type: (event: Event & { target: HTMLInputElement }) => void, name: () => void, copyText: () => void, copyLink: () => void, save: () => void }} on */
function contentOf({ exercise, student: { who } }, typed, handed, status, on) {
  const isDrawn = exercise.vary.length > 0 && who !== '';
  return html`
  <div class="bar handin-name">
    <label for="handin-who">${texts.whoLabel}</label>
    <input id="handin-who" type="text" maxlength=${mostOfWho} autocomplete="off" autofocus .value=${live(typed)}
      .readOnly=${isDrawn} aria-describedby=${isDrawn ? 'handin-drawn' : nothing} @input=${on.type} @keydown=${onEnter(on.name)}>
    <button id="handin-make" type="button" @click=${on.name} class=${handed ? '' : 'primary'}>${texts.make}</button>
  </div>
  ${isDrawn ? html`<p id="handin-drawn" class="muted">${texts.whoDrawn}</p>` : nothing}
  ${
    handed
      ? html`<div class="bar">
          <button id="handin-copy" type="button" class="primary" @click=${on.copyText}>${texts.copyText}</button>
          <button id="handin-copy-link" type="button" @click=${on.copyLink}>${texts.copyLink}</button>
          <button id="handin-save" type="button" @click=${on.save}>${texts.save}</button>
        </div>`
      : html`<p class="muted">${texts.whoHelp}</p>`
  }
  <p id="handin-status" role="status">${status}</p>
  ${
    handed
      ? html`<textarea id="handin-text" rows="9" readonly spellcheck="false" aria-label=${texts.text} .value=${live(handed.text)} @focus=${selectAll}></textarea>
        <input id="handin-link" type="text" readonly aria-label=${texts.link} .value=${live(handed.address)} @focus=${selectAll}>
        <p class="muted">${isEmbedded ? texts.helpWithin : texts.help} ${texts.proves}</p>`
      : nothing
  }`;
}
