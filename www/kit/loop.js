// From the frames of the browser to the page's time.

/** After a hidden tab or a long frame, no more than this much time is made up for. */
const longestFrame = 0.25;

/**
 * Calls `frame` once for each animation frame in which something was requested or is moving.
 * @param {(seconds: number) => boolean} frame Gets the real seconds since the last frame of an unbroken row; true asks for another.
 */
export function createFrameLoop(frame) {
  let requested = false;
  let last = Number.NaN;
  const run = (/** @type {number} */ now) => {
    requested = false;
    const seconds = Number.isNaN(last) ? 0 : Math.min(longestFrame, Math.max(0, (now - last) / 1000));
    const again = frame(seconds);
    last = again ? now : Number.NaN;
    if (again) request();
  };
  const request = () => {
    if (requested) return;
    requested = true;
    requestAnimationFrame(run);
  };
  return { request };
}

/**
 * Gives each its turn in a frame: what one throws keeps no other from its own, and is told once, however many frames it comes back in.
 * @param {(error: unknown) => void} tell
 */
export function createApart(tell) {
  /** @type {Set<string>} */
  const told = new Set();
  return (/** @type {string} */ name, /** @type {() => void} */ act) => {
    try {
      act();
    } catch (error) {
      const text = `${name}: ${error}`;
      if (!told.has(text)) tell(error);
      told.add(text);
    }
  };
}

/** Whole generations out of real time. */
export function createAccumulator() {
  let owed = 0;
  return {
    /** @param {number} seconds @param {number} perSecond */
    take(seconds, perSecond) {
      owed += seconds * perSecond;
      const whole = Math.floor(owed);
      owed -= whole;
      return whole;
    },
  };
}

/** Lets the browser do what is due meanwhile, so that nothing holds the page for long. @param {number} [milliseconds] */
export const breathe = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Lets what waits have its turn, also where no frame is drawn and timers are slow. */
export const pause = () =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve(undefined);
    };
    port2.postMessage(null);
  });

/** Lets the browser have its turn whenever so many milliseconds were taken. @param {number} milliseconds @param {() => Promise<unknown>} [letOthers] */
export function createTurns(milliseconds, letOthers = breathe) {
  let end = performance.now() + milliseconds;
  return async () => {
    if (performance.now() < end) return;
    await letOthers();
    end = performance.now() + milliseconds;
  };
}
