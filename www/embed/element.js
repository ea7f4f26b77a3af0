// <ep-locomotion link="landscape&v=1&seed=7"></ep-locomotion>: a figure as an element, for pages that include this module.
//
// Attributes: link, what follows the # of the page's address; height, in pixels, without which the figure has the height that
// it asks for; src, the page's address if it is not beside this module; label and loading, as an iframe has them.
// Methods: set({ link } or { experiment, gains, generation }), step(generations), run(), pause(), read(); each returns a
// promise of the figure's state. Events: ready and generation, each with what the figure said as its detail.
// Documented in messages.js, from which nothing is imported: this file stands alone.

const version = 1;
const page = new URL(import.meta.env.DEV ? '../../index.html' : 'index.html', String(import.meta.url));

const sheet = new CSSStyleSheet();
sheet.replaceSync(`
  :host { display: block; }
  :host([hidden]) { display: none; }
  iframe { display: block; width: 100%; height: 420px; border: 0; }
`);

/** @typedef {import('./messages.js').Report} Report */
/** @typedef {{ resolve: (report: Report) => void, reject: (reason: Error) => void }} Waiting */

class EpLocomotion extends HTMLElement {
  static observedAttributes = ['link', 'height', 'label'];

  #frame = document.createElement('iframe');
  /** @type {Map<number, Waiting>} */
  #waiting = new Map();
  /** What is asked before the figure can hear. @type {object[]} */
  #early = [];
  #isReady = false;
  #asked = 0;
  #wanted = 0;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    root.adoptedStyleSheets = [sheet];
    this.#frame.allow = 'fullscreen';
    root.append(this.#frame);
  }

  connectedCallback() {
    const address = new URL(this.getAttribute('src') ?? page, document.baseURI);
    address.search = '?embed';
    address.hash = this.#link;
    this.#frame.loading = this.getAttribute('loading') === 'lazy' ? 'lazy' : 'eager';
    this.#label();
    addEventListener('message', this);
    this.#frame.src = address.href;
  }

  disconnectedCallback() {
    removeEventListener('message', this);
    this.#isReady = false;
    this.#early = [];
    for (const { reject } of this.#waiting.values())
      reject(new Error('ep-locomotion: it was taken from the page'));
    this.#waiting.clear();
  }

  /** @param {string} name */
  attributeChangedCallback(name) {
    if (name === 'height') this.#resize();
    else if (name === 'label') this.#label();
    // What is wrong with it the figure shows itself.
    else if (this.isConnected) this.set({ link: this.#link }).catch(() => {});
  }

  /** @param {{ link: string } | { experiment: object, gains?: readonly number[], generation?: number }} what */
  set(what) {
    return this.#ask({ ...what, type: 'set' });
  }

  /** @param {number} generations */
  step(generations = 1) {
    return this.#ask({ type: 'step', generations });
  }

  run() {
    return this.#ask({ type: 'run' });
  }

  pause() {
    return this.#ask({ type: 'pause' });
  }

  read() {
    return this.#ask({ type: 'read' });
  }

  /** @param {MessageEvent} event */
  handleEvent({ source, data }) {
    if (source !== this.#frame.contentWindow || data?.ep !== version) return;
    const { ep, type, id, ...rest } = data;
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (type === 'state') waiting?.resolve(rest);
    else if (type === 'error') waiting?.reject(new Error(rest.message));
    else if (type === 'height') {
      this.#wanted = rest.height;
      this.#resize();
    } else if (type === 'ready' || type === 'generation') {
      if (type === 'ready') this.#begin();
      this.dispatchEvent(new CustomEvent(type, { detail: rest }));
    }
  }

  get #link() {
    return this.getAttribute('link') || 'lab';
  }

  #begin() {
    this.#isReady = true;
    for (const message of this.#early.splice(0)) this.#post(message);
  }

  /** @param {object} message @returns {Promise<Report>} */
  #ask(message) {
    this.#asked += 1;
    const id = this.#asked;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      if (this.#isReady) this.#post({ ...message, id });
      else this.#early.push({ ...message, id });
    });
  }

  /** @param {object} message */
  #post(message) {
    this.#frame.contentWindow?.postMessage({ ep: version, ...message }, '*');
  }

  #resize() {
    const own = Number(this.getAttribute('height'));
    const height = own > 0 ? own : this.#wanted;
    this.#frame.style.height = height > 0 ? `${height}px` : '';
  }

  #label() {
    this.#frame.title = this.getAttribute('label') ?? 'Evolving a robot’s controller';
  }
}

if (!customElements.get('ep-locomotion')) customElements.define('ep-locomotion', EpLocomotion);
