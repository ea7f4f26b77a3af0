// The sheet on which the controller of the drive on screen is taken away as code.
/** @import { Sheet } from '../../kit/sheet.js' */
/** @import { SheetTools } from '../load.js' */
/** @import { LanguageName } from './languages.js' */
import './style.css';
import { html } from 'lit-html';
import { tryNow } from '../../core/pending.js';
import { copy } from '../../kit/copy.js';
import { download } from '../../kit/download.js';
import { segmentedOf } from '../../kit/fields.js';
import { orSay } from '../../words/errors.js';
import { controllerOf } from './controller.js';
import { languages } from './languages.js';
import { handedAddress } from '../frame-text.js';
import words from './words/index.js';

const { texts } = words;

/** @param {Pick<SheetTools, 'engine' | 'store' | 'links' | 'sceneOf'>} tools @param {Sheet} sheet */
export function createCode({ engine, store, links, sceneOf }, sheet) {
  /** @type {LanguageName} */
  let language = 'python';
  let status = '';

  /** In which the robot drives; a trial of disturbances lets it drive on at the goal, a controller parks. */
  const driven = () => {
    const state = store.get();
    const { experiment, gains } = sceneOf(state);
    const { tolerance } = state.experiment;
    return { experiment: state.trial.disturbance ? { ...experiment, tolerance } : experiment, gains };
  };
  const controller = () => {
    const { experiment, gains } = driven();
    const link = handedAddress(links.linkOf(store.get(), engine.experiment));
    return controllerOf(engine.drive, experiment, gains, { version: engine.version(), link });
  };
  const say = (/** @type {string} */ text) => {
    status = text;
    draw();
  };

  const choose = (/** @type {LanguageName} */ chosen) => {
    language = chosen;
    say('');
  };

  const show = () => {
    const { ending, type, comment, write } = languages[language];
    const taken = controller();
    const file = `${taken.name}.${ending}`;
    const text = write(taken, words.comments);
    sheet.draw(html`
      <p class="muted">${texts.codeHelp}</p>
      <div class="bar">
        ${segmentedOf('code-language', words.languageLegend, words.languages, language, choose)}
        <button id="code-copy" type="button" class="primary"
          @click=${() => copy('code-text', words.copied, words.notCopied).then(say)}>${texts.codeCopy}</button>
        <button id="code-save" type="button" @click=${() => download(file, type, text)}>${texts.codeSave}</button>
      </div>
      <p class="code-file"><code id="code-file" translate="no">${file}</code></p>
      <pre id="code-text" class="code-text" translate="no" tabindex="0" role="region" aria-label=${words.codeLabel(file)}>${tokensOf(
        text,
        comment,
      ).map(([kind, part]) => (kind ? html`<span class=${kind}>${part}</span>` : part))}</pre>
      <p id="code-status" role="status">${status}</p>`);
  };
  const fail = (/** @type {string} */ reason) => sheet.draw(html`<p role="status">${reason}</p>`);
  const draw = () => tryNow(orSay(show, fail), draw);

  return {
    start() {
      status = '';
      sheet.draw(html`<p role="status">${words.computing}</p>`);
      draw();
    },
  };
}

/** A piece of code, and the class of its colour. @typedef {readonly [kind: string, text: string]} Token */

/** The symbols that have a colour everywhere on the page. */
const symbols = { x: 'KX|xe', y: 'KY|ye', theta: 'KTHETA|te', linear: 'v', angular: 'w' };
const kinds = Object.keys(symbols);

/** @param {string} text @param {string} mark of comments @returns {Token[]} */
function tokensOf(text, mark) {
  const groups = Object.entries(symbols).map(([kind, names]) => `(?<${kind}>\\b(?:${names})\\b)`);
  const pattern = new RegExp(
    `(?<comment>"""[^"]*"""|${mark}[^\\n]*)|(?<string>"[^"\\n]*")|${groups.join('|')}`,
    'g',
  );
  /** @type {Token[]} */
  const tokens = [];
  let from = 0;
  for (const match of text.matchAll(pattern)) {
    const groups = match.groups ?? {};
    const kind = ['comment', ...kinds].find((one) => groups[one] !== undefined) ?? '';
    tokens.push(['', text.slice(from, match.index)], [kind, match[0]]);
    from = match.index + match[0].length;
  }
  return [...tokens, ['', text.slice(from)]];
}
