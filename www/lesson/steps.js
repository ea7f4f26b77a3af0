// What the steps of the lesson hold, in the order of the path.
import { path, stepNames } from './path.js';
import * as every from './steps/all.js';

/** @import { Engine, Triple } from '../core/engine.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */
/** @import { Sight } from './sights.js' */
/** @import { Formula } from './formulas/notation.js' */
/** @import { Block, Live, Tools } from './page.js' */
/** @import { Quiz } from './questions/quiz.js' */
/** @import { StepName } from './path.js' */
/** In the place of the plane, beside it or under it, while one of these parts is open, or any; with `after` once somebody has predicted that question. @typedef {{ create: (tools: Tools, words: any) => Block, place: 'instead' | 'beside' | 'under', pages?: readonly string[], after?: string }} Stage */
/** What a drive came to: in the experiment with this text. @typedef {{ experiment: string, gains: Triple, cost: number, arrived: boolean }} Priced */
/** It may be about one sight of the figure, and about one moment of the drive: there the robots’ clock then stands, in seconds. @typedef {readonly [name: string, link: string, sight?: Sight, time?: (engine: Engine, state: State) => number]} Try */
/** What one reads and does, in this order. Texts, tries and questions are named as in the words of the step; a view may be a text that needs nobody to press it. With `after` it is not there before that question of the step is answered; `begins` is what a press sets going. */
/**
 * @typedef {({ kind: 'text', name: string }
 *   | { kind: 'formula', formula: Formula }
 *   | { kind: 'notice' }
 *   | { kind: 'tries', tries: readonly Try[], begins?: (store: Store) => void }
 *   | { kind: 'quiz', name: string, quiz: Quiz }
 *   | { kind: 'view', create: (tools: Tools, words: any, href: (link: string) => string) => Block, isText?: true }) & { after?: string }} Content
 */
/**
 * @typedef {object} Written
 * @property {'drive' | 'evolve' | 'plane' | 'driver'} figure What stands under the plane while the link opens the lab: J and the gains, J and evolution, or the gains alone; with `driver` the gains while somebody drives by hand, else evolution. Another part stands there by itself.
 * @property {(live: Live) => number} [time] Where the robots' clock stands, in seconds; without it they drive.
 * @property {boolean} [overlay] The error posture is drawn on the plane.
 * @property {readonly Content[]} blocks
 * @property {Sight} [sight] What is seen first where there is no room for all; else the stage, or what the figure is about.
 * @property {Stage} [stage] What the step is about, which stays in sight beside its words.
 * @property {(live: Live) => Priced | null} [price] What a drive by hand costs in this step; without it, J of the drive on the plane.
 * @property {(live: Live) => Record<string, string>} [values] The numbers in its texts.
 */

/** The link is what is on screen when the step is opened. @typedef {Written & { name: StepName, link: string }} Step */

/** @type {Readonly<Record<StepName, Written>>} */
const written = every;
/** @param {StepName} name @returns {Step} */
export const stepOf = (name) => ({ name, link: path[name], ...written[name] });
export const steps = stepNames.map(stepOf);
