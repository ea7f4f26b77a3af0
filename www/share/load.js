// What Share needs is loaded when it is opened first: the button answers at once, and the sheet says what one waits for.
/** @import { Tools } from '../parts/part.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Sheet } from '../kit/sheet.js' */
import { byId } from '../kit/elements.js';
import { isEmbedded } from '../kit/host.js';
import { once } from '../kit/memo.js';
import { createSheet } from '../kit/sheet.js';
import { createWaiting } from '../lab/waiting.js';
import { isFree } from '../run/guard.js';
import { opening as words } from '../words/index.js';
import { afterWords } from '../words/pick.js';
import { load as loadChecks } from './checks/words/load.js';
import { load as loadCode } from './code/words/load.js';
import { load as loadCollect } from './collect/words/load.js';
import { load as loadHandIn } from './handin/words/load.js';
import { load as loadWords } from './words/load.js';

/** What the sheets get. `open` opens a file whether or not the controls are locked; `keepPlace`: the browser's “back” will lead to the run that is there now. @typedef {Tools & { sceneOf: (state: State) => Scene, open: Tools['actions']['openLinked'], keepPlace: (next: { page: string, lesson: number }) => void, openChecks: () => void, openCode: () => void, openCollect: () => void }} SheetTools */

/**
 * Opens a sheet; then, if it is still open once what fills it is there, uses that.
 * @template T
 * @param {Sheet} sheet @param {() => Promise<T>} load
 */
function createOnDemand(sheet, load) {
  const filled = once(async () => {
    const waiting = createWaiting();
    sheet.draw(waiting.element);
    try {
      return await load();
    } catch (error) {
      waiting.fail(error);
      return null;
    }
  });
  return async (/** @type {(content: T) => void} */ use) => {
    const content = filled();
    sheet.open();
    const there = await content;
    if (there && sheet.dialog.open) use(there);
  };
}

/** @param {Omit<SheetTools, 'openChecks' | 'openCode' | 'openCollect'>} tools */
export function createShare(tools) {
  const { texts } = words;
  const checksSheet = createSheet('checks', 'table-sheet', texts.checksTitle, texts.close);
  const checks = createOnDemand(checksSheet, async () =>
    (await afterWords([loadChecks], () => import('./checks/dialog.js'))).createChecks(
      tools.engine,
      checksSheet,
    ),
  );
  const openChecks = () => checks(({ start }) => start());
  const codeSheet = createSheet('code', 'code-sheet', texts.codeTitle, texts.close);
  const code = createOnDemand(codeSheet, async () =>
    (await afterWords([loadCode], () => import('./code/dialog.js'))).createCode(tools, codeSheet),
  );
  const openCode = () => code(({ start }) => start());
  const collectSheet = createSheet('collect', 'table-sheet collect-sheet', texts.collectTitle, texts.close);
  /** @type {((state: State) => void) | null} */
  let drawOpened = null;
  const collect = createOnDemand(collectSheet, async () => {
    const made = (await afterWords([loadCollect], () => import('./collect/dialog.js'))).createCollect(
      { ...tools, openCollect },
      collectSheet,
    );
    drawOpened = made.drawOpened;
    return made;
  });
  const openCollect = () => collect(({ start }) => start());
  /** @type {((state: State) => void) | null} */
  let drawMaker = null;
  const keepSheet = createSheet('keep', 'keep', texts.keepTitle, texts.close);
  const keep = createOnDemand(keepSheet, async () => {
    const made = (await afterWords([loadWords, loadHandIn], () => import('./dialog.js'))).createKeep(
      { ...tools, openChecks, openCode, openCollect },
      keepSheet,
    );
    drawMaker = made.drawMaker;
    return made;
  });
  if (!isEmbedded) offer(tools, keep);
  return {
    openChecks,
    /** @param {State} state */
    draw(state) {
      drawMaker?.(state);
      drawOpened?.(state);
    },
  };
}

/** The button, and files that are dropped on the page. @param {Omit<SheetTools, 'openChecks' | 'openCode' | 'openCollect'>} tools @param {(use: (content: ReturnType<typeof import('./dialog.js').createKeep>) => void) => void} keep */
function offer({ store, actions }, keep) {
  const button = byId('keep-button');
  button.hidden = false;
  button.addEventListener('click', () => {
    actions.pauseEvolution();
    keep(({ start }) => start());
  });
  addEventListener('dragover', (event) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  });
  addEventListener('drop', (event) => {
    const [chosen] = event.dataTransfer?.files ?? [];
    if (!chosen) return;
    event.preventDefault();
    if (isFree(store.get(), 'share')) keep(({ open }) => open(chosen));
  });
}
