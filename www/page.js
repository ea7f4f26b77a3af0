// Wires the page: experiment → engine → views. The views get numbers and draw them.
/** @import { Engine } from './core/engine.js' */
/** @import { Scene } from './run/scene.js' */
/** @import { State } from './run/state.js' */
import { createEngine } from './core/engine.js';
import { tryNow } from './core/pending.js';
import { sayFailed } from './embed/post.js';
import { followAddress, takeInstead, showInstead, watchCore } from './instead.js';
import { byId } from './kit/elements.js';
import { keepHeld, steadySliders } from './kit/finger.js';
import { createFocusKeeper } from './kit/focus.js';
import { isEmbedded, isStill } from './kit/host.js';
import { breathe, createAccumulator, createApart, createFrameLoop, createTurns, pause } from './kit/loop.js';
import { createComputing } from './lab/computing.js';
import { createDraw, headOf } from './lab/draw.js';
import { createPinButton } from './lab/pin-button.js';
import { followSurroundings } from './lab/surroundings.js';
import { createHead, createViews, sayTexts } from './lab/views.js';
import { links } from './lesson/links.js';
import { askForLesson, createLesson } from './lesson/load.js';
import { progressSlice } from './lesson/state.js';
import { createAddress } from './link/address.js';
import { askFor, createParts, longest } from './parts/load.js';
import { firstPage, inSight, named, pagesBeside, parts, places } from './parts/parts.js';
import { createActions } from './run/actions/actions.js';
import { createBehind } from './run/behind.js';
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

/** Not what arrow keys move. */
const pressable = 'a, button:not(:disabled, .handle)';

/** Of the lesson, or of the open part. @param {State} state */
const headingOf = ({ lesson, page }) =>
  lesson ? '#lesson-title' : page === 'lab' ? '#instrument h2' : `#${page}-title`;

/** To the questions of the lesson. @param {State} state */
const answersOf = (state) => progressSlice.of(state).answers;

/** Loaded where the page is a figure. */
const loadEmbed = () => import('./embed/page.js');
/** What speaks to the page around a figure. @type {ReturnType<Awaited<ReturnType<typeof loadEmbed>>['createEmbed']> | null} */
let embed = null;

/** Of a core that is lost nothing more is drawn. @param {unknown} error */
function tell(error) {
  if (isLost(error)) throw error;
  reportError(error);
}

/** While the page opens nothing holds the browser for long; timers would make each pause 4 ms long. */
const giveWay = createTurns(4, pause);

/** The state, the actions that change it, and what of it is seen. @param {Engine} engine @param {Parameters<typeof createScene>[2]} drivesOf @param {() => void} redraw */
async function createRun(engine, drivesOf, redraw) {
  const paper = engine.paper();
  const first = firstState(engine, 'velocity-limits', isStill() ? atEnd : fromStart);
  await giveWay();
  const store = createStore(first, redraw);
  const sight = createSight(createScene(engine.drive, paper, drivesOf), first, redraw, (error) =>
    store.update({ message: messageOf(error) }),
  );
  await giveWay();
  /** Of the state that is seen. @param {State} state */
  const seenScene = (state) => sight.of(state).scene;
  const finalTime = () => seenScene(store.get()).driving.finalTime;
  const actions = createActions({ engine, store, paper, finalTime, isStill, places });
  const tools = { engine, store, actions: guarded(actions, store), paper, links };
  return { actions, tools, sight, seenScene };
}

/** @typedef {Awaited<ReturnType<typeof createRun>>} Run */

