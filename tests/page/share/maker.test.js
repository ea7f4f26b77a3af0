// The panel in which a lecturer makes an exercise: quick hands, every field, and a part whose answers cannot be handed in.
import assert from 'node:assert/strict';
import { copyFile, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { groupNames } from '../../../www/run/exercise.js';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { within } from '../harness/host.js';
import { follow } from '../whole/surround.js';
import { openMaker } from './making.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page */
const linkMade = (page) =>
  page.evaluate(
    () =>
      /** @type {HTMLInputElement | null} */ (document.getElementById('maker-link'))?.value.split('#')[1] ??
      '',
  );

pageTest('what is pressed and typed within one frame is all kept', async (page) => {
  await openMaker(page);
  await page.evaluate(() => {
    for (const id of [
      'maker-gains-locked',
      'maker-run-hidden',
      'maker-seed-locked',
      'maker-vary-goal',
      'maker-vary-seed',
    ])
      document.getElementById(id)?.click();
    const task = /** @type {HTMLTextAreaElement} */ (document.getElementById('maker-task'));
    task.value = 'Park.';
    task.dispatchEvent(new Event('input', { bubbles: true }));
  });
  assert.match(
    await linkMade(page),
    /&lock=gains,seed&hide=run&task=Park\.&vary=goal%2Cseed$|&lock=gains,seed&hide=run&task=Park\.&vary=goal,seed$/,
  );
});

pageTest('its link has the generation that is still on its way', async (page) => {
  await openMaker(page);
  await follow(page, 'lab&v=1&generation=99999');
  await page.until('it is on its way', () => document.getElementById('computing')?.checkVisibility());
  assert.match(await linkMade(page), /&generation=99999(&|$)/);
});

pageTest(
  'another exercise that is made of one that was opened is there again when it was closed',
  async (page) => {
    await openMaker(page, '#lab&v=1&task=Old&lock=run');
    const typed = (/** @type {string | null} */ text) =>
      page.evaluate((to) => {
        const task = /** @type {HTMLTextAreaElement} */ (document.getElementById('maker-task'));
        if (to !== null) task.value = to;
        task.dispatchEvent(new Event('input', { bubbles: true }));
        return task.value;
      }, text);
    assert.equal(await typed('New'), 'New');
    // What the open one locks stays so, and it is said how to set it.
    await page.focus('#maker-run-free');
    await page.press(' ');
    await page.until(
      'it is free in the draft',
      () => !/lock=/.test(/** @type {HTMLInputElement} */ (document.getElementById('maker-link')).value),
    );
    assert.match(await page.text('#maker-within'), /open the whole page first/);
    assert.match(await page.text('#exercise-locks'), /Locked by this link: running evolution/);
    assert.equal(await (await page.element('#run')).isEnabled(), false);
    await page.press(Key.ESCAPE);
    await page.until('it is closed', () => !document.getElementById('maker-task')?.checkVisibility());
    await page.click('#keep-button');
    await page.click('#keep-exercise');
    assert.equal(await typed(null), 'New');
  },
);

/** By how much the panel's content is wider than its place, where a scrollbar would cover what is pressed. @param {Page} page */
const sideways = (page) =>
  page.evaluate(() => {
    const groups = /** @type {Element} */ (document.querySelector('#maker .settings-groups'));
    return groups.scrollWidth - groups.clientWidth;
  });

pageTest('every field of the maker has a name and room, and what is wrong is said', async (page) => {
  await openMaker(page);
  assert.equal(await sideways(page), 0);
  await page.focus('#maker-aim');
  // Each kind of aim has the same fields, with other values.
  for (const kind of ['cost', 'parks', 'unseen']) {
    await page.click(`#maker-aim option[value="${kind}"]`);
    await page.until('its fields are there', () => document.getElementById('maker-points-1'));
    assert.deepEqual(await page.obstacles('#maker'), [], kind);
    assert.equal(await sideways(page), 0, kind);
  }
  await page.focus('#maker-value');
  await page.press(Key.BACK_SPACE, Key.BACK_SPACE, Key.BACK_SPACE, '2');
  await page.until('the error is said', () => document.getElementById('maker-aim-error')?.checkVisibility());
  assert.match(await page.text('#maker-aim-error'), /^The share must be above 0 and at most 1/);
  const wrong = () => page.evaluate(() => document.querySelector('#maker [aria-invalid="true"]')?.id);
  assert.equal(await wrong(), 'maker-value');
  assert.deepEqual(await page.obstacles('#maker'), []);
  // What is not in the link is not handed out.
  const taken = () =>
    page.evaluate(() =>
      ['maker-copy-link', 'maker-copy-frame', 'maker-scorm'].filter(
        (id) => !document.getElementById(id)?.matches(':disabled'),
      ),
    );
  assert.deepEqual(await taken(), []);
  await page.press(Key.BACK_SPACE, '9', '0', ' ', '%');
  await page.until('it is right', () => !document.getElementById('maker-aim-error')?.checkVisibility());
  assert.match(await linkMade(page), /&aim=unseen:0\.9$|&aim=unseen%3A0\.9$/);
  assert.equal((await taken()).length, 3);
  await page.click('#maker-copy-link');
  await page.until('it is said', () => document.getElementById('maker-status')?.textContent);
  await page.click('#maker-vary-goal');
  await page.until('and true no more', () => !document.getElementById('maker-status')?.textContent);
  // As students will see it: first they say who they are.
  await page.until('the form is there', () => document.querySelector('#work-begin:disabled'));
  const unnamed = await page.evaluate(() =>
    [
      .../** @type {NodeListOf<HTMLInputElement>} */ (
        document.querySelectorAll('#maker :is(input, select, textarea)')
      ),
    ]
      .filter((field) => !field.labels?.length && !field.ariaLabel)
      .map(({ id }) => id),
  );
  assert.deepEqual(unnamed, []);
  const type = async (/** @type {string} */ id, /** @type {string} */ text) => {
    await page.focus(id);
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).select());
    await page.press(...text, Key.TAB);
  };
  await type('#maker-budget', 'few');
  await page.until('the error is said', () => document.getElementById('maker-aim-error')?.checkVisibility());
  assert.deepEqual(await taken(), []);
  await type('#maker-budget', '40');
  await page.until('it is right', () => !document.getElementById('maker-aim-error')?.checkVisibility());
  assert.match(decodeURIComponent(await linkMade(page)), /&aim=unseen:0\.9;drives<=40&/);
  // A decimal comma is one everywhere.
  for (const [i, text] of ['0,95', '0', '0,8', '7,5'].entries())
    await type(['#maker-at-0', '#maker-points-0', '#maker-at-1', '#maker-points-1'][i], text);
  await page.until('it is right', () => !document.getElementById('maker-aim-error')?.checkVisibility());
  assert.match(decodeURIComponent(await linkMade(page)), /&points=0\.95:0,0\.8:7\.5/);
  await page.click('#maker-aim option[value="none"]');
  await page.until('it asks for nothing', () => !document.getElementById('maker-budget'));
  assert.doesNotMatch(await linkMade(page), /aim=/);
  // What is hidden while it is made, and the button that opened the panel with it.
  for (const group of groupNames) await page.click(`#maker-${group}-hidden`);
  await page.press(Key.ESCAPE);
  await page.until('the panel is closed', () => document.activeElement?.id === 'keep-button');
  assert.deepEqual(await page.problems(), []);
});

