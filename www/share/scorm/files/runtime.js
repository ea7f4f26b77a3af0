// Between a learning platform that speaks SCORM 1.2 and the exercise in the frame: who works on it goes in; the receipt, the
// score and the time come out, and what was done so far comes back when the attempt is resumed.

// biome-ignore lint/complexity/noExcessiveLinesPerFunction: all of the script, which imports nothing and leaves no name in the page
(() => {
  /** What exercise.js says. @type {{ link: string, texts: import('../package.js').Sentences }} */
  const { link, texts } = /** @type {any} */ (globalThis).exercise;
  const figure = /** @type {HTMLIFrameElement} */ (document.getElementById('figure'));
  const told = /** @type {HTMLElement} */ (document.getElementById('told'));
  /** Of the session with the platform. */
  let begun = 0;
  let isOver = true;
  /** Longest that something is kept and not yet committed, in milliseconds. */
  const pause = 60_000;
  /** Of cmi.suspend_data, in characters. */
  const most = 4096;
  /** Of who works on it, as links take it. */
  const mostOfWho = 80;
  const lms = platform();

  /** The platform stands in a window around this one, or in that which opened this or the outermost. @returns {any} */
  function platform() {
    for (const first of [window, window.opener, window.top?.opener])
      for (let one = first, i = 0; one && i < 20; i += 1) {
        try {
          if (one.API) return one.API;
          if (one.parent === one) break;
          one = one.parent;
        } catch {
          break;
        }
      }
    return null;
  }

  /** What went wrong stays in sight. */
  let hasFailed = false;

  /** @param {string} text */
  function say(text) {
    // The same once more would be read out once more.
    if (told.textContent === text) return;
    told.textContent = text;
    told.hidden = false;
  }

  const note = (/** @type {string} */ text) => hasFailed || say(text);

  /** @param {string} text */
  function tell(text) {
    hasFailed = true;
    say(text);
  }

  /** What the platform answers, and what it says if it did not do it. @param {string} name @param {string[]} given @returns {[answer: string, why?: string]} */
  function call(name, ...given) {
    if (!lms) return [''];
    try {
      const answer = String(lms[name](...given));
      const code = String(lms.LMSGetLastError());
      if (code === '0' && (name === 'LMSGetValue' || answer === 'true')) return [answer];
      // A value that nobody has set is no failure.
      if (name === 'LMSGetValue') return [''];
      return ['', `${code} ${lms.LMSGetErrorString(code)}`.trim()];
    } catch (error) {
      return ['', String(error)];
    }
  }

  /** Whether the platform did it; if not, the student is told. @param {string} name @param {string[]} given */
  function ask(name, ...given) {
    const [answer, why] = call(name, ...given);
    if (why !== undefined) tell(texts.refused.replace('…', why));
    return answer;
  }

  const set = (/** @type {string} */ field, /** @type {string | number} */ value) =>
    ask('LMSSetValue', `cmi.core.${field}`, String(value));

  /** Digits of the exercise, behind whatever is kept of it: a package may be replaced by a corrected one. */
  const stamp = [...link]
    .reduce((hash, letter) => Math.imul(hash ^ letter.charCodeAt(0), 0x01000193) >>> 0, 0x811c9dc5)
    .toString(16)
    .padStart(8, '0');
  const stamped = (/** @type {string} */ one) => `#${one.slice(one.indexOf('#') + 1)} ${stamp}`;

  /** Set while something is kept that is not committed yet. @type {ReturnType<typeof setTimeout> | undefined} */
  let due;

  /** Many platforms lose what was not committed, where the window's end does not reach them. */
  function commit() {
    clearTimeout(due);
    due = undefined;
    return ask('LMSCommit', '');
  }

  let receipt = '';
  let latest = '';

  /** The receipt in its own line, then how far the work has come; where there is no room for both, the receipt. */
  function keep() {
    const lines = [receipt, latest].filter((line) => line && line.length <= most);
    if (lines.join('\n').length > most) lines.pop();
    if (receipt.length > most) tell(texts.tooLong);
    if (latest && !lines.includes(latest)) note(texts.noRoom);
    if (lines.length === 0) return;
    ask('LMSSetValue', 'cmi.suspend_data', lines.join('\n'));
    due ??= setTimeout(commit, pause);
  }

  /** @param {{ met: boolean | null, points: number | null, most: number | null }} result */
  function score({ met, points, most: all }) {
    if (met === null) return set('lesson_status', 'completed');
    const share = points === null || !all ? (met ? 1 : 0) : points / all;
    // SCORM 1.2 leaves it to the platform whether it takes these two.
    call('LMSSetValue', 'cmi.core.score.min', '0');
    call('LMSSetValue', 'cmi.core.score.max', '100');
    set('score.raw', Math.round(10_000 * Math.min(1, Math.max(0, share))) / 100);
    return set('lesson_status', met ? 'passed' : 'failed');
  }

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let soon;
  /** The number of the latest question, and of that up to which the answers are older than the receipt. */
  let question = 0;
  let outdated = 0;
  const read = () => {
    question += 1;
    figure.contentWindow?.postMessage({ ep: 1, type: 'read', id: String(question) }, '*');
  };

  /** @type {Readonly<Record<string, (message: any) => void>>} */
  const heard = {
    drive: read,
    // Many come, one after the other, and the window may be closed before they end.
    generation() {
      if (soon !== undefined) return;
      read();
      soon = setTimeout(() => {
        soon = undefined;
        read();
      }, 1000);
    },
    state({ id, link: now }) {
      if (!(Number(id) > outdated)) return;
      // Nothing is done after what is handed in as long as that is on screen.
      latest = now.includes('&handin=') ? '' : stamped(now);
      keep();
    },
    handin(result) {
      // What is handed in comes back as that, as long as nothing is done after it.
      clearTimeout(soon);
      soon = undefined;
      outdated = question;
      receipt = stamped(result.link);
      latest = '';
      keep();
      score(result);
      if (commit()) note(texts.kept);
    },
  };

  addEventListener('message', ({ source, data }) => {
    if (isOver || source !== figure.contentWindow || data?.ep !== 1) return;
    if (Object.hasOwn(heard, data.type)) heard[data.type](data);
  });

  function begin() {
    isOver = false;
    begun = performance.now();
    ask('LMSInitialize', '');
  }

  // As it was, out of the memory of the browser: another session.
  addEventListener('pageshow', ({ persisted }) => {
    if (persisted && isOver) begin();
  });
  addEventListener('pagehide', () => {
    if (isOver) return;
    isOver = true;
    const seconds = (performance.now() - begun) / 1000;
    const two = (/** @type {number} */ value) => String(Math.floor(value)).padStart(2, '0');
    const hours = String(Math.min(9999, Math.floor(seconds / 3600))).padStart(4, '0');
    set('session_time', `${hours}:${two((seconds / 60) % 60)}:${two(seconds % 60)}`);
    set('exit', 'suspend');
    commit();
    ask('LMSFinish', '');
  });

  // A phone may end what is hidden without a word.
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden' && due !== undefined) commit();
  });

  document.documentElement.lang = texts.language;
  document.title = texts.title;
  figure.title = texts.title;
  if (!lms) tell(texts.nobody);
  begin();
  const lines = ask('LMSGetValue', 'cmi.suspend_data')
    .trim()
    .split(/\s+(?=#)/)
    .filter((line) => /^#\w+&/.test(line));
  [receipt = '', latest = ''] = lines[0]?.includes('handin=') ? lines : ['', lines[0]];
  const who = [...ask('LMSGetValue', 'cmi.core.student_id')].slice(0, mostOfWho).join('');
  // What was handed in stays judged, also where the platform had no room for its receipt.
  const isJudged = /^(?:passed|failed|completed)$/.test(ask('LMSGetValue', 'cmi.core.lesson_status'));
  if (lms && !receipt && !isJudged) set('lesson_status', 'incomplete');
  const own = `${link}${who ? `&who=${encodeURIComponent(who)}` : ''}`;
  // Older packages kept no stamp: what is theirs goes on.
  const [resumed, of = stamp] = (latest || receipt).split(/\s+/);
  if (of !== stamp) note(texts.changed);
  figure.src = `ep-locomotion.html?embed${of === stamp && resumed ? resumed : `#${own}`}`;
})();
