// The sheet that keeps what is on screen: as a link, a frame, an exercise, a file, pictures and tables.
/** @import { Sheet } from '../kit/sheet.js' */
/** @import { SheetTools } from './load.js' */
/** @import { Picture } from './pictures.js' */
import './style.css';
import { html, nothing } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { whenThere } from '../core/pending.js';
import { copy } from '../kit/copy.js';
import { download } from '../kit/download.js';
import { segmentedOf } from '../kit/fields.js';
import { digitsOf } from '../kit/hash.js';
import { selectAll } from '../kit/templates.js';
import { isEmpty } from '../run/exercise.js';
import { caughtUp } from '../run/state.js';
import { messageOf, orSay } from '../words/errors.js';
import { opening } from '../words/index.js';
import { createTask, inLab, linkInLab } from '../parts/park/task.js';
import { inSight } from '../parts/parts.js';
import { driveCsv, driveOrigin, generationsCsv } from './csv.js';
import { fingerprintOf } from './code/fingerprint.js';
import { createMaker } from './exercise/maker.js';
import { frameOf, frames, handedAddress, isOnDisk } from './frame-text.js';
import { descriptionOf, drawingOf, picturesOnScreen } from './pictures.js';
import { pngOf } from './png.js';
import { openRunFile, runFile, textOfRun } from './run-file.js';
import { svgOf } from './svg.js';
import words from './words/index.js';

const { texts } = words;

const kinds = /** @type {const} */ ([
  ['png', 'image/png', pngOf],
  ['svg', 'image/svg+xml', svgOf],
]);

/** @param {SheetTools} tools @param {Sheet} sheet */
export function createKeep(tools, sheet) {
  const { engine, store, actions, links, openChecks, openCode, openCollect } = tools;
  const maker = createMaker(tools);
  let status = '';
  let frame = frames[1];
  /** @type {Picture[]} */
  let pictures = [];

  const linkNow = () => links.linkOf(caughtUp(store.get()), engine.experiment);
  const address = () => handedAddress(linkNow());
  const say = (/** @type {string} */ text) => {
    status = text;
    draw();
  };

  const fingerprint = () =>
    parkedOf(tools) ? '' : words.fingerprint(engine.hash(), store.get().history.length - 1);
  const show = (text = fingerprint()) => {
    pictures = picturesOnScreen();
    say(text);
    sheet.open();
  };

  /** As it is, and once more when what was set has begun. @param {string} [text] */
  const start = (text) => {
    show(text);
    const again = () => sheet.dialog.open && show(text);
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
      const text = await textOfRun(file);
      const { opened, generations, hasDrive } = await openRunFile(text, engine, links, signal);
      if (signal.aborted) return;
      tools.keepPlace(opened);
      // In an exercise the file counts the drives that were made, which would count once more.
      tools.open(opened, [], isEmpty(opened.exercise) ? generations : opened.generation);
      start(words.opened(file.name, generations, hasDrive));
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
    leave: () => sheet.dialog.close(),
    takeCode: insteadOfIt(openCode),
    check: insteadOfIt(openChecks),
  };

  const draw = () => {
    const frameText = frameOf(store.get(), linkNow(), frame.size);
    const park = parkedOf(tools);
    sheet.draw(contentOf({ address: address(), frame, frameText, pictures, status, park }, on));
  };

  return { start, open, drawMaker: maker.draw };
}

/** In Park, where the lab's run is out of sight: what is there instead, and the lab's link of it, if anybody has tried. @param {SheetTools} tools */
function parkedOf(tools) {
  const { engine, store } = tools;
  const state = store.get();
  if (inSight.lab(state)) return null;
  const run = inLab(state, createTask(engine).experiment);
  return { run, link: run && linkInLab(state, run, tools) };
}

