// What the address bar says, and what it opens.
import assert from 'node:assert/strict';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { pageNames, places } from '../../../www/parts/parts.js';
import { holdWorkers } from '../harness/workers.js';
import { evolve, experiment, paperGains, shown, shownGains, simulate } from '../harness/core.js';
import { read, readEvolution } from '../harness/reading.js';

const velocityLimits = experiment('velocity-limits');
const link = 'lab&v=1&goal.x=1.5&goal.theta=30deg&seed=7&generation=24&drives=hand&gains=4,0.5,6';

pageTest('a link opens the same run, and the address goes on telling what is on screen', async (page) => {
  await page.open(`#${link}`);
  const goal = { x: 1.5, y: 2, theta: (30 * Math.PI) / 180 };
  const moved = { ...velocityLimits, goal, evolution: { ...velocityLimits.evolution, seed: 7 } };
  const byHand = simulate(moved, [4, 0.5, 6]);
  assert.deepEqual(await readEvolution(page), {
    generation: '24',
    seed: '7',
    cost: shown(byHand.cost.total),
    gains: shownGains([4, 0.5, 6]),
  });
  await page.click('#drives-evolved');
  assert.deepEqual(await readEvolution(page), { generation: '24', seed: '7', ...evolve(moved, 24).shown });
  await page.until('the address is new', () => !location.hash.includes('drives='));
  await page.focus('#one-generation');
  await page.press(Key.ENTER);
  await page.until('the address has generation 25', () => location.hash.includes('generation=25'));
  const address = await page.evaluate(() => location.hash);
  assert.equal(address, '#lab&v=1&goal.x=1.5&goal.theta=30deg&seed=7&generation=25&gains=4,0.5,6');
  await page.open(address);
  assert.deepEqual(await readEvolution(page), { generation: '25', seed: '7', ...evolve(moved, 25).shown });
  assert.deepEqual(await page.problems(), []);
});

engineTest('another part of the page is a step that back takes back, and nothing is lost', async (page) => {
  await page.click('#drives-paper-ep');
  await page.click('#one-generation');
  await page.click('#page-landscape');
  await page.until('the address names the landscape', () => location.hash.startsWith('#landscape&'));
  await page.evaluate(() => history.back());
  await page.until('the lab is open', () => document.body.dataset.open === 'lab');
  const { driver, generation, cost } = await read(page);
  const run = simulate(velocityLimits, paperGains('velocity-limits', 'ep'));
  assert.deepEqual(
    { driver, generation, cost },
    { driver: 'paper-ep', generation: '1', cost: shown(run.cost.total) },
  );
  await page.evaluate(() => history.forward());
  await page.until('the landscape is open', () => document.body.dataset.open === 'landscape');
});

pageTest('back leads to the start, and to what pushes, that were tried there', async (page) => {
  await page.open('#robustness&v=1&from=1,0,90deg');
  await page.click('#page-disturbance');
  await page.until('what pushes is told', () => /under=/.test(location.hash));
  await page.click('#page-curves');
  await page.until('the curves are open', () => location.hash.startsWith('#curves'));
  for (const tried of ['#disturbance&v=1&under=slip,0.1,0.2,1', '#robustness&v=1&from=1,0,90deg']) {
    await page.evaluate(() => history.back());
    await page.until(
      tried,
      (link) => document.body.dataset.open === /\w+/.exec(link)?.[0] && location.hash === link,
      tried,
    );
  }
});

pageTest('from every kind of part each link at the head leads where a press leads', async (page) => {
  const wayTo = (/** @type {string} */ name) =>
    page.evaluate((name) => document.getElementById(`page-${name}`)?.getAttribute('href') ?? '', name);
  // Of the part that is open, links and presses ask what can be tried there.
  const kinds = new Map(
    pageNames.map((name) => [`${places.triesStarts(name)} ${places.triesDisturbance(name)}`, name]),
  );
  await page.open('#lab&v=1');
  for (const from of kinds.values()) {
    let own = `#${from}&v=1&generation=2&gains=3,1,5&under=random,0.3,0.2,3&from=1,1,0deg`;
    for (const name of [...pageNames, 'lesson']) {
      await page.evaluate((own) => {
        location.hash = own;
      }, own);
      // As the page writes it.
      own = await page.until(
        `all is of ${from}`,
        (from) =>
          document.body.dataset.open === from &&
          document.getElementById(`page-${from}`)?.getAttribute('href') === location.hash &&
          location.hash,
        from,
      );
      const link = await wayTo(name);
      await page.click(`#page-${name}`);
      await page.until(`${from}: ${link} is open`, (link) => location.hash === link, link);
    }
  }
});

pageTest(
  'while evolution runs the address goes with it: who loads the page again loses little',
  async (page) => {
    await page.open('#lab&v=1');
    await page.click('#pace option:nth-child(2)');
    const atRest = await page.text('#run');
    await page.click('#run');
    await page.until(
      'it is written on the way',
      (run) =>
        /generation=[1-9]/.test(location.hash) && document.getElementById('run')?.textContent?.trim() !== run,
      atRest,
    );
  },
);

pageTest(
  'while a generation is computed in a worker, the address goes on telling what is set',
  async (page) => {
    await page.open('#lab&v=1&population=1200');
    // Its first generation, and the drives of that, come from workers too.
    await page.until('the experiment has begun', () =>
      /1200/.test(document.getElementById('evolution-note')?.textContent ?? ''),
    );
    await holdWorkers(page);
    await page.click('#one-generation');
    await page.until('it is computed', () => document.querySelector('#computing:not([hidden])'));
    await page.focus('#gain-ky');
    await page.press('4', Key.ENTER);
    await page.until('the gains are in the address', () => /drives=hand&gains=/.test(location.hash));
    assert.ok(await page.evaluate(() => document.querySelector('#computing:not([hidden])')));
  },
);