/** All that shows something of the run, or changes it. @param {Run} run @param {() => void} redraw @param {() => ReturnType<typeof createAddress> | null} addressOf */
async function createSeen({ actions, tools, sight, seenScene }, redraw, addressOf) {
  const { store } = tools;
  const apart = createApart(tell);
  /** What one of them asks for of its own may still be under way. @param {string} name @param {() => void} act */
  const turn = (name, act) => apart(name, () => tryNow(act, redraw));
  const go = (/** @type {string} */ link) => addressOf()?.go(link);
  const order = [firstPage, 'lesson', ...links.pages.filter((name) => name !== firstPage)];
  steadySliders();
  keepHeld();
  const lesson = createLesson({ ...tools, go });
  const made = createParts(parts, tools, sight.renew);
  const exercise = createExercise({
    ...tools,
    places: parts.flatMap((part) => part.places ?? []),
    answersOf,
    onHandIn: (handed) => embed?.handIn(handed),
  });
  const computingLine = createComputing(tools.actions);
  const pinButton = createPinButton(tools, seenScene);
  await giveWay();
  // These three in one piece: they stand side by side above the page, in sight already, and each moves the others.
  const head = createHead(tools.actions, order, named, () => go(links.linkOfStep(store.get().lastStep)));
  const settings = createSettingsPanel(tools, inSight.lab);
  const share = createShare({
    ...tools,
    sceneOf: seenScene,
    open: actions.openLinked,
    keepPlace: (next) => addressOf()?.keepPlace(next),
  });
  await giveWay();
  return { turn, lesson, made, exercise, computingLine, pinButton, head, settings, share };
}

/** @typedef {Awaited<ReturnType<typeof createSeen>>} Seen */

/** What the state says is drawn, each thing in its turn and apart from the others. @param {Run} run @param {Seen} seen @param {() => ReturnType<typeof createAddress> | null} addressOf */
function createShow({ tools, sight }, seen, addressOf) {
  const { engine, store, paper, actions } = tools;
  const { turn, lesson, made, exercise, computingLine, pinButton, head, settings, share } = seen;
  const drawLab = createDraw(() => createViews(store, actions), engine, paper, inSight);
  const keepFocus = createFocusKeeper(pressable);
  /** Where something will be that is open. @param {State} state */
  const waitingOf = (state) => lesson.waiting(state) ?? made.waiting(state.page);
  const toDraw = createBehind(store, sight, (state) => waitingOf(state)?.isLate === false);
  /** Each view by its name. @param {State} state @param {Scene} scene */
  const labOf = (state, scene) => {
    /** @type {Record<string, () => void>} */
    let views = {};
    turn('lab', () => {
      views = drawLab(state, scene);
    });
    return Object.entries(views);
  };
  /** @param {State} state @param {Scene} scene */
  const drawPart = (state, scene) => turn(state.page, () => made.of(state.page)?.draw(state, scene));

  return {
    /** Makes and draws piece by piece what is not in sight yet, so that the first picture takes less at once. */
    async prepare() {
      const first = toDraw();
      await giveWay();
      for (const [name, act] of labOf(first.state, first.scene)) {
        turn(name, act);
        await giveWay();
      }
      const { state, scene } = toDraw();
      drawPart(state, scene);
      await giveWay();
    },

    /** The open part asks the workers for what it still lacks. */
    show() {
      made.open(store.get().page);
      lesson.open(store.get());
      const { now, state, scene, isBehind } = toDraw();
      turn('computing', () => computingLine.draw(now));
      const waiting = waitingOf(state)?.name;
      for (const [name, act] of headOf(head, state, waiting)) turn(name, act);
      for (const [name, act] of labOf(state, scene)) turn(name, act);
      turn('pauseButton', () => head.pauseButton.draw(state.evolving));
      turn('lesson', () => lesson.draw(state, scene));
      drawPart(state, scene);
      turn('exercise', () => exercise.draw(state, made.size, scene));
      if (!isBehind) turn('address', () => addressOf()?.follow(state));
      followAddress();
      // What is being set, while its drives are still on their way.
      turn('settings', () => settings.draw(now));
      turn('embed', () => embed?.draw(state));
      turn('share', () => share.draw(state));
      turn('pins', () => pinButton.draw(state, scene));
      turn('focus', () => keepFocus(headingOf(now)));
    },
  };
}

