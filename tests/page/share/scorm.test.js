// The exercise as a package for learning platforms: written by pressing, unpacked on a static server, solved under an LMS.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { unzipSync } from 'fflate';
import { By } from 'selenium-webdriver';
import { createReader } from '../../../www/share/collect/entries.js';
import { scorm as words } from '../../../www/share/words/en.js';
import { Key, engineTest } from '../harness/browsers.js';
import { experiment, simulate } from '../harness/core.js';
import { serveHost } from '../harness/host.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const top = fileURLToPath(new URL('../../../', import.meta.url));
const link =
  'lab&v=1&drives=hand&gains=3,0,0&lock=postures,seed,settings&hide=paper,run,parts&task=J%20%3C%207.75%20%26%20more&aim=J%3C7.75&points=9:0,7.75:10';
const cost = simulate(experiment('velocity-limits'), [3.3, 0, 4.5]).cost.total;

/** Makes the package in the page, and returns its bytes. @param {Page} page */
async function packed(page) {
  await page.open(`#${link}`);
  await page.click('#keep-button');
  await page.click('#keep-exercise');
  await page.until('the maker is there', () => document.getElementById('maker-scorm'));
  await page.evaluate(() => {
    const create = URL.createObjectURL;
    URL.createObjectURL = (blob) => {
      const reader = new FileReader();
      reader.onload = () => {
        document.body.dataset.saved = String(reader.result);
      };
      reader.readAsDataURL(/** @type {Blob} */ (blob));
      return create(blob);
    };
  });
  await page.click('#maker-scorm');
  const saved = await page.until('the package is saved', () => document.body.dataset.saved);
  assert.match(await page.text('#maker-status'), /^The package is saved \(\d\.\d MB\)/);
  return Buffer.from(saved.slice(saved.indexOf(',') + 1), 'base64');
}

/** What stands for the platform, and the package in a frame of it. @param {string} folder @param {string} api */
const platform = (folder, api) =>
  `<script src="/node_modules/scorm-again/dist/scorm12.min.js"></script><script>${api}</script>
  <iframe src="/${folder}/index.html" width="900" height="600"></iframe>`;

const again = (/** @type {string} */ kept) =>
  `window.API = new Scorm12API({ logLevel: 5 }); API.loadFromJSON(${JSON.stringify({ core: { student_id: 's4711', student_name: 'Kim, Student' }, suspend_data: kept })}, 'cmi');
  API.on('LMSSetValue.cmi.core.session_time', (name, time) => { document.documentElement.dataset.time = time; });
  API.on('LMSFinish', () => { document.documentElement.dataset.over = 'true'; });`;

/** In the figure of the package. @template T @param {Page} page @param {() => Promise<T>} body */
async function inFigure(page, body) {
  const { driver } = page;
  await driver.switchTo().frame((await driver.findElements(By.css('iframe')))[0]);
  try {
    await driver.switchTo().frame((await driver.findElements(By.css('iframe')))[0]);
    await page.until('the figure is drawn', () => document.documentElement.dataset.ready);
    return await body();
  } finally {
    await driver.switchTo().defaultContent();
  }
}

/** What the package itself says. @param {Page} page */
async function told(page) {
  const { driver } = page;
  await driver.switchTo().frame((await driver.findElements(By.css('iframe')))[0]);
  const text = await page.evaluate(() => {
    const element = /** @type {HTMLElement} */ (document.getElementById('told'));
    return element.hidden ? '' : element.innerText;
  });
  await driver.switchTo().defaultContent();
  return text;
}

/** @param {Page} page @param {string} html @param {() => Promise<void>} body */
async function onPlatform(page, html, body) {
  const host = await serveHost(html);
  try {
    await page.visit(host.address);
    await body();
  } finally {
    await page.leave();
    await host.close();
  }
}

/** What the platform holds. @param {Page} page @param {string} field */
const held = (page, field) =>
  page.evaluate((name) => /** @type {any} */ (window).API.getCMIValue(`cmi.${name}`), field);

/** What the figure says of its state now comes only once the receipt is there, as on a busy machine. @param {Page} page */
const holdBack = (page) =>
  page.evaluate(() => {
    const own = /** @type {Window & typeof globalThis} */ (document.querySelector('iframe')?.contentWindow);
    const source = own.document.querySelector('iframe')?.contentWindow;
    const say = (/** @type {object} */ data) =>
      own.dispatchEvent(new own.MessageEvent('message', { source, data }));
    /** @type {object[]} */
    const late = [];
    const { dataset } = document.documentElement;
    own.addEventListener(
      'message',
      (event) => {
        if (event.data.type === 'handin') {
          setTimeout(() => {
            for (const data of late.splice(0)) say(data);
            dataset.late = 'said';
          });
        } else if (event.data.type === 'state' && !dataset.held) {
          event.stopImmediatePropagation();
          late.push(event.data);
          dataset.held = 'true';
        }
      },
      { capture: true },
    );
    say({ ep: 1, type: 'drive' });
  });

