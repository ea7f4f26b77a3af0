// Wires the page: experiment → engine → views. The views get numbers and draw them.
/** @import { Engine } from './core/engine.js' */
/** @import { State } from './run/state.js' */
import { createEngine } from './core/engine.js';
import { tryNow } from './core/pending.js';
import { createEmbed, sayFailed } from './embed/page.js';
import { takeInstead, showInstead, watchCore } from './instead.js';
import { byId } from './kit/elements.js';
import { isEmbedded, isStill } from './kit/host.js';
import { createAccumulator, createApart, createFrameLoop } from './kit/loop.js';
import { createComputing } from './lab/computing.js';
import { createDraw } from './lab/draw.js';
import { createPinButton } from './lab/pin-button.js';
import { followSurroundings } from './lab/surroundings.js';
import { createViews, sayTexts } from './lab/views.js';
import { links } from './lesson/links.js';
import { askForLesson, createLesson } from './lesson/load.js';
import { progressSlice } from './lesson/state.js';
import { createAddress } from './link/address.js';
import { askFor, createParts } from './parts/load.js';
import { firstPage, parts, places } from './parts/parts.js';
import { createActions } from './run/actions/actions.js';
import { atEnd, fromStart } from './run/clock.js';
import { firstState } from './run/first.js';
import { guarded } from './run/guard.js';
import { createScene, createSight } from './run/scene.js';
import { createStore } from './run/store.js';
import { createSettingsPanel } from './settings/panel.js';
import { createExercise } from './share/exercise/page.js';
import { createKeys } from './share/keys.js';
import { createShare } from './share/load.js';
import { isLost, messageOf } from './words/errors.js';
import { lab as words } from './words/index.js';
import { fitnessTable } from './lab/fitness-table.js';
import { showTable } from './lab/table-sheet.js';

/** To the questions of the lesson. @param {State} state */
const answersOf = (state) => progressSlice.of(state).answers;

/** What speaks to the page around a figure. @type {ReturnType<typeof createEmbed> | null} */
let embed = null;

/** Of a core that is lost nothing more is drawn. @param {unknown} error */
function tell(error) {
  if (isLost(error)) throw error;
  reportError(error);
}