/** What time changes, and then what is seen of it; whether another frame is due. @param {Run} run @param {Seen} seen @param {() => void} show */
function createFrame({ actions, tools: { store } }, { made, turn }, show) {
  const generations = createAccumulator();

  /** While so many milliseconds are not over. @param {number} milliseconds */
  const within = (milliseconds) => {
    const end = performance.now() + milliseconds;
    return () => performance.now() < end;
  };
  /** As many generations as are due, or as fit into half a frame. @param {State} state @param {number} seconds */
  const moreOf = ({ pace, catchingUp }, seconds) => {
    if (catchingUp || !Number.isFinite(pace)) return within(8);
    let due = generations.take(seconds, pace);
    return () => due-- > 0;
  };
  /** Frames in a row that are for evolution alone. */
  let unseen = 0;

  return (/** @type {number} */ seconds) => {
    const before = store.get();
    // Where a link is waited for, what it passes on its way is seen now and then.
    const isOnItsWay = before.catchingUp && before.evolving && !before.computing && !before.dragging;
    unseen = seconds > 0 && isOnItsWay ? (unseen + 1) % 4 : 0;
    if (unseen > 0) {
      actions.evolve(within(30));
      return true;
    }
    turn(before.page, () => made.of(before.page)?.tick?.(before, seconds));
    // First of all there is a picture.
    if (seconds > 0 && before.evolving && !before.dragging) actions.evolve(moreOf(before, seconds));
    actions.advance(seconds);
    show();
    const { evolving, computing, robot } = store.get();
    return evolving || computing !== null || robot.playing;
  };
}

/** What is not there yet of the open part is there, or cannot be or is late, once this is resolved. @param {Engine} engine */
async function start(engine) {
  await giveWay();
  /** @type {Seen | null} */
  let seen = null;
  /** @type {ReturnType<typeof createAddress> | null} */
  let address = null;
  /** Once it is there: nothing of the first picture moves because the open part comes later. @type {ReturnType<typeof createFrame> | null} */
  let frame = null;
  const loop = createFrameLoop((seconds) => frame?.(seconds) ?? false);
  const run = await createRun(
    engine,
    (state) => seen?.made.of(state.page)?.drives?.(state) ?? null,
    loop.request,
  );
  await giveWay();
  const { actions, tools, sight } = run;
  const { store } = tools;
  const addressNow = () => address;
  seen = await createSeen(run, loop.request, addressNow);
  const { made, lesson, share } = seen;
  const { show, prepare } = createShow(run, seen, addressNow);
  // It hears its host while the open part is still on its way.
  if (isEmbedded) {
    const { createEmbed } = await loadEmbed();
    embed = createEmbed({
      ...tools,
      actions,
      seen: () => sight.of(store.get()),
      answersOf,
      whenSeen: () => sight.whenSeen(store.get),
      shapes: parts,
    });
  }

  byId('plane-robots').setAttribute('aria-label', words.planeLabel);
  createKeys(share.openChecks);
  byId('fitness-table').addEventListener('click', () => showTable(fitnessTable(store.get())));
  address = createAddress({ ...tools, actions, slices: places.slices, firstPage, onWrite: followAddress });
  await giveWay();
  const opened = Promise.all([made.open(store.get().page), lesson.open(store.get())]);
  // A figure has nothing else.
  await (isEmbedded ? opened : Promise.race([opened, breathe(longest)]));
  // What goes wrong later nobody has caught.
  opened.then();
  await giveWay();
  await prepare();
  frame = createFrame(run, seen, show);
  takeInstead();
  byId('instrument').hidden = false;
  // At once, because the next frame may be late.
  show();
  followSurroundings(actions, show);
  embed?.begin(address.problems);
  loop.request();
  /** After the first picture, which was asked for before this, of a run that has come as far as its link says or is being computed. */
  const sayReady = () => {
    const { catchingUp, evolving, computing } = store.get();
    if (catchingUp && evolving && !computing) requestAnimationFrame(sayReady);
    else document.documentElement.dataset.ready = 'true';
  };
  requestAnimationFrame(sayReady);
}

/** Opens the page, or says why it cannot be opened. */
export async function begin() {
  try {
    sayTexts();
    for (const element of document.querySelectorAll('[data-beside]'))
      element.setAttribute('data-page', pagesBeside(element.getAttribute('data-beside')).join(' '));
    watchCore((why) => embed?.fail(why));
    // Side by side with the core.
    askFor(parts, location.hash || `#${firstPage}`);
    askForLesson(location.hash);
    if (isEmbedded) loadEmbed().catch(() => {});
    await start(await createEngine());
  } catch (error) {
    const why = showInstead(error);
    if (embed) embed.fail(why);
    else if (isEmbedded) sayFailed(why);
    console.error(error);
  }
}