pageTest('where no exercise was made the focus stays where it is', async (page) => {
  await page.open('#lab&v=1');
  await page.click('#keep-button');
  await page.until('Share is there', () => document.getElementById('keep-exercise'));
  await page.press(Key.ESCAPE);
  await page.focus('#slider-kx');
  await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'slider-kx');
});

pageTest('what cannot be handed in is not made: Park leads on into the lab', async (page) => {
  await openMaker(page, '#park&v=1');
  // To lock its sliders is no task.
  await page.click('#maker-run-hidden');
  assert.match(await linkMade(page), /^park&v=1&hide=run$/);
  await page.focus('#maker-task');
  await page.press(...'Park all.');
  await page.until('it is refused', () => document.getElementById('maker-refused'));
  assert.match(await page.text('#maker-refused'), /tried in Park cannot be handed in/);
  assert.equal(
    await page.evaluate(() => document.querySelector('#maker-link, #maker-frame, #maker-scorm')),
    null,
  );
  assert.deepEqual(await page.obstacles('#maker'), []);
  await page.click('#maker-to-lab');
  await page.until(
    'the lab is open',
    () => document.body.dataset.open === 'lab' && document.getElementById('maker-link'),
  );
  const link = await linkMade(page);
  assert.match(link, /^lab&v=1&.*&hide=run&task=Park%20all%2E$/);
  assert.equal(decodeURIComponent(/&start=([^&]*)/.exec(link)?.[1] ?? '').split(';').length, 32);
  await page.open(`#${link}`);
  await page.until('it can be handed in', () => document.getElementById('hand-in'));
  assert.deepEqual(await page.problems(), []);
});