pageTest('what was set before something that never began is in the address', async (page) => {
  await page.open('#lab&v=1&population=1200&gains=3,0.1,5');
  await page.click('#drives-paper-ep');
  // What is pressed from now on, the address waits for anew.
  await page.until('the address is written', () => location.hash.includes('drives=paper-ep'));
  await holdWorkers(page);
  await page.evaluate(async () => {
    const { setTimeout } = window;
    /** @type {(() => void)[]} */
    const acts = [];
    // Of the address, and not of a frame that comes late.
    window.setTimeout = /** @type {any} */ (
      (/** @type {() => void} */ act, /** @type {number} */ after) =>
        after > 200 ? acts.push(act) : setTimeout(act, after)
    );
    document.getElementById('drives-hand')?.click();
    while (acts.length === 0) await new Promise(requestAnimationFrame);
    document.getElementById('new-seed')?.click();
    window.setTimeout = setTimeout;
    for (const act of acts) act();
  });
  await page.until('it begins', () => document.querySelector('#computing:not([hidden])'));
  await page.press(Key.ESCAPE);
  await page.until('it is in the address', () => location.hash.includes('drives=hand'));
});

pageTest('a link that is not written as the page writes it leaves nothing to go back to', async (page) => {
  for (const asked of ['lesson', 'lesson&step=3', 'lab&amp;lesson=2', 'landscape?name=value']) {
    const { blank } = page.site;
    await page.visit(blank);
    await page.visit(`${page.site.address}#${asked}`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.until('the address is the link of what is open', () =>
      /^#landscape$|&v=1/.test(location.hash),
    );
    await page.driver.navigate().back();
    await page.until(`back leads away from ${asked}`, (address) => location.href === address, blank);
  }
});

pageTest('a link with something wrong says what, and opens the rest', async (page) => {
  await page.open('#lab&seed=7&goal.x=1000000&flavour=red');
  const message = await page.text('#message');
  assert.match(message, /goal\.x must be/);
  assert.match(message, /flavour.*no such setting/);
  const { seed, generation } = await read(page);
  assert.deepEqual({ seed, generation }, { seed: '7', generation: '0' });
});

pageTest('Escape takes the cursor of a map away, and only then stops what a link waits for', async (page) => {
  await page.visit(`${page.site.address}#landscape&v=1&generation=99999`);
  const isWaiting = () => document.getElementById('computing')?.checkVisibility();
  await page.until('it waits', isWaiting);
  await page.focus('#landscape-map');
  await page.press(Key.ARROW_RIGHT, Key.ESCAPE);
  // What Escape stops is no longer waited for at once.
  assert.equal(await page.evaluate(isWaiting), true);
  assert.equal(await page.text('#message'), '');
  await page.press(Key.ESCAPE);
  await page.until('it has stopped', () =>
    /^Stopped/.test(document.getElementById('message')?.textContent ?? ''),
  );
});

pageTest('a link far into a run says how far it has come, and Escape leaves it there', async (page) => {
  await page.visit(`${page.site.address}#lab&v=1&generation=99999`);
  const said = await page.until('it says how far it is', () => {
    const line = document.getElementById('computing');
    return line?.checkVisibility() && line.innerText;
  });
  assert.match(said, /^Evolution catches up: generation \d+ of 99999\. Stop \(Esc\)/);
  await page.press(Key.ESCAPE);
  const message = await page.until('it has stopped', () => {
    const line = document.getElementById('computing');
    return line?.hidden && document.getElementById('message')?.textContent;
  });
  const [, stopped] = /^Stopped at generation (\d+): what has been computed stays\.$/.exec(message) ?? [];
  assert.ok(Number(stopped) > 0 && Number(stopped) < 99_999, message);
  assert.equal(await page.text('#generation'), stopped);
});

pageTest(
  'where a browser refuses an address the link opens all the same, and is written later',
  async (page) => {
    await page.open('#lesson&step=drive');
    // The page may have written it anew.
    const address = await page.evaluate(() => {
      const { replaceState, pushState } = history;
      const refuse = () => {
        throw new DOMException('Attempt to use history more than 100 times per 30 seconds', 'SecurityError');
      };
      Object.assign(history, { replaceState: refuse, pushState: refuse });
      Object.assign(window, { allow: () => Object.assign(history, { replaceState, pushState }) });
      return location.hash;
    });
    const title = await page.text('#lesson-title');
    await page.click('.step-on');
    await page.until(
      'the next step is there',
      (before) => ![before, ''].includes(document.getElementById('lesson-title')?.innerText ?? ''),
      title,
    );
    await page.click('#page-lab');
    await page.until('the lab is there', () => document.getElementById('one-generation')?.checkVisibility());
    assert.equal(await page.evaluate(() => location.hash), address);
    await page.evaluate(() => /** @type {any} */ (window).allow());
    await page.until('it is written', () => /^#lab(?!.*lesson=)/.test(location.hash));
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('back from the lesson leads to all that the lab had come to', async (page) => {
  await page.open('#lab&v=1');
  // At once, before the address has followed by itself.
  await page.evaluate(() => {
    document.getElementById('one-generation')?.click();
    document.getElementById('page-lesson')?.click();
  });
  await page.until(
    'the lesson is open',
    () => document.body.dataset.open === 'lesson' || /lesson/.test(location.hash),
  );
  await page.evaluate(() => history.back());
  await page.until('its generation is there', () => /^#lab&.*generation=1(&|$)/.test(location.hash));
});
