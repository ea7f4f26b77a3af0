// Whoever speaks to a figure, and whatever is done with it: it answers or it refuses by name, nothing is thrown, and it goes on.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { idIn, isForFigure, messageIn } from '../../../www/embed/told.js';
import { engineTest, pageTest, patience } from '../harness/browsers.js';
import { createEngine, evolve, experiment, simulate } from '../harness/core.js';
import { ask, heardFrom, inHost } from '../harness/host.js';
import { test } from '../harness/once.js';
import { serve } from '../harness/server.js';
import { figureOf } from './figure.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page @param {string} link */
const frameOf = (page, link) =>
  `<iframe src="${page.site.address}?embed#${link.replaceAll('&', '&amp;')}" width="640" height="420"></iframe>`;

/** What a figure may be told, and what each says. */
const right = /** @type {const} */ ([
  [{ type: 'read' }, {}],
  [{ type: 'run', id: 7, extra: undefined }, {}],
  [{ type: 'step' }, { generations: 1 }],
  [{ type: 'step', generations: 10_000 }, { generations: 10_000 }],
  [
    { type: 'set', link: 'lab', gains: 'not looked at', generations: 'as in a state' },
    { link: 'lab', gains: null, generation: 0 },
  ],
  [
    { type: 'set', experiment: {}, gains: [1, 2, 3] },
    { link: null, gains: [1, 2, 3], generation: 0 },
  ],
  [
    { type: 'set', experiment: {}, gains: Float64Array.of(1, 2, 3), generation: 100_000 },
    { gains: [1, 2, 3], generation: 100_000 },
  ],
  [{ type: 'set', experiment: {}, gains: Float32Array.of(1, 2, 3) }, { gains: [1, 2, 3] }],
  // As openLink of the package has it.
  [{ type: 'set', experiment: {}, gains: null, generation: 0 }, { gains: null }],
]);

/** @type {readonly (readonly [message: Record<string, unknown>, said: RegExp])[]} */
const wrong = [
  ...[0, 2, '1', null, [1], 1n].map((ep) => /** @type {const} */ ([{ ep, type: 'read' }, /version 1/])),
  ...['', 'toString', '__proto__', 'READ', null, 7, ['read']].map(
    (type) => /** @type {const} */ ([{ type }, /type must be one of set, step, run, pause, read/]),
  ),
  ...[0, -1, 1.5, 10_001, Number.NaN, '3', null, [3], 3n].map(
    (generations) =>
      /** @type {const} */ ([{ type: 'step', generations }, /^generations must be .* from 1 to 10000/]),
  ),
  ...[-1, 0.5, 100_001, Number.POSITIVE_INFINITY, '1', null].map(
    (generation) =>
      /** @type {const} */ ([
        { type: 'set', experiment: {}, generation },
        /^generation must be .* from 0 to 100000, not/,
      ]),
  ),
  ...[[1, 2], [1, 2, Number.NaN], ['1', '2', '3'], new Array(1e9), '1,2,3', { length: 3 }].map(
    (gains) =>
      /** @type {const} */ ([{ type: 'set', experiment: {}, gains }, /^gains must be three numbers/]),
  ),
  ...[
    ...[{}, { link: 7 }, { experiment: null }, { experiment: 'lab' }, { link: null, experiment: 1 }],
    ...[new Map(), new Date(), [], new ArrayBuffer(8)].map((experiment) => ({ experiment })),
  ].map((what) => /** @type {const} */ ([{ type: 'set', ...what }, /^set needs either a link/])),
  [{ type: 'step', generation: 10 }, /^a field of step must be one of ep, type, id, generations, not “gen/],
  [
    { type: 'set', experiment: {}, gain: [1, 2, 3] },
    /one of .*link, experiment, gains, generation, not “gai/,
  ],
  [{ type: 'pause', toString: 1 }, /^a field of pause must be one of ep, type, id, not “toString”$/],
  // What was given is named as the core names it.
  [{ type: 'step', generations: null }, /not null$/],
  [{ type: 'step', generations: {} }, /not an object$/],
  [{ type: 'set', experiment: {}, gains: [1, 2] }, /not an array of 2$/],
  [{ type: ['read'] }, /not an array of 1$/],
];

test('what a figure may be told is looked at field by field, and what is wrong is named', () => {
  for (const [message, said] of right) {
    const read = messageIn({ ep: 1, ...message });
    assert.equal(read.type, message.type);
    assert.deepEqual({ ...read.said, ...said }, read.said);
  }
  for (const [message, said] of wrong)
    assert.throws(
      () => messageIn({ ep: 1, ...message }),
      ({ message: text }) => said.test(text) && text.length < 200,
      String(said),
    );
  for (const other of [null, undefined, 7, 'ep', [], {}, new Map([['ep', 1]])])
    assert.ok(!isForFigure(other));
  // An id that cannot come back is left out.
  assert.deepEqual(idIn({ id: () => {} }), {});
  for (const id of [0, 'a', null, { of: [1] }]) assert.deepEqual(idIn({ id }), { id });
});

