// The duel on the page: first your own drives until they are locked in, then how the three compare.
import { create, write } from '../kit/elements.js';
import { messageOf } from '../words/errors.js';
import { watch } from '../kit/memo.js';
import { noTrial } from '../run/state.js';
import { isDuelOf, judge, lockedIn, longestOf, lowestOf, nextSeed, roundOf, scoreOf } from './duel.js';
import { createSwatch } from '../kit/swatch.js';
import { createDuelPlot, looks } from './duel-plot.js';
import { progressSlice } from './state.js';
import { paragraphs } from './prose.js';
import { noTally } from './state.js';
import { tallyOf } from './tally.js';

/** @typedef {import('../run/store.js').Store} Store */
/** @typedef {import('./duel.js').Duel} Duel */
/** @typedef {import('./page.js').Block} Block */
/** @typedef {import('./page.js').Live} Live */
/** @typedef {import('./page.js').Tools} Tools */
/** @typedef {Pick<typeof import('../words/en/lesson/duel.js').duel, 'duel' | 'texts'>} Words */

/** Under which name the prediction is kept. */
const prediction = 'duel.ahead';

const { update } = progressSlice;

/** @param {string} id @param {string} className @param {() => void} act */
function button(id, className, act) {
  const element = create('button', className);
  element.id = id;
  element.setAttribute('type', 'button');
  element.addEventListener('click', act);
  return element;
}

/** Your drives so far, and the button that locks them in. @param {Tools} tools @param {Words} words @returns {Block} */
export function createDuelDrives({ store }, { duel: words }) {
  /** @type {Live | null} */
  let live = null;
  const drives = create('strong', '');
  drives.id = 'duel-drives';
  const best = create('strong', '');
  best.id = 'duel-best';
  const status = create('p', 'muted');
  status.id = 'duel-status';
  const lock = button('duel-lock', 'primary', () => {
    if (live) update(store, { duel: lockedIn(tallyIn(live), live.scene.experiment) });
  });
  const again = button('duel-new', '', () => {
    const { [prediction]: _, ...answers } = progressSlice.of(store.get()).answers;
    update(store, { answers, tally: noTally, duel: null });
  });
  write(lock, words.lock);
  write(again, words.startOver);
  const element = create(
    'section',
    'duel',
    create(
      'div',
      'duel-numbers',
      create('p', 'duel-number', create('span', '', words.drivesName), drives),
      create('p', 'duel-number', create('span', '', words.bestName), best),
    ),
    status,
    create('div', 'bar', lock, again),
  );
  element.setAttribute('aria-label', words.drivesLabel);
  const changed = watch();
  return {
    element,
    draw(now) {
      live = now;
      const { duel } = progressSlice.of(now.state);
      const tally = tallyIn(now);
      const { population } = now.state.experiment.evolution;
      const here = duel !== null && isDuelOf(duel, now.scene.experiment);
      if (!changed(duel, tally, population, here)) return;
      const costs = duel?.costs ?? tally.costs;
      write(drives, String(costs.length));
      write(best, costs.length === 0 ? '…' : words.cost(lowestOf(costs)));
      write(status, duel ? (here ? words.locked : words.elsewhere) : words.enough(costs.length, population));
      element.classList.toggle('locked', duel !== null);
      lock.hidden = duel !== null;
      /** @type {HTMLButtonElement} */ (lock).disabled = costs.length === 0;
      again.hidden = costs.length === 0;
    },
  };
}

/** @param {Live} live */
const tallyIn = ({ state, scene }) => tallyOf(progressSlice.of(state).tally, scene.experiment);

/** What is locked in, or what the prediction locks in. @param {Live} live @returns {Duel} */
export const duelIn = (live) =>
  progressSlice.of(live.state).duel ?? lockedIn(tallyIn(live), live.scene.experiment);

