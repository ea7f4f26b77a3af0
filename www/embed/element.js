// <ep-locomotion link="landscape&v=1&seed=7"></ep-locomotion>: a figure as an element, for pages that load dist/embed.js
// as a module.
//
// Attributes
//   link    which part and which run: what follows the # of the page's address, or the whole address
//   src     where the page is, if not as index.html beside this module
//   height  in pixels, from 300 to 5000; without it the figure has the height that it asks for
//   label   what a screen reader says of it
//
// Methods, each of which promises the figure's state
//   set({ link })   set({ experiment, gains, generation })   step(generations)   run()   pause()   read()
//
// Property: state, which the figure told last, or null. Events: ready and state, with the state as their detail;
// generation, with the statistics of one; drive, answer and handin, with what its user did; error, with a message.
// messages.js says what is in them.
//
// A figure loads when it comes near the window, or when it is asked something. src that is set, even to the same, begins another:
// what the one before was asked is refused, and nothing that it still says is heard.
/** @import { Experiment } from '../core/engine.js' */
/** @import { Language } from '../words/language.js' */
/** @import { Report } from './messages.js' */
import * as en from '../words/en/element.js';
import * as ko from '../words/ko/element.js';
import { frameName } from '../kit/host.js';
import { attributes, languageAround, reflect } from './attributes.js';
import { createComplaints } from './complaints.js';
import { sheet } from './element-style.js';
import { isHeight, leastHeight, mostHeight, version } from './frame.js';
import { allowed } from './frame-line.js';
import { linkIn } from './link-in.js';
import { createQuestions } from './questions.js';

/** @typedef {{ link: string } | { experiment: Partial<Experiment>, gains?: readonly number[], generation?: number }} Setting A link may be set as it is, without braces. */

/** Vite would take the address for a file to bundle if it were written in one. */
const here = String(import.meta.url);
/** Within it whatever is a figure has said that it is one, once its frame is loaded. */
const longestSilence = 15_000;
/** Within it the slowest frame is loaded, once somebody asks it something, and the slowest figure ready. */
const longestLoading = 60_000;
/** What a frame can show; javascript: would run in the page around it. */
const protocols = ['http:', 'https:', 'file:', 'blob:', 'data:'];
/** What a figure says that its page may listen for. */
const events = ['ready', 'state', 'generation', 'drive', 'answer', 'handin', 'error'];
/** One character more than the figure reads (`link/values.js`), so that it says of a longer link what is wrong. */
const mostOfLink = 200_001;

/** @type {Record<Language | (string & {}), import('../words/index.js').Words<typeof en>>} */
const languages = { en, ko };

class EpLocomotion extends HTMLElement {
  static observedAttributes = attributes;

  #root = this.attachShadow({ mode: 'open' });
  #frame = document.createElement('iframe');
  #complaints = createComplaints((message) => this.#tell('error', { message }));
  #questions = createQuestions();
  #isPlaced = false;
  /** How long what is in the frame may be silent: longer, once it has said that it is a figure. */
  #patience = longestSilence;
  /** Whether a figure of any version has spoken that can be asked. */
  #isHeard = false;
  /** Whether it can be asked: its run may still be on its way. */
  #hears = false;
  #isReady = false;
  /** Why no figure will answer. */
  #refusal = '';
  #wantedHeight = 0;
  /** Of the figure that hears: nobody else is heard in its place. @type {string | null} */
  #origin = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #silence;
  /** @type {Report | null} */
  #state = null;

  constructor() {
    super();
    this.#root.adoptedStyleSheets = [sheet];
    this.#frame.name = frameName;
    this.#frame.allow = allowed;
    this.#frame.addEventListener('load', () => this.#listen(this.#patience));
    this.#root.append(this.#complaints.element);
  }

  /** What the figure told last as a whole; read() asks for it anew. */
  get state() {
    return this.#state;
  }

  connectedCallback() {
    addEventListener('message', this);
    this.#isPlaced = true;
    this.#open();
  }

  disconnectedCallback() {
    removeEventListener('message', this);
    this.#isPlaced = false;
    this.#close();
    // Nothing is wrong with it: frameworks move and remove what they like.
    this.#refusal = this.#words.gone;
    this.#questions.giveUp(this.#refusal);
  }

  /** Moved with its frame, by a browser that can, it goes on. */
  connectedMoveCallback() {}