engineTest('from the one file on a disk the figure is shown, and the package written', async (page) => {
  const folder = await mkdtemp(join(tmpdir(), 'a disk '));
  try {
    const file = join(folder, 'ep-locomotion.html');
    await copyFile(fileURLToPath(new URL('../../../dist/ep-locomotion.html', import.meta.url)), file);
    await page.visit(`${pathToFileURL(file).href}#lab&v=1&drives=hand&gains=3,0,0`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready);
    await page.click('#keep-button');
    await page.until('Share is there', () => document.getElementById('keep-exercise'));
    // A path on this disk is none on another.
    const handed = () => /** @type {HTMLInputElement} */ (document.getElementById('keep-link')).value;
    assert.match(await page.evaluate(handed), /^ep-locomotion\.html#lab&v=1&drives=hand/);
    assert.match(await page.text('#keep'), /opens in their own copy of it: by adding the #/);
    await page.click('#keep-exercise');
    await page.until('the maker is open', () => document.getElementById('maker-task')?.checkVisibility());
    await page.press(...'Park.');
    await page.click('#maker-preview-size-400x300');
    await page.until('a figure is there', () => document.getElementById('maker-figure'));
    await within(page, 0, async () => {
      await page.until('it is the exercise', () => document.getElementById('task')?.textContent === 'Park.');
      await page.until('it can be handed in', () => document.getElementById('hand-in'));
    });
    assert.match(await page.text('#maker-disk'), /students need the file too/);
    const made = () => /** @type {HTMLInputElement} */ (document.getElementById('maker-link')).value;
    assert.match(await page.evaluate(made), /^ep-locomotion\.html#lab&v=1&drives=hand.*&task=Park/);
    await page.click('#maker-scorm');
    await page.until('it asks for its own file', () => document.getElementById('maker-scorm-file'));
    await (await page.element('#maker-scorm-file')).sendKeys(file);
    await page.until('the package is saved', () =>
      /^The package is saved/.test(document.getElementById('maker-status')?.textContent ?? ''),
    );
  } finally {
    await rm(folder, { recursive: true });
  }
});

pageTest('of an exercise whose link is too long to be kept twice the maker warns', async (page) => {
  await openMaker(page, `#lab&v=1&task=${'%EA%B0%80'.repeat(250)}`);
  const saved = async (/** @type {boolean} */ isLong) => {
    await page.click('#maker-scorm');
    await page.until(
      isLong ? 'it is saved, and warned' : 'it is saved',
      (warned) => {
        const text = document.getElementById('maker-status')?.textContent ?? '';
        return (
          text.startsWith('The package is saved') && /link is long \(2\d{3} characters/.test(text) === warned
        );
      },
      isLong,
    );
  };
  await saved(true);
  await page.focus('#maker-task');
  await page.evaluate(() =>
    /** @type {HTMLTextAreaElement} */ (document.getElementById('maker-task')).select(),
  );
  await page.press(...'Park.');
  await saved(false);
});

pageTest('on a projector the figure that students get stands whole beside the panel', async (page) => {
  await page.resize(1024, 768);
  await openMaker(page);
  await page.click('#maker-preview-size-640x420');
  const around = await page.until('the figure is there', () => {
    const preview = document.getElementById('maker-preview');
    const frame = preview?.querySelector('iframe')?.getBoundingClientRect();
    return frame && preview && { scrolls: preview.scrollWidth > preview.clientWidth, right: frame.right };
  });
  assert.equal(around.scrolls, false);
  assert.ok(around.right <= 1024);
});

pageTest(
  'an exercise that one press would meet says so, until it asks for more or that is taken away',
  async (page) => {
    await openMaker(page, '#lab&v=1&aim=J%3C8');
    const said = () => page.evaluate(() => document.getElementById('maker-easy')?.innerText ?? '');
    await page.until('it is said', () => document.getElementById('maker-easy'));
    assert.match(await said(), /Met already by one press: Paper: EP\. .*“what drives”/);
    await page.click('#maker-drives-locked');
    assert.equal(await said(), '');
    await page.click('#maker-drives-free');
    await page.until('it is said again', () => document.getElementById('maker-easy'));
    await page.click('#maker-paper-hidden');
    assert.equal(await said(), '');
    await page.open('#lab&v=1&generation=60&aim=J%3C7.9');
    await page.click('#keep-button');
    await page.click('#keep-exercise');
    await page.until('of evolution it is said', () =>
      document.getElementById('maker-easy')?.innerText.includes('Evolved best.'),
    );
  },
);
