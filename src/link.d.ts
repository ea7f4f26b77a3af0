import type { Experiment, Preset } from '../pkg/ep_locomotion.js';

/** What a link of the page runs. */
export interface LinkedRun {
  /** The part of the page, or `lesson`; `lab` where the link names none that is there. */
  part: string;
  /** The preset from which the experiment differs. */
  preset: Preset;
  /** All of it, with what the link changes. */
  experiment: Experiment;
  /** The generation on screen. */
  generation: number;
  /** Whose gains drive: 'evolved', 'hand', or one of the paper's two choices. */
  drives: string;
  /** The gains that were set by hand, if any. */
  gains: readonly [number, number, number] | null;
  /**
   * What else the link carries, as text, by its key: what is about the page alone, and what is not applied here (`vary`,
   * `who`, also where it stands before the # or after a ?, `given`, `from`, `under`, `step`).
   */
  others: Record<string, string>;
  /** What of it is wrong, in words, and was left as it is without it. What stands in `others` is not looked at, but `v` and the step of the lesson. */
  problems: string[];
}

/** The run of a link: a whole address with its #, or what follows that. The core must be ready. */
export function openLink(link: string): LinkedRun;
