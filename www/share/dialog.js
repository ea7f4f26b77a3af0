// The sheet that keeps what is on screen: as a link, a frame, an exercise, a file, pictures and tables.
/** @import { Sheet } from '../kit/sheet.js' */
/** @import { SheetTools } from './load.js' */
/** @import { Picture } from './pictures.js' */
import './style.css';
import { html } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { whenThere } from '../core/pending.js';
import { copy } from '../kit/copy.js';
import { download } from '../kit/download.js';
import { addressOf } from '../kit/host.js';
import { choicesOf } from '../kit/segmented.js';
import { selectAll } from '../kit/templates.js';
import { messageOf } from '../words/errors.js';
import { opening } from '../words/index.js';
import { sizes } from '../embed/frame.js';
import { driveCsv, driveOrigin, generationsCsv } from './csv.js';
import { fingerprintOf } from './code/fingerprint.js';
import { createMaker } from './exercise/maker.js';
import { frameOf, isOnDisk } from './frame-text.js';
import { descriptionOf, drawingOf, picturesOnScreen } from './pictures.js';
import { pngOf } from './png.js';
import { openRunFile, runFile } from './run-file.js';
import { svgOf } from './svg.js';
import words from './words/index.js';

const { texts } = words;

const kinds = /** @type {const} */ ([
  ['png', 'image/png', pngOf],
  ['svg', 'image/svg+xml', svgOf],
]);
const frames = sizes.map((size) => ({ value: size.join('x'), text: words.sizeText(size[0], size[1]), size }));

/** @param {SheetTools} tools @param {Sheet} sheet */
export function createKeep(tools, sheet) {
  const { engine, store, actions, links, openChecks, openCode, openCollect } = tools;
  const maker = createMaker(tools);
  let status = '';
  let frame = frames[1];
  /** @type {Picture[]} */
  let pictures = [];

  const linkNow = () => links.linkOf(store.get(), engine.experiment);
  const address = () => addressOf(location.href, linkNow(), false);
  const say = (/** @type {string} */ text) => {
    status = text;
    draw();
  };

  const show = (text = words.fingerprint(engine.hash(), store.get().history.length - 1)) => {
    pictures = picturesOnScreen();
    say(text);
    sheet.open();
  };

  /** As it is, and once more when what was set has begun. */
  const start = () => {
    show();
    const again = () => sheet.dialog.open && show();
    if (store.get().computing) actions.whenIdle().then(again);
  };

  let reading = new AbortController();
  sheet.dialog.addEventListener('close', () => reading.abort());

  /** Only the newest that is chosen is opened, and only as long as somebody waits for it. @param {File} file */
  const open = async (file) => {
    reading.abort();
    reading = new AbortController();
    const { signal } = reading;
    say(words.reading);
    try {
      const { opened, generations } = await openRunFile(await file.text(), engine, links, signal);
      if (signal.aborted) return;
      tools.open(opened, [], generations);
      show(words.opened(file.name, generations));
    } catch (error) {
      if (!signal.aborted) show(words.notOpened(file.name, messageOf(error)));
    }
  };

  const insteadOfIt = (/** @type {() => void} */ open) => () => {
    sheet.dialog.close();
    open();
  };
  const on = {
    ...createSaving(tools, sheet.dialog, address, say),
    /** @param {string} value */
    chooseFrame(value) {
      frame = frames.find((one) => one.value === value) ?? frame;
      draw();
    },
    copyLink: () => copy('keep-link', words.copied, words.notCopied).then(say),
    copyFrame: () => copy('embed-text', words.textCopied, words.textNotCopied).then(say),
    makeExercise: insteadOfIt(maker.open),
    collect: insteadOfIt(openCollect),
    /** @param {Event} event */
    choose({ target }) {
      const input = /** @type {HTMLInputElement} */ (target);
      const [chosen] = input.files ?? [];
      input.value = '';
      if (chosen) open(chosen);
    },
    takeCode: insteadOfIt(openCode),
    check: insteadOfIt(openChecks),
  };

  const draw = () => {
    const frameText = frameOf(store.get(), linkNow(), frame.size);
    sheet.draw(contentOf({ address: address(), frame, frameText, pictures, status }, on));
  };

  return { start, open, drawMaker: maker.draw };
}

