// <ep-locomotion link="landscape&v=1&seed=7"></ep-locomotion>: a figure as an element, for pages that load dist/embed.js
// as a module.
//
// Attributes
//   link    which part and which run: what follows the # of the page's address, or the whole address
//   src     where the page is, if not as index.html beside this module
//   height  in pixels; without it the figure has the height that it asks for
//   label   what a screen reader says of it
//
// Methods, each of which promises the figure's state
//   set({ link })   set({ experiment, gains, generation })   step(generations)   run()   pause()   read()
//
// Property: state, which the figure told last, or null. Events: ready and state, with the state as their detail;
// generation, with the statistics of one; error, with a message. messages.js says what is in them.
//
// A figure loads when it comes near the window, or when it is asked something.
/** @import { Experiment } from '../core/engine.js' */
/** @import { Report } from './messages.js' */
import * as en from '../words/en/element.js';
import * as ko from '../words/ko/element.js';
import { frameName } from '../kit/host.js';
import { leastHeight, version } from './frame.js';

/** @typedef {{ link: string } | { experiment: Partial<Experiment>, gains?: readonly number[], generation?: number }} Setting */
/** @typedef {{ message: object, resolve: (report: Report) => void, reject: (reason: Error) => void }} Question */

/** Vite would take the address for a file to bundle if it were written in one. */
const here = String(import.meta.url);
/** Within it the slowest figure has spoken, once its frame is loaded. */
const longestSilence = 15_000;

/** @type {Record<string, import('../words/index.js').Words<typeof en>>} */
const languages = { en, ko };

const sheet = new CSSStyleSheet();
sheet.replaceSync(`
  :host { display: block; }
  :host([hidden]) { display: none; }
  iframe { display: block; width: 100%; height: 420px; border: 0; }
  p { margin: 0 0 8px; padding: 8px 12px; border: 2px solid #b3261e; background: #fff; color: #b3261e; font: 1rem/1.4 sans-serif; }
  p:empty { display: none; }
`);

class EpLocomotion extends HTMLElement {
  static observedAttributes = ['link', 'src', 'height', 'label'];

  #frame = document.createElement('iframe');
  #problem = document.createElement('p');
  /** What is asked and not yet answered, by its id. @type {Map<number, Question>} */
  #questions = new Map();
  #asked = 0;
  /** Whether a figure of any version has spoken. */
  #isHeard = false;
  #isReady = false;
  #wantedHeight = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #silence;
  /** @type {Report | null} */
  #state = null;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    root.adoptedStyleSheets = [sheet];
    this.#problem.setAttribute('role', 'alert');
    this.#frame.name = frameName;
    this.#frame.allow = 'fullscreen';
    this.#frame.addEventListener('load', () => this.#listen());
    root.append(this.#problem, this.#frame);
  }

  /** What the figure told last as a whole; read() asks for it anew. */
  get state() {
    return this.#state;
  }

  connectedCallback() {
    addEventListener('message', this);
    this.#frame.loading = 'lazy';
    this.#open();
  }

  disconnectedCallback() {
    removeEventListener('message', this);
    this.#close();
    this.#frame.removeAttribute('src');
    for (const { reject } of this.#questions.values()) reject(new Error(this.#words.gone));
    this.#questions.clear();
  }

  /** @param {string} name */
  attributeChangedCallback(name) {
    // Before it is in the page all of them are still to come.
    if (!this.#frame.hasAttribute('src')) return;
    if (name === 'src') this.#open();
    else if (name === 'link') this.#follow();
    else {
      this.#complain('');
      this.#dress();
    }
  }

  /** @param {Setting} what */
  set(what) {
    return this.#ask({ ...what, type: 'set' });
  }

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
    if (source !== this.#frame.contentWindow || typeof data?.ep !== 'number') return;
    this.#isHeard = true;
    clearTimeout(this.#silence);
    if (data.ep !== version) return this.#complain(this.#words.otherVersion(data.ep, version));
    const { ep, type, id, ...told } = data;
    const question = this.#questions.get(id);
    this.#questions.delete(id);
    if (type === 'height') {
      this.#wantedHeight = told.height;
      return this.#dress();
    }
    if (type === 'ready') this.#begin();
    if (type === 'ready' || type === 'state') this.#state = told;
    if (type === 'error') question?.reject(new Error(told.message));
    else question?.resolve(told);
    this.#tell(type, told);
  }

  get #words() {
    return languages[this.closest('[lang]')?.getAttribute('lang')?.slice(0, 2) ?? ''] ?? en;
  }

  /** What a link has after its #. */
  get #link() {
    const link = this.getAttribute('link') || 'lab';
    return link.slice(link.indexOf('#') + 1);
  }

  #open() {
    this.#close();
    this.#complain('');
    this.#dress();
    const src = this.getAttribute('src') ?? 'index.html';
    const base = this.hasAttribute('src') ? document.baseURI : here;
    if (!URL.canParse(src, base)) return this.#complain(this.#words.noAddress(src));
    const address = new URL(src, base);
    address.hash = this.#link;
    this.#frame.src = address.href;
  }

  #close() {
    clearTimeout(this.#silence);
    this.#isHeard = false;
    this.#isReady = false;
    this.#state = null;
  }

  /** The frame is loaded: whatever it is must speak. */
  #listen() {
    if (this.#isHeard || !this.#frame.hasAttribute('src')) return;
    clearTimeout(this.#silence);
    const complain = () => this.#complain(this.#words.silent(this.#frame.src.split('#')[0]));
    this.#silence = setTimeout(complain, longestSilence);
  }

  /** The figure can hear: now, or again when it was loaded anew. */
  #begin() {
    this.#complain('');
    this.#dress();
    this.#isReady = true;
    for (const { message } of this.#questions.values()) this.#post(message);
  }

  /** Goes where the attribute leads. */
  async #follow() {
    try {
      const { problems } = await this.set({ link: this.#link });
      this.#complain(problems.join(' '));
    } catch (error) {
      this.#complain(String(error));
    }
  }

  /** @param {object} question @returns {Promise<Report>} */
  #ask(question) {
    this.#asked += 1;
    const id = this.#asked;
    const message = { ep: version, id, ...question };
    this.#frame.loading = 'eager';
    if (this.#isReady) this.#post(message);
    return new Promise((resolve, reject) => this.#questions.set(id, { message, resolve, reject }));
  }

  /** @param {object} message */
  #post(message) {
    this.#frame.contentWindow?.postMessage(message, '*');
  }

  #dress() {
    this.#frame.title = this.getAttribute('label') ?? this.#words.label;
    const text = this.getAttribute('height');
    const height = Number(text ?? this.#wantedHeight);
    const isWrong = text !== null && !(Number.isInteger(height) && height >= leastHeight);
    if (isWrong) this.#complain(this.#words.noHeight(leastHeight, text));
    this.#frame.style.height = height > 0 && !isWrong ? `${height}px` : '';
  }

  /** Says in sight what the page's author has wrong, or no longer. @param {string} message */
  #complain(message) {
    this.#problem.textContent = message && `<ep-locomotion>: ${message}`;
    if (message) this.#tell('error', { message });
  }

  /** @param {string} type @param {object} detail */
  #tell(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}

for (const name of EpLocomotion.observedAttributes)
  Object.defineProperty(EpLocomotion.prototype, name, {
    get() {
      return this.getAttribute(name) ?? '';
    },
    set(value) {
      this.setAttribute(name, value);
    },
  });

if (!customElements.get('ep-locomotion')) customElements.define('ep-locomotion', EpLocomotion);
