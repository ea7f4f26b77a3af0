// The sheet on which the program checks its own numbers, in this browser.
/** @import { Golden, Result, Said } from '../../core/checks/check.js' */
/** @import { Engine } from '../../core/engine.js' */
/** @import { Sheet } from '../../kit/sheet.js' */
import './style.css';
import { html, nothing } from 'lit-html';
import golden from '../../../tests/golden.json';
import { groupNames } from '../../core/checks/check.js';
import { allResults } from '../../core/checks/run.js';
import { copy } from '../../kit/copy.js';
import { byId } from '../../kit/elements.js';
import { messageOf } from '../../words/errors.js';
import { browserOf } from './browser.js';
import words from './words/index.js';

const { texts } = words;
const known = /** @type {Golden} */ (/** @type {unknown} */ (golden));

/**
 * @typedef {object} Run What is known of the checks that were begun last.
 * @property {string} summary
 * @property {boolean} isBad
 * @property {number | null} share How much is done; null: it has ended.
 * @property {Result[][]} groups
 * @property {number} [milliseconds]
 * @property {string} copied What is said of the copy.
 */

/** @param {Engine} engine @param {Sheet} sheet */
export function createChecks(engine, sheet) {
  const version = engine.version();
  let control = new AbortController();
  /** @type {Run} */
  let run = { summary: '', isBad: false, share: null, groups: [], copied: '' };
  const update = (/** @type {Partial<Run>} */ patch) => {
    run = { ...run, ...patch };
    sheet.draw(contentOf(run, version, onCopy));
  };
  const onCopy = async () => {
    const copied = await copy('checks-text', words.copied, words.notCopied);
    update({ copied });
    // Shown, it can be copied by hand.
    const field = /** @type {HTMLTextAreaElement} */ (byId('checks-text'));
    field.focus();
    field.select();
  };
  // The event comes late: the sheet may be open again.
  sheet.dialog.addEventListener('close', () => {
    if (!sheet.dialog.open) control.abort();
  });

  return {
    async start() {
      control.abort();
      control = new AbortController();
      const { signal } = control;
      update({ summary: words.checking, isBad: false, share: 0, groups: [], copied: '' });
      try {
        const began = performance.now();
        const onProgress = (/** @type {number} */ share) => update({ share });
        const groups = await allResults(engine, known, { signal, onProgress });
        const all = groups.flat();
        const failed = all.filter(({ passed }) => !passed).length;
        const summary = words.summary(failed, all.length, performance.now() - began);
        update({ summary, isBad: failed > 0, share: null, groups });
        byId('checks-list').scrollTop = 0;
        sheet.dialog.querySelector('li.failed')?.scrollIntoView({ block: 'nearest' });
      } catch (error) {
        if (!signal.aborted)
          update({ summary: words.unfinished(messageOf(error)), isBad: true, share: null });
      }
    },
  };
}

/** @param {Run} run @param {string} version @param {() => void} onCopy */
function contentOf({ summary, isBad, share, groups, copied }, version, onCopy) {
  const isDone = groups.length > 0;
  const text = isDone ? textOf(groups, [summary, words.about(version, navigator.userAgent)]) : '';
  return html`
    <p class="muted">${texts.checksHelp}</p>
    <div class="bar checks-bar">
      <p id="checks-summary" class="checks-summary ${isBad ? 'failed' : ''}" role="status">${summary}</p>
      <button id="checks-copy" type="button" .hidden=${!isDone} @click=${onCopy}>${texts.checksCopy}</button>
      <progress id="checks-progress" max="1" aria-label=${texts.checksProgress} .hidden=${share === null} value=${share ?? nothing}></progress>
    </div>
    <p id="checks-copied" class="muted" role="status" .hidden=${copied === ''}>${copied}</p>
    <textarea id="checks-text" class="checks-text" readonly aria-label=${texts.checksText}
      .hidden=${copied !== words.notCopied} .value=${text}></textarea>
    <div id="checks-list" class="table-scroll" tabindex="0" role="group" aria-label=${texts.checksList} .hidden=${!isDone}>${groups.map(
      (results, group) =>
        html`<h3>${words.groups[groupNames[group]]}</h3><ul class="checks-group">${results.map(rowOf)}</ul>`,
    )}</div>
    <p id="checks-about" class="muted">${words.about(version, browserOf(navigator.userAgent))}</p>`;
}

/** What a result says in words: the law, what was measured, what must come out, and what did. @param {Result} result */
function wordsOf(result) {
  const sentence = /** @type {(...about: any[]) => Said} */ (words.sentences[result.name]);
  const [law, measure] = sentence(...result.about);
  return {
    law,
    measure,
    verdict: words.verdict(result.passed),
    expected: words.expectedText(result),
    found: words.valuesText(result.found, result),
  };
}

/** @param {Result} result */
function rowOf(result) {
  const { law, measure, verdict, expected, found } = wordsOf(result);
  return html`<li class=${result.passed ? 'passed' : 'failed'}>
    <span class="checks-verdict"><span class="checks-mark" aria-hidden="true">${result.passed ? '✓' : '✗'}</span> ${verdict}</span>
    <span>${law}</span>
    <span class="checks-values muted">${measure}: ${words.expectedWord} <b>${expected}</b>, ${words.foundWord} <b class="checks-found">${found}</b></span>
  </li>`;
}

/** All of it as plain text, for a report. @param {Result[][]} groups @param {string[]} head */
function textOf(groups, head) {
  const lines = groups.flatMap((results, group) => [
    '',
    words.groups[groupNames[group]],
    ...results.map((result) => {
      const { law, measure, verdict, expected, found } = wordsOf(result);
      return `${verdict}: ${law} ${measure}: ${words.expectedWord} ${expected}, ${words.foundWord} ${found}`;
    }),
  ]);
  return `${[...head, ...lines].join('\n')}\n`;
}