/** @param {Page} page */
async function solve(page) {
  await page.until('its work is there', () => document.getElementById('hand-in'));
  for (const [id, value] of /** @type {const} */ ([
    ['kx', '3.3'],
    ['ktheta', '4.5'],
  ])) {
    // A frame in a frame has no focus in some browsers before something in it is pressed.
    await page.click(`#gain-${id}`);
    await page.press(Key.END, ...Array(8).fill(Key.BACK_SPACE), ...value, Key.ENTER);
    await page.until(
      `${id} drives`,
      (gain) =>
        document.getElementById(`gain-${gain[0]}`)?.closest('.gain')?.querySelector('input')
          ?.valueAsNumber === Number(gain[1]),
      [id, value],
    );
  }
  await page.until('the aim is met', () => document.querySelector('#aim.met'));
}

engineTest(
  'an exercise is a package: solved under an LMS it scores, and the attempt resumes',
  async (page) => {
    const zip = await packed(page);
    const files = unzipSync(zip);
    const names = Object.keys(files);
    const list = Buffer.from(files['imsmanifest.xml']).toString();
    assert.deepEqual(
      [...list.matchAll(/<file href="([^"]+)"/g)].map(([, name]) => name),
      names.filter((name) => name !== 'imsmanifest.xml'),
    );
    assert.match(list, /<schemaversion>1\.2<\/schemaversion>/);
    assert.match(list, /<title>J &lt; 7\.75 &amp; more<\/title>/);
    // As the page's own server sends it, which adds what watches for problems.
    const oneFile = Buffer.from(files['ep-locomotion.html']).toString();
    const built = readFileSync(join(top, 'dist/ep-locomotion.html'), 'utf8');
    assert.ok(oneFile.endsWith(built.slice(-1_000_000)));

    const folder = `target/packages/${page.engine}`;
    rmSync(join(top, folder), { recursive: true, force: true });
    mkdirSync(join(top, folder), { recursive: true });
    for (const [name, content] of Object.entries(files)) writeFileSync(join(top, folder, name), content);

    let kept = '';
    await onPlatform(page, platform(folder, again('')), async () => {
      await inFigure(page, () => solve(page));
      assert.equal(await held(page, 'core.lesson_status'), 'incomplete');
      await holdBack(page);
      await page.until('a state is held back', () => document.documentElement.dataset.held);
      await inFigure(page, async () => {
        await page.click('#hand-in');
        await page.until('the receipt is there', () => document.getElementById('handin-text'));
        assert.match(
          await page.evaluate(
            () => /** @type {HTMLTextAreaElement} */ (document.getElementById('handin-text')).value,
          ),
          /\nName: s4711\n/,
        );
      });
      await page.until(
        'it is scored',
        () => /** @type {any} */ (window).API.getCMIValue('cmi.core.lesson_status') === 'passed',
      );
      assert.equal(Number(await held(page, 'core.score.raw')), 100);
      await page.until('what was held back is said', () => document.documentElement.dataset.late);
      kept = await held(page, 'suspend_data');
      assert.ok(kept.length < 4096 && /^#[^\n]+&handin=[^\n]+$/.test(kept), kept);
      assert.equal(await told(page), words.sentences.kept);
      // The platform still has it when the student leaves.
      await page.evaluate(() => document.querySelector('iframe')?.remove());
      const time = await page.until('the attempt ends', () => {
        const { over, time } = document.documentElement.dataset;
        return over && time;
      });
      assert.match(time, /^0000:\d\d:\d\d$/);
    });
    // Whoever checks may take it as it is.
    const [entry] = await createReader(['lab']).read(kept);
    assert.ok(entry.link?.includes('&handin='));

    await onPlatform(page, platform(folder, again(kept)), async () => {
      await inFigure(page, async () => {
        await page.until('it is as it was', () => document.querySelector('.work-said'));
        assert.match(await page.text('.work-said'), /^Handed in by s4711: J = 7\.71\d+\. It holds/);
        assert.ok((await page.text('.work-said')).includes(String(cost)));
      });
      assert.equal(await told(page), '');
    });
  },
);