/** What is not there yet of the open part is there, or cannot be, once this is resolved. @param {Engine} engine */
async function start(engine) {
  const paper = engine.paper();
  /** @type {ReturnType<typeof createParts> | null} */
  let pages = null;
  const sceneOf = createScene(engine.drive, paper, (state) => pages?.of(state.page)?.drives?.(state) ?? null);
  const generations = createAccumulator();
  const loop = createFrameLoop(frame);
  const first = firstState(engine, 'velocity-limits', isStill() ? atEnd : fromStart);
  const store = createStore(first, loop.request);
  const sight = createSight(sceneOf, first, loop.request, (error) =>
    store.update({ message: messageOf(error) }),
  );
  /** Of the state that is seen. @param {State} state */
  const seenScene = (state) => sight.of(state).scene;
  const whenSeen = () => sight.whenSeen(store.get);
  const finalTime = () => seenScene(store.get()).driving.finalTime;
  const actions = createActions({ engine, store, paper, finalTime, isStill, places });
  const controls = guarded(actions, store);
  const tools = { engine, store, actions: controls, paper, links };
  const go = (/** @type {string} */ link) => address?.go(link);
  const onLesson = () => go(links.linkOfStep(store.get().lastStep));
  const order = [firstPage, 'lesson', ...links.pages.filter((name) => name !== firstPage)];
  const apart = createApart(tell);
  /** What one of them asks for of its own may still be under way. @param {string} name @param {() => void} act */
  const turn = (name, act) => apart(name, () => tryNow(act, loop.request));
  const draw = createDraw(createViews(store, controls, order, onLesson), engine, paper, turn);
  const lesson = createLesson({ ...tools, go });
  const made = createParts(parts, tools, sight.renew);
  pages = made;
  const settings = createSettingsPanel(tools);
  const exercise = createExercise({
    ...tools,
    places: parts.flatMap((part) => part.places ?? []),
    answersOf,
    onHandIn: (handed) => embed?.handIn(handed),
  });
  const share = createShare({ ...tools, sceneOf: seenScene, open: actions.openLinked });
  const computingLine = createComputing(controls);
  const pinButton = createPinButton(tools, seenScene);
  embed = isEmbedded
    ? createEmbed({
        ...tools,
        actions,
        seen: () => sight.of(store.get()),
        answersOf,
        whenSeen,
        shapes: parts,
      })
    : null;
  /** @type {ReturnType<typeof createAddress> | null} */
  let address = null;
  /** Nothing of the first picture moves because the open part comes later. */
  let isWhole = false;

  /** Draws what the state says, and lets the open part ask the workers for what it still lacks. */
  const show = () => {
    const now = store.get();
    const { state: driven, scene, isComputing } = sight.of(now);
    const { robot, size, theme, message, evolving } = now;
    const state = isComputing ? { ...driven, robot, size, theme, message, evolving } : now;
    made.open(now.page);
    lesson.open(now);
    turn('computing', () => computingLine.draw(now));
    turn('lab', () => draw(state, scene));
    turn('lesson', () => lesson.draw(state, scene));
    turn(state.page, () => made.of(state.page)?.draw(state, scene));
    turn('exercise', () => exercise.draw(state, made.size, scene));
    if (!isComputing) turn('address', () => address?.follow(state));
    // What is being set, while its drives are still on their way.
    turn('settings', () => settings.draw(now));
    turn('embed', () => embed?.draw(state));
    turn('share', () => share.draw(state));
    turn('pins', () => pinButton.draw(state, scene));
  };

  /** @param {number} seconds */
  function frame(seconds) {
    if (!isWhole) return false;
    const before = store.get();
    turn(before.page, () => made.of(before.page)?.tick?.(before, seconds));
    // First of all there is a picture.
    if (seconds > 0 && before.evolving && !before.dragging)
      actions.evolve(moreOf(before.catchingUp ? Number.POSITIVE_INFINITY : before.pace, seconds));
    actions.advance(seconds);
    show();
    const { evolving, computing, robot } = store.get();
    return evolving || computing !== null || robot.playing;
  }

  /** As many generations as are due, or as fit into half a frame. @param {number} pace @param {number} seconds */
  function moreOf(pace, seconds) {
    if (Number.isFinite(pace)) {
      let due = generations.take(seconds, pace);
      return () => due-- > 0;
    }
    const end = performance.now() + 8;
    return () => performance.now() < end;
  }

  byId('plane-robots').setAttribute('aria-label', words.planeLabel);
  createKeys(share.openChecks);
  byId('fitness-table').addEventListener('click', () => showTable(fitnessTable(store.get().history)));
  address = createAddress({ ...tools, actions, firstPage });
  await Promise.all([made.open(store.get().page), lesson.open(store.get())]);
  isWhole = true;
  takeInstead();
  byId('instrument').hidden = false;
  // At once, because the next frame may be late.
  show();
  followSurroundings(actions, show);
  embed?.begin();
  loop.request();
  /** After the first picture, which was asked for before this, of a run that has come as far as its link says or is being computed. */
  const sayReady = () => {
    const { catchingUp, evolving, computing } = store.get();
    if (catchingUp && evolving && !computing) requestAnimationFrame(sayReady);
    else document.documentElement.dataset.ready = 'true';
  };
  requestAnimationFrame(sayReady);
}

document.body.toggleAttribute('data-embed', isEmbedded);
sayTexts();
watchCore((why) => embed?.fail(why));
/** Not awaited where it is called: what is loaded on demand needs this file, and would wait for it in turn. */
async function begin() {
  try {
    // Side by side with the core.
    askFor(parts, location.hash || `#${firstPage}`);
    askForLesson(location.hash);
    await start(await createEngine());
  } catch (error) {
    const why = showInstead(error);
    if (embed) embed.fail(why);
    else if (isEmbedded) sayFailed(why);
    console.error(error);
  }
}
begin();