/** What is saved as a file, each with the name of the run. @param {SheetTools} tools @param {HTMLDialogElement} dialog @param {() => string} address @param {(text: string) => void} say */
function createSaving(tools, dialog, address, say) {
  const { engine, store, links, sceneOf } = tools;
  const origin = () => words.origin(engine.version(), address());
  const name = () => {
    const { experiment, generation } = parkedOf(tools)?.run ?? store.get();
    return words.fileName(experiment.evolution.seed, generation);
  };
  const saveCsv = (/** @type {string} */ what, /** @type {string} */ content) =>
    download(`${name()}-${what}.csv`, 'text/csv', content);
  const saveRun = () => {
    const state = store.get();
    const { experiment, gains, driving, chosen } = sceneOf(state);
    const drive = chosen ? undefined : { gains, cost: driving.cost.total };
    const content = runFile(state, engine, links, drive);
    download(`${name()}-drive-${fingerprintOf(experiment, gains)}.json`, 'application/json', content);
  };
  const saveDrive = () => {
    const { experiment, gains, driving } = sceneOf(store.get());
    const about = [...origin(), ...driveOrigin(experiment, gains, driving)];
    const table = driveCsv(driving, engine.stability(experiment, gains), about);
    saveCsv(`drive-${fingerprintOf(experiment, gains)}`, table);
  };
  return {
    saveGenerations: () => saveCsv('generations', generationsCsv(store.get(), origin())),
    /** A long drive is read by a worker. */
    saveRun: () => whenThere(orSay(saveRun, say), () => dialog.open),
    saveDrive: () => whenThere(orSay(saveDrive, say), () => dialog.open),
    /** @param {Picture} picture @param {typeof kinds[number]} kind */
    async savePicture(picture, [ending, type, write]) {
      try {
        const [version, link] = origin();
        const about = { title: picture.name, description: descriptionOf(picture), link, version };
        const content = await write(drawingOf(picture), about);
        // Another link is another picture.
        const what = [picture.key, picture.drawn, digitsOf(link.replace(/^.*?#/, ''))].filter(Boolean);
        download(`${[name(), ...what].join('-')}.${ending}`, type, content);
      } catch (error) {
        say(words.pictureNotSaved(picture.name, messageOf(error)));
      }
    },
  };
}

/**
 * @typedef {Record<'leave' | 'copyLink' | 'copyFrame' | 'makeExercise' | 'collect' | 'saveRun' | 'saveGenerations' | 'saveDrive' | 'takeCode' | 'check', () => void>
 *   & { chooseFrame: (value: string) => void, choose: (event: Event) => void, savePicture: (picture: Picture, kind: typeof kinds[number]) => void }} Events
 */

/** @param {{ address: string, frame: typeof frames[number], frameText: string, pictures: readonly Picture[], status: string, park: ReturnType<typeof parkedOf> | null }} shown @param {Events} on */
const contentOf = ({ address, frame, frameText, pictures, status, park }, on) => html`
  <h3>${texts.keepLink}</h3>
  <p class="muted">${park ? texts.keepParkHelp : isOnDisk() ? texts.keepLinkHere : texts.keepLinkHelp} ${isOnDisk() ? texts.keepLinkOnDisk : nothing}</p>
  <div class="bar">
    <input id="keep-link" type="text" readonly aria-label=${texts.keepLink} .value=${live(address)} @focus=${selectAll}>
    <button id="keep-copy" type="button" class="primary" @click=${on.copyLink}>${texts.keepCopy}</button>
  </div>
  ${park && (park.link || !park.run) ? toLab(park.link, on) : nothing}
  <h3>${texts.embedTitle}</h3>
  <p class="muted">${park ? texts.embedParkHelp : texts.embedHelp}</p>
  <div class="bar">
    ${segmentedOf('embed-size', words.sizeLegend, frames, frame.value, on.chooseFrame)}
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
  ${park ? nothing : code(on)}
  <h3>${texts.keepFile}</h3>
  <p class="muted">${texts.keepFileHelp}</p>
  <div class="bar">
    ${park ? nothing : html`<button id="keep-save" type="button" @click=${on.saveRun}>${texts.keepSave}</button>`}
    <button id="keep-open" type="button" @click=${() => document.getElementById('keep-file')?.click()}>${texts.keepOpen}</button>
    <input id="keep-file" type="file" accept="application/json,.json" hidden @change=${on.choose}>
  </div>
  <h3>${texts.keepPictures}</h3>
  <p class="muted">${texts.keepPicturesHelp}</p>
  <ul id="keep-pictures" class="keep-pictures">${pictures.map(
    (picture) =>
      html`<li class="row"><span>${picture.name}</span>${kinds.map(
        (kind) =>
          html`<button type="button" aria-label=${words.savePicture(picture.name, kind[0])}
            @click=${() => on.savePicture(picture, kind)}>${words.kindName(kind[0])}</button>`,
      )}</li>`,
  )}</ul>
  ${park ? nothing : tables(on)}
  <p class="sheet-foot"><button id="keep-checks" type="button" @click=${on.check}>${opening.texts.checksButton}</button></p>
  <p id="keep-status" class="keep-status muted" role="status">${status}</p>`;

/** @param {string | null} link @param {Events} on */
const toLab = (link, on) => html`
  <h3>${texts.keepParkTitle}</h3>
  <p class="muted">${link ? texts.keepParkFound : texts.keepParkEmpty}
    ${link ? html`<a id="keep-lab" href="#${link}" @click=${on.leave}>${texts.keepParkLab}</a>` : nothing}</p>`;

/** @param {Events} on */
const code = (on) => html`
  <h3>${texts.keepCodeTitle}</h3>
  <p class="muted">${texts.keepCodeHelp}</p>
  <div class="bar">
    <button id="keep-code" type="button" @click=${on.takeCode}>${texts.keepCode}</button>
  </div>`;

/** @param {Events} on */
const tables = (on) => html`
  <h3>${texts.keepTables}</h3>
  <div class="bar">
    <button id="keep-generations" type="button" @click=${on.saveGenerations}>${texts.keepGenerations}</button>
    <button id="keep-drive" type="button" @click=${on.saveDrive}>${texts.keepDrive}</button>
  </div>`;
