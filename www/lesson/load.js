// The lesson is loaded when a step of it is opened first: its steps, its words and its styles.
/** @import { PaperResult } from '../core/engine.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Tools } from './page.js' */
import { byId } from '../kit/elements.js';
import { once } from '../kit/memo.js';
import { createWaiting } from '../lab/waiting.js';
import { load as loadDisturbance } from '../parts/disturbance/words/load.js';
import { load as loadGeneration } from '../parts/generation/words/load.js';
import { afterWords } from '../words/pick.js';
import { createKeepsake } from './keepsake.js';
import { progressSlice } from './state.js';
import { load as loadWords } from './words/load.js';

const load = once(() => afterWords([loadWords, loadGeneration, loadDisturbance], () => import('./page.js')));

/** Begins to load it if an address opens it; whether it can be loaded is seen when it is opened. @param {string} hash */
export function askForLesson(hash) {
  if (/^#lesson\b|&lesson=/.test(hash)) load().catch(() => {});
}

/** @param {Omit<Tools, 'look'> & { paper: PaperResult[] }} tools */
export function createLesson(tools) {
  const article = byId('lesson');
  // Answers belong to what is handed in, also where no step is open.
  const keepsake = createKeepsake(tools.store, tools.engine);
  /** @type {{ draw: (state: State, scene: Scene) => void } | null} */
  let lesson = null;
  /** @type {Promise<void> | null} */
  let loading = null;

  async function begin() {
    const waiting = createWaiting();
    article.replaceChildren(waiting.element);
    try {
      const { createLessonPage } = await load();
      const made = createLessonPage(tools);
      article.replaceChildren();
      lesson = made;
      tools.store.redraw();
    } catch (error) {
      waiting.fail(error);
    }
  }

  return {
    /** Loads it, unless that is done or under way or no step is open. Resolves when it is there or cannot be. @param {State} state */
    open(state) {
      if (state.lesson > 0) loading ??= begin();
      return loading;
    },

    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      if (lesson) {
        lesson.draw(state, scene);
        keepsake.follow(progressSlice.of(tools.store.get()));
        return;
      }
      const isOpen = state.lesson > 0;
      document.body.toggleAttribute('data-lesson', isOpen);
      article.hidden = !isOpen;
    },
  };
}