test('a figure comes as far as a link can say, and a step beyond is answered by why', async () => {
  const run = 'lab&v=1&horizon=0.05&population=1';
  const { messages, asked, said } = figureOf({ link: `${run}&generation=99998` });
  await messages.ready();
  for (const generations of [10, 1]) {
    const { type, message } = await asked({ type: 'step', generations });
    assert.equal(type, 'error');
    assert.equal(message, 'generation must be a whole number from 0 to 100000, not 100001');
    const { link, ...state } = await asked({ type: 'read' });
    assert.deepEqual([state.generation, state.generations], [100_000, 100_000]);
    // What it writes it reads again.
    assert.equal(link, `${run}&generation=100000`);
    assert.deepEqual(links.openLink(link, createEngine()).problems, []);
    messageIn({ ep: 1, type: 'set', experiment: state.experiment, generation: state.generations });
  }
  const told = said.filter(({ type }) => type === 'generation').map(({ generation }) => generation);
  assert.deepEqual(told.slice(-2), [99_999, 100_000]);
});

pageTest('hostile messages are refused one by one, and the figure goes on', async (page) => {
  await inHost(page, frameOf(page, 'lab&v=1&seed=7'), async () => {
    await page.evaluate(() => {
      const figure = document.querySelector('iframe')?.contentWindow;
      const { port1, port2 } = new MessageChannel();
      const cyclic = /** @type {Record<string, unknown>} */ ({ ep: 1, type: 'set', id: 'cyclic' });
      cyclic.experiment = cyclic;
      const long = 'x'.repeat(1e6);
      figure?.postMessage({ ep: 1, type: 'read', id: port1, port: port2 }, '*', [port1, port2]);
      for (const message of [
        cyclic,
        { ep: 1, type: 'set', id: 'long', link: long },
        { ep: 1, type: 'set', id: 'long name', experiment: { [long]: 1 } },
        { ep: 1, type: 'set', id: 'long word', experiment: { law: long } },
        { ep: 1, type: 'set', id: 'hole', experiment: { starts: new Array(1e7) } },
        { ep: 1, type: 'set', id: 'map', experiment: new Map([['law', 'kanayama']]) },
        { ep: 1, type: 'set', id: 'big', experiment: { evolution: { seed: 7n } } },
        { ep: 1, type: 'set', id: 'buffer', experiment: new ArrayBuffer(8) },
        { ep: long, type: 'read', id: 'version' },
        { ep: 1, type: long, id: 'type' },
      ])
        figure?.postMessage(message, '*');
      for (let i = 0; i < 2000; i += 1) figure?.postMessage({ ep: 1, type: 'read', id: `flood ${i}` }, '*');
    });
    await ask(page, 0, { type: 'set', link: 'lab&v=1&seed=7' });
    // What only reads is answered beside the rest.
    await page.until(
      'each of the flood is answered',
      () =>
        /** @type {{ heard: import('../harness/host.js').Heard[] }} */ (
          /** @type {unknown} */ (window)
        ).heard.filter(({ data }) => String(data.id).startsWith('flood')).length === 2000,
    );
    const heard = await heardFrom(page, 0);
    /** @param {string} id */
    const answerTo = (id) => heard.find((one) => one.id === id);
    for (const id of [
      'cyclic',
      'long name',
      'long word',
      'hole',
      'map',
      'big',
      'buffer',
      'version',
      'type',
    ]) {
      assert.equal(answerTo(id)?.type, 'error', id);
      assert.ok(answerTo(id).message.length <= 601, id);
    }
    assert.equal(answerTo('long').problems.length > 0, true);
    assert.equal(heard.filter(({ id }) => String(id).startsWith('flood')).length, 2000);
    const { hash } = await ask(page, 0, { type: 'step', generations: 3 });
    assert.equal(hash, evolve(experiment({ evolution: { seed: 7 } }), 3).hash);
  });
});