  /** @param {string} name */
  attributeChangedCallback(name) {
    // Before it is in the page all of them are still to come.
    if (!this.#isPlaced) return;
    if (name === 'src') {
      this.#questions.giveUp(this.#words.replaced);
      this.#open();
    } else if (name === 'link') this.#follow();
    else this.#dress();
  }

  /** @param {Setting | string} what */
  set(what) {
    return this.#ask({ ...(typeof what === 'string' ? { link: what } : what), type: 'set' });
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
  handleEvent({ source, origin, data }) {
    if (source !== this.#frame.contentWindow || typeof data?.ep !== 'number') return;
    if (this.#origin !== null && origin !== this.#origin) return;
    if (data.type === 'loading' && !data.hears) {
      // Also what is loaded anew in the same frame.
      this.#await(longestLoading);
      return this.#listen(longestLoading);
    }
    this.#isHeard = true;
    clearTimeout(this.#silence);
    if (data.ep !== version) return this.#refuse(this.#words.otherVersion(data.ep, version));
    const { ep, type, id, ...told } = data;
    if (type === 'loading') return this.#begin(origin);
    const question = this.#questions.take(id);
    if (type === 'height') {
      this.#wantedHeight = isHeight(told.height) ? told.height : 0;
      return this.#dress();
    }
    // Nobody has asked for it: so it begins badly, and says to whoever asks whether it goes on.
    const isBad = type === 'error' && id === undefined && !this.#isReady;
    if (isBad || type === 'ready') {
      // What is ready once more was loaded anew.
      if (this.#isReady || !this.#hears) this.#begin(origin);
      this.#isReady = true;
    }
    if (isBad) return this.#complaints.say('refusal', String(told.message));
    if (type === 'ready' || type === 'state') this.#state = told;
    if (type === 'error') question?.reject(new Error(told.message));
    else question?.resolve(told);
    if (events.includes(type)) this.#tell(type, told);
    if (type === 'ready') this.#complaints.say('link', [told.problems ?? []].flat().join(' '));
    if (type === 'state' && question?.message.type === 'set') this.#complaints.beginAnew();
  }

  get #words() {
    return languages[languageAround(this).toLowerCase().split(/[-_]/)[0]] ?? en;
  }

  get #link() {
    return linkIn(this.getAttribute('link') || 'lab').slice(0, mostOfLink);
  }

  #open() {
    this.#close();
    this.#complaints.beginAnew();
    this.#dress();
    const given = this.getAttribute('src');
    const src = given || 'index.html';
    const base = given ? document.baseURI : here;
    // A browser of before 2024 has no such question.
    const address = URL.canParse?.(src, base) === false ? null : new URL(src, base);
    const isAddress = address !== null && protocols.includes(address.protocol);
    if (isAddress) {
      address.hash = this.#link;
      this.#frame.src = address.href;
    }
    this.#frame.loading = this.#questions.open().length > 0 ? 'eager' : 'lazy';
    this.#root.append(this.#frame);
    if (!isAddress) this.#refuse(this.#words.noAddress(src.slice(0, 200)));
    else if (this.#questions.open().length > 0) this.#listen(longestLoading);
  }

  /** A frame that is taken out and put in again has another window: nobody speaks for the one before. */
  #close() {
    this.#frame.remove();
    this.#frame.removeAttribute('src');
    clearTimeout(this.#silence);
    this.#silence = undefined;
    this.#await(longestSilence);
    this.#origin = null;
    this.#state = null;
  }

  /** What is in the frame is still to be ready. @param {number} longest how long it may be silent */
  #await(longest) {
    this.#patience = longest;
    this.#isHeard = false;
    this.#hears = false;
    this.#isReady = false;
    this.#refusal = '';
  }

  /** Whatever is in the frame must speak within a time. @param {number} longest */
  #listen(longest) {
    if (this.#isHeard || !this.#frame.hasAttribute('src')) return;
    clearTimeout(this.#silence);
    this.#silence = setTimeout(() => {
      this.#silence = undefined;
      const [address] = this.#frame.src.split('#');
      this.#refuse(this.#words.silent(address));
    }, longest);
  }

  /** No figure will answer here, unless one begins all the same. @param {string} why */
  #refuse(why) {
    this.#refusal = why;
    this.#complaints.say('refusal', why);
    this.#questions.giveUp(why);
  }

  /** The figure can hear: now, or again when it was loaded anew. @param {string} origin */
  #begin(origin) {
    this.#complaints.say('refusal', '');
    this.#refusal = '';
    this.#hears = true;
    this.#origin = origin;
    for (const message of this.#questions.open()) this.#post(message);
  }

  /** Goes where the attribute leads. */
  async #follow() {
    const figure = this.#frame.contentWindow;
    const said = await this.set({ link: this.#link }).then(({ problems }) => problems.join(' '), String);
    // Another opens it by itself; that no figure answers is said.
    if (figure === this.#frame.contentWindow && !this.#refusal) this.#complaints.say('link', said);
  }

  /** @param {object} question @returns {Promise<Report>} */
  #ask(question) {
    if (this.#refusal) return Promise.reject(new Error(this.#refusal));
    const { message, answer } = this.#questions.ask(question);
    this.#frame.loading = 'eager';
    if (this.#hears) this.#post(message);
    else if (this.#silence === undefined) this.#listen(longestLoading);
    return answer;
  }

  /** @param {{ id: number }} message */
  #post(message) {
    try {
      // A file and a Blob have no origin that could be named.
      const target = this.#origin === null || this.#origin === 'null' ? '*' : this.#origin;
      this.#frame.contentWindow?.postMessage(message, target);
    } catch (error) {
      // What cannot be sent, as a function.
      this.#questions.take(message.id)?.reject(error);
    }
  }

  #dress() {
    this.#frame.title = this.getAttribute('label') || this.#words.label;
    const text = this.getAttribute('height') ?? '';
    const height = Number(text || this.#wantedHeight);
    const isWrong = text !== '' && !isHeight(height);
    const wrong = isWrong ? this.#words.noHeight(leastHeight, mostHeight, text.slice(0, 40)) : '';
    this.#complaints.say('height', wrong);
    this.#frame.style.height = height > 0 && !isWrong ? `${height}px` : '';
  }

  /** @param {string} type @param {object} detail */
  #tell(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}

reflect(EpLocomotion.prototype);
if (!customElements.get('ep-locomotion')) customElements.define('ep-locomotion', EpLocomotion);