/** How the three compare, once it is predicted. @param {Tools} tools @param {Words} words @returns {Block} */
export function createDuelResult({ store, engine, actions }, { duel: words, texts }) {
  const rounds = createRounds({ store, engine, actions });
  const newest = () => {
    const { duel } = progressSlice.of(store.get());
    const round = duel?.rounds.at(-1);
    return duel && round ? { duel, verdict: judge(duel, round) } : null;
  };
  const caption = create('caption', '');
  const body = create('tbody', '');
  const heads = words.heads.map((text) => {
    const head = create('th', '', text);
    head.setAttribute('scope', 'col');
    return head;
  });
  const table = create('table', 'duel-table', caption, create('thead', '', create('tr', '', ...heads)), body);
  table.id = 'duel-table';
  const sentence = create('p', 'duel-sentence');
  sentence.id = 'duel-sentence';
  sentence.setAttribute('role', 'status');
  const later = create('p', '');
  later.id = 'duel-later';
  later.setAttribute('role', 'status');
  const picture = create('div', 'duel-plot');
  picture.id = 'duel-plot';
  picture.setAttribute('role', 'img');
  const further = button('duel-further', 'primary', () => {
    const { duel } = progressSlice.of(store.get());
    if (duel) update(store, { duel: { ...duel, goesOn: !duel.goesOn } });
  });
  const again = button('duel-again', '', () => rounds.run());
  const watchIt = button('duel-watch', '', () => {
    const shown = newest();
    if (!shown) return;
    const { experiment } = shown.duel;
    const { seed, generation } = shown.verdict;
    const { page, lesson, preset, handGains, found, pins, exercise } = store.get();
    actions.openLinked(
      {
        ...{ page, lesson, preset, handGains, found, pins, exercise, generation, parts: {} },
        experiment: { ...experiment, evolution: { ...experiment.evolution, seed } },
        driver: 'evolved',
        trial: noTrial,
      },
      [],
    );
  });
  write(again, words.anotherSeed);
  const score = create('p', 'muted');
  score.id = 'duel-score';
  const result = create(
    'section',
    'duel',
    table,
    sentence,
    later,
    picture,
    create('div', 'bar', further, again, watchIt),
    score,
  );
  result.setAttribute('aria-label', words.resultLabel);
  // What follows from it would give the answer away.
  const after = create('div', 'prose', ...paragraphs(texts.after, (link) => `#${link}`));
  const element = create('div', 'duel-result', result, after);
  element.hidden = true;
  const plot = createDuelPlot(picture, words);
  const changed = watch();
  return {
    element,
    draw(live) {
      const { theme, evolving } = live.state;
      const progress = progressSlice.of(live.state);
      const predicted = progress.answers[prediction] !== undefined;
      if (predicted && !evolving) rounds.begin(duelIn(live));
      const { duel } = progress;
      const round = duel?.rounds.at(-1);
      if (!changed(duel, predicted, theme)) return;
      element.hidden = !predicted || !duel || !round;
      if (!predicted || !duel || !round) return;
      const verdict = judge(duel, round);
      write(caption, words.caption(verdict));
      body.replaceChildren(...rowsOf(verdict, words));
      write(sentence, words.sentence(verdict));
      write(later, duel.goesOn ? words.later(verdict) : '');
      write(further, duel.goesOn ? words.backTo(verdict.drives) : words.goOn(longestOf(duel)));
      write(watchIt, words.watch(verdict));
      write(score, words.score(duel.rounds.length, scoreOf(duel)));
      picture.setAttribute('aria-label', words.plotLabel(`${sentence.textContent} ${later.textContent}`));
      plot.draw(duel, theme);
    },
  };
}

/** The three, lowest J first. @param {import('./duel.js').Verdict} verdict @param {Words['duel']} words */
function rowsOf({ costs, drives, given, winner }, words) {
  return /** @type {const} */ (['you', 'evolution', 'random'])
    .map((name) => ({ name, cost: costs[name], driven: name === 'you' ? drives : given }))
    .sort((a, b) => a.cost - b.cost)
    .map(({ name, cost, driven }) => {
      const who = create('th', '', createSwatch(looks[name]), words.names[name]);
      who.setAttribute('scope', 'row');
      const wins = name === winner || (winner === 'both' && name !== 'you');
      const row = create(
        'tr',
        wins ? 'wins' : '',
        who,
        create('td', '', String(driven)),
        create('td', 'cost', words.cost(cost)),
      );
      row.dataset.who = name;
      return row;
    });
}

/** Asks the workers for evolution and random search. @param {Pick<Tools, 'store' | 'engine' | 'actions'>} tools */
function createRounds({ store, engine, actions }) {
  /** @type {Duel | null} */
  let asked = null;
  /** @param {Duel} duel */
  const ask = async (duel) => {
    if (asked === duel) return;
    asked = duel;
    try {
      const round = await roundOf(engine, duel, nextSeed(duel));
      if (progressSlice.of(store.get()).duel === duel)
        update(store, { duel: { ...duel, rounds: [...duel.rounds, round] } });
    } catch (error) {
      asked = null;
      actions.say(messageOf(error));
    }
  };
  return {
    /** Locks in, and runs the first seed. @param {Duel} duel */
    begin(duel) {
      if (duel.rounds.length > 0) return;
      if (progressSlice.of(store.get()).duel !== duel) update(store, { duel });
      ask(duel);
    },
    run() {
      const { duel } = progressSlice.of(store.get());
      if (duel) ask(duel);
    },
  };
}