/** What is saved as a file, each with the name of the run. @param {SheetTools} tools @param {HTMLDialogElement} dialog @param {() => string} address @param {(text: string) => void} say */
function createSaving({ engine, store, links, sceneOf }, dialog, address, say) {
  const origin = () => words.origin(engine.version(), address());
  const name = () => words.fileName(store.get().experiment.evolution.seed, store.get().generation);
  const saveCsv = (/** @type {string} */ what, /** @type {string} */ content) =>
    download(`${name()}-${what}.csv`, 'text/csv', content);
  const saveDrive = () => {
    const { experiment, gains, driving } = sceneOf(store.get());
    const about = [...origin(), ...driveOrigin(experiment, gains, driving)];
    const table = driveCsv(driving, engine.stability(experiment, gains), about);
    saveCsv(`drive-${fingerprintOf(experiment, gains)}`, table);
  };
  return {
    saveRun: () => download(`${name()}.json`, 'application/json', runFile(store.get(), engine, links)),
    saveGenerations: () => saveCsv('generations', generationsCsv(store.get().history, origin())),
    /** A long drive is read by a worker. */
    saveDrive: () => whenThere(saveDrive, () => dialog.open),
    /** @param {Picture} picture @param {typeof kinds[number]} kind */
    async savePicture(picture, [ending, type, write]) {
      try {
        const [version, link] = origin();
        const about = { title: picture.name, description: descriptionOf(picture), link, version };
        const content = await write(drawingOf(picture), about);
        download(`${name()}-${picture.key}.${ending}`, type, content);
      } catch (error) {
        say(words.pictureNotSaved(picture.name, messageOf(error)));
      }
    },
  };
}

/**
 * @typedef {Record<'copyLink' | 'copyFrame' | 'makeExercise' | 'collect' | 'saveRun' | 'saveGenerations' | 'saveDrive' | 'takeCode' | 'check', () => void>
 *   & { chooseFrame: (value: string) => void, choose: (event: Event) => void, savePicture: (picture: Picture, kind: typeof kinds[number]) => void }} Events
 */

/** @param {{ address: string, frame: typeof frames[number], frameText: string, pictures: readonly Picture[], status: string }} shown @param {Events} on */
const contentOf = ({ address, frame, frameText, pictures, status }, on) => html`
  <h3>${texts.keepLink}</h3>
  <p class="muted">${texts.keepLinkHelp}</p>
  <div class="bar">
    <input id="keep-link" type="text" readonly aria-label=${texts.keepLink} .value=${live(address)} @focus=${selectAll}>
    <button id="keep-copy" type="button" class="primary" @click=${on.copyLink}>${texts.keepCopy}</button>
  </div>
  <h3>${texts.embedTitle}</h3>
  <p class="muted">${texts.embedHelp}</p>
  <div class="bar">
    <fieldset id="embed-size" class="segmented">${choicesOf('embed-size', words.sizeLegend, frames, frame.value, on.chooseFrame)}</fieldset>
    <button id="embed-copy" type="button" @click=${on.copyFrame}>${texts.embedCopy}</button>
  </div>
  <textarea id="embed-text" rows="4" readonly spellcheck="false" aria-label=${texts.embedText}
    .value=${live(frameText)} @focus=${selectAll}></textarea>
  <p id="embed-disk" class="muted" .hidden=${!isOnDisk()}>${texts.embedDisk}</p>
  <h3>${texts.keepExerciseTitle}</h3>
  <p class="muted">${texts.keepExerciseHelp}</p>
  <div class="bar">
    <button id="keep-exercise" type="button" @click=${on.makeExercise}>${texts.keepExercise}</button>
    <button id="keep-collect" type="button" @click=${on.collect}>${texts.keepCollect}</button>
  </div>
  <h3>${texts.keepCodeTitle}</h3>
  <p class="muted">${texts.keepCodeHelp}</p>
  <div class="bar">
    <button id="keep-code" type="button" @click=${on.takeCode}>${texts.keepCode}</button>
  </div>
  <h3>${texts.keepFile}</h3>
  <p class="muted">${texts.keepFileHelp}</p>
  <div class="bar">
    <button id="keep-save" type="button" @click=${on.saveRun}>${texts.keepSave}</button>
    <button id="keep-open" type="button" @click=${() => document.getElementById('keep-file')?.click()}>${texts.keepOpen}</button>
    <input id="keep-file" type="file" accept="application/json,.json" hidden @change=${on.choose}>
  </div>
  <h3>${texts.keepPictures}</h3>
  <p class="muted">${texts.keepPicturesHelp}</p>
  <ul id="keep-pictures" class="keep-pictures">${pictures.map(
    (picture) =>
      html`<li><span>${picture.name}</span>${kinds.map(
        (kind) =>
          html`<button type="button" aria-label=${words.savePicture(picture.name, kind[0])}
            @click=${() => on.savePicture(picture, kind)}>${words.kindName(kind[0])}</button>`,
      )}</li>`,
  )}</ul>
  <h3>${texts.keepTables}</h3>
  <div class="bar">
    <button id="keep-generations" type="button" @click=${on.saveGenerations}>${texts.keepGenerations}</button>
    <button id="keep-drive" type="button" @click=${on.saveDrive}>${texts.keepDrive}</button>
  </div>
  <p class="sheet-foot"><button id="keep-checks" type="button" @click=${on.check}>${opening.texts.checksButton}</button></p>
  <p id="keep-status" class="keep-status" role="status">${status}</p>`;
