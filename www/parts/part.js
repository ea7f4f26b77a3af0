// What a part of the page is made of.
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { Engine, PaperResult } from '../core/engine.js' */
/** @import { Opened } from '../run/actions/page.js' */
/** @import { Group } from '../run/exercise.js' */
/** @import { ChosenDrives, Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Slice, Store } from '../run/store.js' */
/** @import { PartKey } from '../link/keys.js' */
/** @import { Links } from '../link/link.js' */
/** @import { Language } from '../words/language.js' */

/** What an open part gets. @typedef {{ engine: Engine, store: Store, actions: Actions, paper: PaperResult[], links: Links }} Tools */
/**
 * A part that has been opened.
 * @typedef {object} Page
 * @property {HTMLElement} element What it shows, which stands in the page since then.
 * @property {(state: State, scene: Scene) => void} draw At every change of the state, while it is open.
 * @property {() => void} [retry] When it is opened again: what could not be computed may be asked for once more.
 * @property {(state: State, seconds: number) => void} [tick] At every frame, while it is open.
 * @property {(state: State) => ChosenDrives | null} [drives] What drives on the plane in the place of the population.
 */
/** J as it is driven, evolution, or who drives. @typedef {'cost' | 'evolution' | 'driver'} Beside */
/** Where the controls of a group stand, as selectors: what is locked, and what is gone when they are hidden. @typedef {Partial<Record<Group, { lock?: string, hide?: string }>>} Places */
/**
 * @typedef {object} Part
 * @property {string} name In links.
 * @property {Record<Language, { name: string, purpose: string }>} called What the head of the page calls it, and says of it, before any of its words are loaded.
 * @property {Slice<any>} slice What it keeps in the state.
 * @property {readonly PartKey[]} [keys] What of that a link carries.
 * @property {(opened: Opened, refuse: (key: string, why: string) => void) => Opened} [mend] What of a link goes wrong only together.
 * @property {Places} [places] Its controls, for exercises.
 * @property {readonly ('start' | 'disturbance')[]} [tries] What a drive there meets that evolution does not.
 * @property {readonly Beside[]} [beside] What of the lab stands beside it.
 * @property {(state: State) => boolean} [gains] Whether it has the sliders beside it; without this whenever one drives by hand.
 * @property {'map' | 'plane'} [room] What it is laid out for: a map, for which the parts of J and the plane make room, or, beside a text, the room of the plane.
 * @property {true} [alone] Whether it has the whole page, with nothing of the lab beside it.
 * @property {true} [pays] Whether what is paid of J on the way stands at the path on the plane.
 * @property {true} [tells] Whether it says aloud how the gains drive that somebody chooses.
 * @property {true} [phases] Where a generation is seen phase by phase.
 * @property {readonly [share: number, most: number]} figure How high a figure of it looks best for its width, and the most that helps it, in pixels.
 * @property {() => Promise<(tools: Tools) => Page | Promise<Page>>} load What makes its page, which is not loaded before it is opened.
 */

export {};
