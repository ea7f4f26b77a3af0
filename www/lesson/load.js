// The lesson is loaded when a step of it is opened first: its steps, its words and its styles.
/** @import { PaperResult } from '../core/engine.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Tools } from './page.js' */
import { byId } from '../kit/elements.js';
import { isEmbedded } from '../kit/host.js';
import { once } from '../kit/memo.js';
import { titleOf } from '../lab/navigation.js';
import { load as loadDisturbance } from '../parts/disturbance/words/load.js';
import { load as loadGeneration } from '../parts/generation/words/load.js';
import { createPlace } from '../parts/load.js';
import { lesson as words, opening } from '../words/index.js';
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
  // Answers belong to what is handed in, also where no step is open.
  const keepsake = createKeepsake(tools.store, tools.engine);
  /** @type {{ draw: (state: State, scene: Scene) => void } | null} */
  let lesson = null;
  /** @type {Promise<void> | null} */
  let loading = null;
  /** @type {import('../parts/load.js').Place | null} */
  let place = null;

  async function begin() {
    // Its run takes the place of the one there was; in a frame no way leads back.
    const hadRun = !isEmbedded && !byId('instrument').hidden;
    place = createPlace('lesson', tools.store.redraw, hadRun ? opening.back : '');
    try {
      const { createLessonPage } = await load();
      lesson = createLessonPage(tools);
      place.fill();
      place = null;
      tools.store.redraw();
    } catch (error) {
      place?.fail(error);
    }
  }

  return {
    /** Loads it, unless that is done or under way or no step is open. Resolves when it is there or cannot be. @param {State} state */
    open(state) {
      if (state.lesson > 0) loading ??= begin();
      return loading;
    },

    /** Where it will be, if it is open and not there. @param {State} state */
    waiting: (state) => (state.lesson > 0 ? place : null),

    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      if (lesson) {
        lesson.draw(state, scene);
        keepsake.follow(progressSlice.of(tools.store.get()));
      } else if (state.lesson > 0) document.title = titleOf(words.nav);
    },
  };
}
