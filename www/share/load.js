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
import { opening as words } from '../words/index.js';
import { afterWords } from '../words/pick.js';
import { load as loadChecks } from './checks/words/load.js';
import { load as loadCode } from './code/words/load.js';
import { load as loadCollect } from './collect/words/load.js';
import { load as loadHandIn } from './handin/words/load.js';
import { load as loadWords } from './words/load.js';

/** `open` opens a file whether or not the controls are locked; `keepPlace`: the browser's “back” will lead to the run that is there now. @typedef {Tools & { sceneOf: (state: State) => Scene, open: Tools['actions']['openLinked'], keepPlace: (next: Pick<State, 'page' | 'lesson' | 'trial'>) => void }} ShareTools */
/** What the sheets get: they open each other. @typedef {ShareTools & Record<'openChecks' | 'openCode' | 'openCollect', () => void>} SheetTools */

/**
 * A sheet that opens at once; then, if it is still open once what fills it is there, that is used.
 * @template {{ start: () => void }} T
 * @param {string} id @param {string} className @param {string} title @param {(sheet: Sheet) => Promise<T>} load
 */
function createOnDemand(id, className, title, load) {
  const sheet = createSheet(id, className, title, words.texts.close);
  /** @type {T | null} */
  let content = null;
  const fill = once(async () => {
    const waiting = createWaiting();
    sheet.draw(waiting.element);
    try {
      content = await load(sheet);
    } catch (error) {
      waiting.fail(error);
    }
  });
  const openFor = async (/** @type {(content: T) => void} */ use) => {
    const filled = fill();
    sheet.open();
    await filled;
    if (content && sheet.dialog.open) use(content);
  };
  return { open: () => openFor(({ start }) => start()), openFor, content: () => content };
}

/** @param {ShareTools} tools */
export function createShare(tools) {
  const { texts } = words;
  const checks = createOnDemand('checks', 'table-sheet', texts.checksTitle, async (sheet) => {
    const { createChecks } = await afterWords([loadChecks], () => import('./checks/dialog.js'));
    return createChecks(tools.engine, sheet);
  });
  const code = createOnDemand('code', 'code-sheet', texts.codeTitle, async (sheet) => {
    const { createCode } = await afterWords([loadCode], () => import('./code/dialog.js'));
    return createCode(tools, sheet);
  });
  const opening = {
    openChecks: checks.open,
    openCode: code.open,
    openCollect: () => collect.open(),
  };
  const collect = createOnDemand(
    'collect',
    'table-sheet collect-sheet',
    texts.collectTitle,
    async (sheet) => {
      const { createCollect } = await afterWords(
        [loadCollect, loadHandIn],
        () => import('./collect/dialog.js'),
      );
      return createCollect({ ...tools, ...opening }, sheet);
    },
  );
  const keep = createOnDemand('keep', 'keep', texts.keepTitle, async (sheet) => {
    const { createKeep } = await afterWords([loadWords, loadHandIn], () => import('./dialog.js'));
    return createKeep({ ...tools, ...opening }, sheet);
  });
  if (!isEmbedded) offer(tools, keep);
  return {
    openChecks: checks.open,
    /** @param {State} state */
    draw(state) {
      keep.content()?.drawMaker(state);
      collect.content()?.drawOpened(state);
    },
  };
}

/** The button, and files that are dropped on the page. @param {ShareTools} tools @param {ReturnType<typeof createOnDemand<ReturnType<typeof import('./dialog.js').createKeep>>>} keep */
function offer({ actions }, keep) {
  const button = byId('keep-button');
  button.hidden = false;
  button.addEventListener('click', () => {
    actions.pauseEvolution();
    keep.open();
  });
  addEventListener('dragover', (event) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  });
  addEventListener('drop', (event) => {
    const [chosen] = event.dataTransfer?.files ?? [];
    if (!chosen) return;
    event.preventDefault();
    actions.share(() => keep.openFor(({ open }) => open(chosen)));
  });
}
