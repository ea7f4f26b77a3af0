// The dialog that keeps what is on screen: as a link, as a file, as pictures, as tables.
import { download } from '../kit/download.js';
import { byId } from '../kit/elements.js';
import { createEmbedDialog } from './frame-text.js';
import { isFree } from '../run/guard.js';
import { messageOf } from '../words/errors.js';
import { keep as words } from '../words/index.js';
import { copy } from '../kit/copy.js';
import { descriptionOf, drawingOf, picturesOnScreen } from './pictures.js';
import { pngOf } from './png.js';
import { openRunFile, runFile } from '../link/run-file.js';
import { svgOf } from './svg.js';
import { driveCsv, generationsCsv } from './csv.js';

/** @typedef {import('../run/actions/actions.js').Actions} Actions */
/** @typedef {import('../core/engine.js').Engine} Engine */
/** @typedef {import('../link/link.js').Links} Links */
/** @typedef {import('./pictures.js').Picture} Picture */
/** @typedef {import('../run/scene.js').Scene} Scene */
/** @typedef {import('../run/store.js').Store} Store */

const kinds = /** @type {const} */ ([
  ['png', 'image/png', pngOf],
  ['svg', 'image/svg+xml', svgOf],
]);

/** @param {{ engine: Engine, store: Store, actions: Actions, links: Links, sceneOf: (state: ReturnType<Store['get']>) => Scene }} parts */
export function createKeep({ engine, store, actions, links, sceneOf }) {
  /** @type {HTMLDialogElement} */
  const dialog = byId('keep');
  /** @type {HTMLInputElement} */
  const link = byId('keep-link');
  /** @type {HTMLInputElement} */
  const file = byId('keep-file');
  const status = byId('keep-status');

  const linkNow = () => links.linkOf(store.get(), engine.experiment);
  const embed = createEmbedDialog(store.get, linkNow);
  const address = () => `${location.href.split('#')[0]}#${linkNow()}`;
  const origin = () => words.origin(engine.version(), address());
  const name = () => words.fileName(store.get().experiment.evolution.seed, store.get().generation);

  const show = (/** @type {string} */ text) => {
    link.value = address();
    embed.draw();
    status.textContent = text;
    byId('keep-pictures').replaceChildren(...picturesOnScreen().map(rowOf));
    if (!dialog.open) dialog.showModal();
  };

  /** @param {Picture} picture @param {typeof kinds[number]} kind */
  const savePicture = async (picture, [ending, type, write]) => {
    try {
      const [version, link] = origin();
      const about = { title: picture.name, description: descriptionOf(picture), link, version };
      const content = await write(drawingOf(picture), about);
      download(`${name()}-${picture.key}.${ending}`, type, content);
    } catch (error) {
      status.textContent = words.pictureNotSaved(picture.name, messageOf(error));
    }
  };

  /** @param {Picture} picture */
  const rowOf = (picture) => {
    const row = document.createElement('li');
    const buttons = kinds.map((kind) => {
      const button = document.createElement('button');
      Object.assign(button, { type: 'button', textContent: words.kindName(kind[0]) });
      button.setAttribute('aria-label', words.savePicture(picture.name, kind[0]));
      button.addEventListener('click', () => savePicture(picture, kind));
      return button;
    });
    const label = document.createElement('span');
    label.textContent = picture.name;
    row.append(label, ...buttons);
    return row;
  };

  byId('keep-button').addEventListener('click', () => {
    actions.pauseEvolution();
    show(words.fingerprint(engine.hash(), store.get().history.length - 1));
  });
  byId('keep-button').hidden = false;
  byId('keep-close').addEventListener('click', () => dialog.close());
  link.addEventListener('focus', () => link.select());
  byId('keep-copy').addEventListener('click', () => copy(link, status, words));
  byId('keep-save').addEventListener('click', () =>
    download(`${name()}.json`, 'application/json', runFile(store.get(), engine, links)),
  );
  byId('keep-generations').addEventListener('click', () =>
    download(`${name()}-generations.csv`, 'text/csv', generationsCsv(store.get().history, origin())),
  );
  byId('keep-drive').addEventListener('click', () => {
    const { experiment, gains, driving } = sceneOf(store.get());
    const content = driveCsv(driving, engine.stability(experiment, gains), origin());
    download(`${name()}-drive.csv`, 'text/csv', content);
  });

  /** @param {File} chosen */
  const open = async (chosen) => {
    try {
      const { opened, generations } = await openRunFile(await chosen.text(), engine, links);
      actions.openLinked(opened, [], generations);
      show(words.opened(chosen.name, generations));
    } catch (error) {
      show(words.notOpened(chosen.name, messageOf(error)));
    }
  };
  byId('keep-open').addEventListener('click', () => file.click());
  file.addEventListener('change', () => {
    const [chosen] = file.files ?? [];
    file.value = '';
    if (chosen) open(chosen);
  });
  addEventListener('dragover', (event) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  });
  addEventListener('drop', (event) => {
    const [chosen] = event.dataTransfer?.files ?? [];
    if (!chosen) return;
    event.preventDefault();
    if (isFree(store.get(), 'share')) open(chosen);
  });
}
