// The sheet on which the program checks its own numbers, in this browser.
import golden from '../../../tests/golden.json';
import { byId, create } from '../../kit/elements.js';
import { messageOf } from '../../words/errors.js';
import { checks as words } from '../../words/index.js';
import { browserOf } from './browser.js';
import { groupNames } from '../../core/checks/check.js';
import { allResults } from '../../core/checks/run.js';

/** @typedef {import('../../core/engine.js').Engine} Engine */
/** @typedef {import('../../core/checks/check.js').Golden} Golden */
/** @typedef {import('../../core/checks/check.js').Result} Result */

const known = /** @type {Golden} */ (/** @type {unknown} */ (golden));

/** Whose openers, in other sheets, are closed for it. */
const openers = ['keys-checks', 'keep-checks'];

/** @param {Engine} engine */
export function createChecks(engine) {
  /** @type {HTMLDialogElement} */
  const dialog = byId('checks');
  const [summary, list, copy, copied] = ['summary', 'list', 'copy', 'copied'].map((name) =>
    byId(`checks-${name}`),
  );
  /** @type {HTMLTextAreaElement} */
  const text = byId('checks-text');
  /** @type {HTMLProgressElement} */
  const progress = byId('checks-progress');
  let control = new AbortController();

  /** @param {boolean} isRunning */
  const showRunning = (isRunning) => {
    progress.hidden = !isRunning;
    list.hidden = copy.hidden = isRunning;
    copied.hidden = text.hidden = true;
  };

  async function start() {
    control.abort();
    control = new AbortController();
    const { signal } = control;
    progress.value = 0;
    summary.textContent = words.checking;
    summary.classList.remove('failed');
    byId('checks-about').textContent = words.about(engine.version(), browserOf(navigator.userAgent));
    showRunning(true);
    try {
      const began = performance.now();
      const groups = await allResults(engine, known, {
        signal,
        onProgress: (done) => (progress.value = done),
      });
      show(groups, performance.now() - began);
    } catch (error) {
      if (signal.aborted) return;
      summary.textContent = words.unfinished(messageOf(error));
      summary.classList.add('failed');
      progress.hidden = true;
    }
  }

  /** @param {Result[][]} groups @param {number} milliseconds */
  function show(groups, milliseconds) {
    const all = groups.flat();
    const failed = all.filter(({ passed }) => !passed).length;
    summary.textContent = words.summary(failed, all.length, milliseconds);
    summary.classList.toggle('failed', failed > 0);
    list.replaceChildren(...groups.flatMap(sectionOf));
    text.value = textOf(groups, [summary.textContent, words.about(engine.version(), navigator.userAgent)]);
    showRunning(false);
    list.scrollTop = 0;
    list.querySelector('.failed')?.scrollIntoView({ block: 'nearest' });
  }

  for (const id of openers)
    byId(id).addEventListener('click', () => {
      byId(id).closest('dialog')?.close();
      dialog.showModal();
      start();
    });
  byId('checks-close').addEventListener('click', () => dialog.close());
  // The event comes late: the sheet may be open again.
  dialog.addEventListener('close', () => {
    if (!dialog.open) control.abort();
  });
  copy.addEventListener('click', async () => {
    copied.hidden = false;
    try {
      await navigator.clipboard.writeText(text.value);
      copied.textContent = words.copied;
    } catch {
      copied.textContent = words.notCopied;
      text.hidden = false;
      text.focus();
      text.select();
    }
  });
}

/** What a result says in words: the law, what was measured, what must come out, and what did. @param {Result} result */
export function wordsOf(result) {
  const sentence = /** @type {(...about: any[]) => import('../../core/checks/check.js').Said} */ (
    words.sentences[result.name]
  );
  const [law, measure] = sentence(...result.about);
  return {
    law,
    measure,
    verdict: words.verdict(result.passed),
    expected: words.expectedText(result),
    found: words.valuesText(result.found, result),
  };
}

/** @param {Result[]} results @param {number} group */
function sectionOf(results, group) {
  return [
    create('h3', '', words.groups[groupNames[group]]),
    create('ul', 'checks-group', ...results.map(rowOf)),
  ];
}

/** @param {Result} result */
function rowOf(result) {
  const { law, measure, verdict, expected, found } = wordsOf(result);
  const mark = create('span', 'checks-mark', result.passed ? '✓' : '✗');
  mark.setAttribute('aria-hidden', 'true');
  return create(
    'li',
    result.passed ? 'passed' : 'failed',
    create('span', 'checks-verdict', mark, ` ${verdict}`),
    ' ',
    create('span', 'checks-law', law),
    ' ',
    create(
      'span',
      'checks-values',
      `${measure}: ${words.expectedWord} `,
      create('b', '', expected),
      `, ${words.foundWord} `,
      create('b', 'checks-found', found),
    ),
  );
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
