// What a lecturer sees of the sheet on which hand-ins are checked: room, focus, pins, and what is no longer true.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { holdWorkers } from '../harness/workers.js';
import { follow } from '../whole/surround.js';
import { cells, checked, openCollect, openSheet, paste, stripSays } from './hand-in-sheet.js';
import { exercise, handedIn, site } from './hand-ins.js';

/** Checks hand-ins without receipts, each with another kx. @param {import('../harness/browsers.js').Page} page @param {readonly string[]} names */
async function checkClass(page, names) {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const plain = link.split('&handin=')[0];
  await openSheet(page);
  await paste(
    page,
    names.map((name, i) => `${name}, ${site}#${plain.replace('3.3,', `${3 + i / 10},`)}`).join('\n'),
  );
  await page.click('#collect-check');
  await checked(page, names.length);
}

pageTest(
  'the focus stays where a table is sorted or a run is pinned, of which there are four at most',
  async (page) => {
    const names = ['Ann', 'Bob', 'Cid', 'Dan', 'Eve'];
    await checkClass(page, names);
    const [histogram, gains] = await page.evaluate(() =>
      ['collect-histogram', 'collect-gains'].map((id) => document.getElementById(id)?.ariaLabel ?? ''),
    );
    assert.match(histogram, /: 5, from J [\d.]+ to [\d.]+, half of them at most [\d.]+$/);
    assert.match(gains, /: kx from 3\.00 to 3\.40, kθ from 4\.50 to 4\.50$/);
    await page.focus('[data-sort="cost"]');
    for (const sorted of ['ascending', 'descending']) {
      await page.press(Key.ENTER);
      assert.deepEqual(
        await page.evaluate(() => {
          const head = document.activeElement?.closest('th');
          return [head?.textContent?.slice(0, 1), head?.ariaSort];
        }),
        ['J', sorted],
      );
    }
    const pin = async (/** @type {string} */ name) => {
      const box = `[aria-label="Pin the run of ${name}"]`;
      await page.focus(box);
      await page.press(' ');
      return page.evaluate(
        (selector) =>
          document.activeElement?.matches(selector) &&
          /** @type {HTMLInputElement} */ (document.activeElement).checked,
        box,
      );
    };
    for (const name of names.slice(0, 4)) assert.equal(await pin(name), true, name);
    assert.equal(await pin('Eve'), false);
    assert.match(await page.text('#collect-note'), /^Not pinned: Eve\. 4 drives are pinned/);
    assert.equal(await pin('Bob'), false);
    assert.equal(await pin('Eve'), true);
    assert.match(await page.text('#collect-status'), /^5 hand-ins/);
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('back from a hand-in leads to the link that was still to begin', async (page) => {
  await checkClass(page, ['Ann']);
  await page.press(Key.ESCAPE);
  await holdWorkers(page);
  await follow(page, 'lab&v=1&population=1500&seed=8');
  await page.until('it begins', () => document.querySelector('#computing:not([hidden])'));
  await openCollect(page);
  await page.click('button[data-open]');
  await page.until('the hand-in is open', () => location.hash.includes('gains='));
  await page.evaluate(() => history.back());
  await page.until('it is back', () => !location.hash.includes('gains='));
  assert.equal(await page.evaluate(() => location.hash), '#lab&v=1&population=1500&seed=8');
});

pageTest('what is typed, or sorted, draws no chart anew', async (page) => {
  await checkClass(page, ['Ann', 'Bob', 'Cid']);
  const drawn = await page.evaluate(() => {
    const { Path2D } = window;
    let count = 0;
    window.Path2D = class extends Path2D {
      constructor(/** @type {any} */ d) {
        super(d);
        count += 1;
      }
    };
    document.getElementById('collect-text')?.dispatchEvent(new Event('input'));
    /** @type {HTMLElement | null} */ (document.querySelector('[data-sort="remark"]'))?.click();
    window.Path2D = Path2D;
    return count;
  });
  assert.equal(drawn, 0);
});

pageTest('what was found has the room of the window, and nothing of it is cut', async (page) => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const plain = link.split('&handin=')[0];
  await openSheet(page);
  const own = [0, 1, 2, 3].map((i) => plain.replace('3.3,0,4.5', `${3 + i / 10},0,4.5`)).join('\n');
  await paste(page, `${own}\n${'I could not.\n'.repeat(126)}`);
  await page.click('#collect-check');
  await checked(page, 130);
  for (const [width, height, share] of [
    [1920, 1080, 0.6],
    [1440, 900, 0.55],
    [1024, 768, 0.3],
    [390, 844, 0.5],
  ]) {
    await page.resize(width, height);
    await page.until(
      `the table has its share at ${width}`,
      (most) => {
        const table = document.querySelector('#collect .table-scroll');
        return (table?.getBoundingClientRect().height ?? 0) > most * innerHeight;
      },
      share,
    );
    const buttons = await page.evaluate(() =>
      [...document.querySelectorAll('#collect button')]
        .filter((button) => !button.closest('.table-scroll') && button.checkVisibility())
        .map((button) => {
          const { right } = button.getBoundingClientRect();
          return {
            id: button.id,
            isCut: right > innerWidth - 16 || button.scrollWidth > button.clientWidth + 1,
          };
        }),
    );
    assert.ok(buttons.length > 2);
    assert.deepEqual(
      buttons.filter(({ isCut }) => isCut),
      [],
    );
  }
});

pageTest(
  'a wrong link of the exercise ends what was checked by another, and another class begins empty',
  async (page) => {
    const { link } = await handedIn('s1', [3.3, 0, 4.5]);
    const ask = (/** @type {string} */ text) =>
      page.evaluate((value) => {
        /** @type {HTMLInputElement} */ (document.getElementById('collect-exercise')).value = value;
      }, text);
    const shown = () =>
      page.evaluate(() =>
        ['#collect-cancel', '#collect-csv', '#collect-empty'].map((one) =>
          document.querySelector(one)?.checkVisibility(),
        ),
      );
    await openSheet(page);
    assert.deepEqual(await shown(), [false, false, false]);
    await paste(page, `${link}\n${link}`);
    await page.click('#collect-check');
    await checked(page, 2);
    assert.deepEqual(await shown(), [false, true, true]);
    await ask('http://localhost:8140/');
    await page.click('#collect-check');
    const said = 'The link of the exercise cannot be read: this address holds no exercise.';
    assert.ok((await page.text('#collect-status')).startsWith(said));
    assert.ok(!(await page.text('#collect-status')).includes('Judged by'));
    assert.deepEqual(await shown(), [false, false, true]);
    // While one runs: within one turn of the page.
    await ask('');
    await page.evaluate(() => {
      const field = /** @type {HTMLInputElement} */ (document.getElementById('collect-exercise'));
      document.getElementById('collect-check')?.click();
      field.value = 'rubbish';
      document.getElementById('collect-check')?.click();
    });
    assert.match(await page.text('#collect-status'), /cannot be read: .*rubbish/);
    assert.deepEqual(await shown(), [false, false, true]);
    await page.click('#collect-empty');
    assert.deepEqual(await shown(), [false, false, false]);
    assert.equal(await page.text('#collect-status'), '');
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('the exercise that is open is asked for, unless another was typed', async (page) => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const other = exercise.replace('7.9', '7.7');
  const field = () =>
    page.evaluate(() => /** @type {HTMLInputElement} */ (document.getElementById('collect-exercise')).value);
  /** Within the same page. @param {string} hash @param {string} task */
  const goTo = async (hash, task) => {
    await page.click('#collect-close');
    await page.evaluate((to) => {
      location.hash = to;
    }, hash);
    await page.until(
      'it is open',
      (said) => document.getElementById('exercise')?.innerText.includes(said),
      task,
    );
    await page.click('#keep-button');
    await page.click('#keep-collect');
  };
  await openSheet(page);
  assert.match(await field(), /aim=J%3C7\.9/);
  await goTo(other.replace('Park', 'Drive'), 'Drive for less.');
  assert.match(await field(), /aim=J%3C7\.7&/);
  await paste(page, link);
  await page.click('#collect-check');
  await checked(page, 1);
  assert.equal((await cells(page))[0][5], 'not met');
  await page.click('#collect-empty');
  assert.match(await field(), /aim=J%3C7\.7&/);
  await page.evaluate((text) => {
    /** @type {HTMLInputElement} */ (document.getElementById('collect-exercise')).value = text;
  }, link);
  await goTo(exercise, 'Park for less.');
  assert.equal(await field(), link);
  // What was handed in may say another exercise.
  await page.evaluate(() => {
    /** @type {HTMLInputElement} */ (document.getElementById('collect-exercise')).value = '';
  });
  const theirs = await handedIn('s2', [3.3, 0, 4.5], other.replace('Park', 'Drive'));
  await goTo(theirs.link, 'Drive for less.');
  assert.equal(await field(), '');
  assert.deepEqual(await page.problems(), []);
});

pageTest(
  'of more than can be checked at once the number is said, and a file that comes twice counts once',
  async (page) => {
    const { link } = await handedIn('s1', [3.3, 0, 4.5]);
    await openSheet(page);
    await paste(page, 'I could not.\n'.repeat(5003));
    await page.click('#collect-check');
    await checked(page, 5000);
    assert.match(
      await page.text('#collect-status'),
      /^5000 hand-ins .* Only the first 5000 of 5003 were checked/,
    );
    await page.click('#collect-empty');
    for (const [count, said] of /** @type {const} */ ([
      [1, 'and one file'],
      [2, 'and 2 files'],
    ])) {
      await page.evaluate(
        (text, most) => {
          const dataTransfer = new DataTransfer();
          for (const name of ['Kim_1', 'Lee_2'].slice(0, most))
            dataTransfer.items.add(
              new File([text], `${name}_assignsubmission_file.txt`, { lastModified: 1 }),
            );
          document
            .getElementById('collect')
            ?.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
        },
        link,
        count,
      );
      await checked(page, count);
      assert.ok((await page.text('.collect-bar')).includes(said));
    }
    assert.match(await page.text('#collect-status'), /^2 hand-ins .* 2 more have a remark/);
  },
);

pageTest('a hand-in that is opened takes the focus to what came of it, and to the next one', async (page) => {
  await checkClass(page, ['Ann', 'Bob', 'Cid']);
  /** What has the focus, and what is said of it. @param {string} name @param {string} id */
  const isTold = async (name, id) => {
    await stripSays(page, new RegExp(`^${name} · `));
    await page.until(`${id} has the focus`, (wanted) => document.activeElement?.id === wanted, id);
    assert.ok(
      await page.evaluate((whose) => {
        const about = document.activeElement?.getAttribute('aria-describedby') ?? '';
        return document.getElementById(about)?.textContent?.trim().startsWith(whose);
      }, name),
    );
  };
  await page.focus('[aria-label="Open the run of Ann"]');
  await page.press(Key.ENTER);
  await isTold('Ann', 'strip-after');
  await page.press(Key.ENTER);
  await isTold('Bob', 'strip-after');
  await page.press(Key.ENTER);
  await isTold('Cid', 'strip-after');
  await page.focus('#strip-before');
  await page.press(Key.ENTER);
  await isTold('Bob', 'strip-before');
  assert.deepEqual(await page.problems(), []);
});