engineTest('only who holds the frame is heard, whatever its origin', async (page) => {
  await inHost(page, frameOf(page, 'lab&v=1&seed=7'), async () => {
    // A page of another origin within the host, and a window without one within the figure's own.
    await page.evaluate(async () => {
      const say = `for (const one of [parent[0], top[0]]) one.postMessage({ ep: 1, type: 'set', link: 'lab&seed=66', id: 'foreign' }, '*')`;
      for (const sandbox of ['allow-scripts', 'allow-scripts allow-same-origin']) {
        const other = document.createElement('iframe');
        other.setAttribute('sandbox', sandbox);
        other.srcdoc = `<script>${say}</script>`;
        document.body.append(other);
        await new Promise((resolve) => other.addEventListener('load', resolve));
      }
    });
    const { experiment: still } = await ask(page, 0, { type: 'read' });
    assert.equal(still.evolution.seed, 7);
    assert.deepEqual(
      (await heardFrom(page, 0)).filter(({ id }) => id === 'foreign'),
      [],
    );
    // Who embeds learns from where a message is.
    const origins = await page.evaluate(() =>
      /** @type {{ heard: import('../harness/host.js').Heard[] }} */ (
        /** @type {unknown} */ (window)
      ).heard.map(({ origin }) => origin),
    );
    assert.deepEqual([...new Set(origins)], [new URL(page.site.address).origin]);
    // In the host the added frames are not figures.
    await page.evaluate(() => {
      for (const frame of [...document.querySelectorAll('iframe[sandbox]')]) frame.remove();
    });
  });
});

/** Goals that no robot reaches: a worker drives all the samples. */
const heavy = { goal: { x: 90, y: 90, theta: 0 }, horizon: 30, sampleTime: 0.001 };

pageTest('an answer waits for a drive that takes long, and is of what was set', async (page) => {
  await inHost(page, frameOf(page, 'lab&v=1'), async () => {
    const gains = /** @type {const} */ ([4, 1, 6]);
    const set = await ask(page, 0, { type: 'set', experiment: heavy, gains });
    const whole = experiment(heavy);
    const { cost, arrived, finalTime } = simulate(whole, [...gains]);
    assert.deepEqual(set.drive, { gains, cost: { ...cost }, arrived, finalTime });
    const other = { ...heavy, goal: { x: 80, y: 90, theta: 0 } };
    const link = await ask(page, 0, { type: 'set', experiment: other, gains });
    assert.equal(link.drive.cost.total, simulate(experiment(other), [...gains]).cost.total);
  });
});

/** What waits to be called in a page: frames, and timers. @type {string} */
const counting = `(() => {
  const waiting = { frames: new Set(), timers: new Set(), intervals: new Set(), calls: 0 };
  Object.defineProperty(window, 'waiting', { value: waiting });
  const wrap = (set, clear, list, again) => {
    const [begin, end] = [window[set].bind(window), window[clear].bind(window)];
    window[set] = (act, ...rest) => {
      // So long one driver waits for its own scripts.
      if (rest[0] === ${patience}) return begin(act, ...rest);
      waiting.calls += 1;
      const id = begin((...given) => {
        if (!again) waiting[list].delete(id);
        return act(...given);
      }, ...rest);
      waiting[list].add(id);
      return id;
    };
    window[clear] = (id) => { waiting[list].delete(id); end(id); };
  };
  wrap('requestAnimationFrame', 'cancelAnimationFrame', 'frames', false);
  wrap('setTimeout', 'clearTimeout', 'timers', false);
  wrap('setInterval', 'clearInterval', 'intervals', true);
})();`;

pageTest('five figures on one page: at rest none asks for a frame or a time', async (page) => {
  const site = await serve(undefined, { before: counting });
  try {
    const links = ['lab&v=1&seed=7', 'generation&v=1', 'curves&v=1', 'landscape&v=1', 'lesson&step=3'];
    const html = links
      .map(
        (link) =>
          `<iframe src="${site.address}?embed#${link.replaceAll('&', '&amp;')}" width="400" height="300"></iframe>`,
      )
      .join('');
    await inHost(page, html, async () => {
      // Asked from outside, for who waits within a page asks it for frames.
      const { driver } = page;
      /** @param {number} i @param {string} script @returns {Promise<any>} */
      const inFrame = async (i, script) => {
        await driver.switchTo().defaultContent();
        await driver.switchTo().frame(i);
        return driver.executeScript(`return ${script}`);
      };
      const resting = `document.querySelector('[aria-busy="true"]') === null &&
        waiting.frames.size + waiting.timers.size + waiting.intervals.size === 0 && waiting.calls`;
      /** What the figure has asked for, once frames of the host go by without another call: a size is told only with a frame. @param {number} i */
      const restOf = async (i) => {
        const calls = await inFrame(i, resting);
        await driver.switchTo().defaultContent();
        await driver.executeScript(
          'return (async () => { for (let i = 0; i < 30; i++) await new Promise(requestAnimationFrame); })()',
        );
        return calls && calls === (await inFrame(i, resting)) && calls;
      };
      for (const [i, link] of links.entries())
        await driver.wait(() => restOf(i), patience, `${link} comes to rest`);
      await driver.switchTo().defaultContent();
    });
  } finally {
    await page.leave();
    await site.close();
  }
});
