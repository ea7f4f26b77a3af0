// A figure without a page, and what is asked of it.
import { createMessages } from '../../../www/embed/messages.js';
import { links } from '../../../www/lesson/links.js';
import { places } from '../../../www/parts/parts.js';
import { createActions } from '../../../www/run/actions/actions.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState } from '../../../www/run/first.js';
import { createScene, createSight } from '../../../www/run/scene.js';
import { createStore } from '../../../www/run/store.js';
import { createEngine } from '../harness/core.js';

/** A figure without a document, in which what drives on screen may be held up. @param {{ link?: string, engine?: ReturnType<typeof createEngine> }} [options] */
export function figureOf({ link, engine = createEngine() } = {}) {
  const paper = engine.paper();
  const first = firstState(engine, 'velocity-limits', atEnd);
  const store = createStore(first, () => {});
  /** What the drives on screen come to in the place of runs, and that of a single robot with these gains. `waits`: how many answers have waited for them; `answers`: to the lesson’s questions. @type {{ error: Error | null, of: (gains: readonly number[]) => Error | null, waits: number, answers: ReturnType<import('../../../www/embed/messages.js').AnswersOf> }} */
  const held = { error: null, of: () => null, waits: 0, answers: {} };
  /** @type {typeof engine.drive} */
  const drive = (from, gains) => {
    const error = held.error ?? (gains.length === 1 ? held.of(gains[0]) : null);
    if (error) throw error;
    return engine.drive(from, gains);
  };
  const sight = createSight(
    createScene(drive, paper, () => null),
    first,
    () => {},
    () => {},
  );
  const seen = () => sight.of(store.get());
  const means = { engine, store, paper, finalTime: () => 1, isStill: () => true, places };
  const actions = createActions(means);
  if (link) actions.openLinked(links.openLink(link, engine).opened, []);
  /** @type {any[]} */
  const said = [];
  /** @type {Map<unknown, (message: any) => void>} */
  const waiting = new Map();
  const messages = createMessages(
    {
      engine,
      store,
      actions,
      links,
      seen,
      answersOf: () => held.answers,
      whenSeen() {
        held.waits += 1;
        return sight.whenSeen(store.get);
      },
    },
    (message) => {
      said.push(message);
      waiting.get(/** @type {{ id?: unknown }} */ (message).id)?.(message);
    },
  );
  /** @param {object} message @returns {Promise<any>} */
  const asked = (message) =>
    new Promise((resolve) => {
      const id = waiting.size + 1;
      waiting.set(id, resolve);
      messages.hear({ ep: 1, id, ...message });
    });
  return { messages, actions, said, held, seen, asked, store };
}
