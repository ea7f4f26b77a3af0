/** What frames.js gives a page under test; pages of others have none. */
declare var pageFrames: {
  /** When the page has drawn what happened. */
  drawn(): Promise<void>;
  /** A frame later, in which the page hears of its new size, and when it has drawn what comes of that. */
  settled(): Promise<void>;
  /** Whether nothing is to be drawn. */
  areNone(): boolean;
  /** So many times as fast what moves moves from now on. */
  setPace(times: number): void;
};
