// What is typed of an aim and its points is read in one unit, or refused with the field that is wrong.
import assert from 'node:assert/strict';
import { aimText, scaleText } from '../../../www/link/exercise.js';
import { judged } from '../../../www/run/aim.js';
import { WrongField, asked, isTurned, pointIds } from '../../../www/share/exercise/asked.js';
import { Key, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { openMaker } from './making.js';

/** @typedef {import('../../../www/share/exercise/asked.js').Fields['kind']} Kind */

/** @param {Kind} kind @param {string} value @param {readonly string[]} points */
const read = (kind, value, ...points) => asked({ kind, value, drives: '', points });

/** What the other fields of the page take is taken here. */
test('groups, powers of ten and letters as wide as Korean ones are read in the maker too', () => {
  const budgetOf = (/** @type {string} */ drives) =>
    asked({ kind: 'cost', value: '8', drives, points: [] }).aim?.drives;
  for (const drives of ['4000', '4 000', '４０００', '4e3', '+4000'])
    assert.equal(budgetOf(drives), 4000, drives);
  for (const drives of ['0', '1.5', '4,000', 'x', '-4'])
    assert.throws(() => budgetOf(drives), { field: 'maker-budget' }, drives);
  assert.equal(said('cost', '1 000', '', '', '', ''), 'J<1000 ');
  assert.equal(said('parks', '２８/３２', '１６／３２', '0', '32', '6'), 'parks:28/32 16:0,32:6');
  assert.equal(said('unseen', '６０％', '３０％', '0', '90%', '6'), 'unseen:0.6 0.3:0,0.9:6');
});

/** As a link has it, or which field is wrong. @param {Kind} kind @param {string} value @param {readonly string[]} points */
function said(kind, value, ...points) {
  try {
    const { aim, scale } = read(kind, value, ...points);
    return [aim && aimText(aim), scale && scaleText(scale)].join(' ');
  } catch (reason) {
    assert.ok(reason instanceof WrongField);
    return reason.field;
  }
}

test('a per cent means the same of the aim and of the points, and so do starts of so many', () => {
  const shares = ['0.3', '0,3', '30%', '30 %', '30,0 %'];
  for (const value of ['0.6', '60%', '60 %'])
    for (const low of shares)
      assert.equal(said('unseen', value, low, '0', '90%', '6'), 'unseen:0.6 0.3:0,0.9:6');
  for (const low of ['16', '16/32', '16 / 32'])
    assert.equal(said('parks', '28 / 32', low, '0', '32/32', '6'), 'parks:28/32 16:0,32:6');
  // So many of 1000 are as many as it says, and not one more.
  for (let count = 1; count <= 1000; count += 1)
    assert.equal(said('unseen', `${count / 10} %`, '', '', '', ''), `unseen:${count / 1000} `);
  const { aim, scale } = read('unseen', '60%', '30%', '0', '90%', '6');
  assert.equal(aim && judged(aim, scale, { value: 2 / 3, drives: 0 }).points, 3.67);
});

test('what no answer can come to is no value for points, and the field that has it is named', () => {
  const [at0, points0, at1, points1] = pointIds;
  /** @type {readonly (readonly [field: string, kind: Kind, value: string, ...points: string[]])[]} */
  const wrong = [
    [at0, 'unseen', '60%', '30', '0', '90', '6'],
    [at1, 'unseen', '60%', '0.3', '0', '90', '6'],
    [at1, 'unseen', '60%', '0.3', '0', '101%', '6'],
    [at0, 'parks', '28/32', '33', '0', '32', '6'],
    [at0, 'parks', '28/32', '16/30', '0', '32', '6'],
    [at1, 'parks', '28/32', '16', '0', '50%', '6'],
    [at0, 'cost', '8', '-1', '0', '7', '6'],
    [at0, 'cost', '8', 'x', '0', '', ''],
    [points0, 'cost', '8', '9', '1001', '7', '6'],
    [points1, 'cost', '8', '9', '0', '7', '-6'],
    [at1, 'cost', '8', '9', '0', '9.0', '6'],
    [at0, 'cost', '8', '', '0', '7', '6'],
    [points1, 'cost', '8', '9', '0', '7', ''],
    ['maker-value', 'unseen', '60', '', '', '', ''],
    ['maker-value', 'unseen', 'x%', '', '', '', ''],
  ];
  for (const [field, ...typed] of wrong) assert.equal(said(...typed), field, typed.join(' '));
  assert.equal(said('cost', '8', '', '', '', ''), 'J<8 ');
  const reason = (/** @type {[Kind, string, ...string[]]} */ ...typed) => {
    try {
      read(...typed);
    } catch (error) {
      return String(error);
    }
    return '';
  };
  assert.match(
    reason('unseen', '60%', '30%', '0', '90', '6'),
    /The second value must be a share from 0 to 1, for instance 0\.3 or 30 %\./,
  );
  assert.match(reason('parks', '33/32', '', '', '', ''), /like 28\/32: the first at most the second/);
  assert.match(reason('parks', '28/32', '16', '0', '33', '6'), /number of starts from 0 to 32\./);
  assert.match(reason('cost', '8', '9', '', '7', '6'), /need all four/);
});

test('a scale is turned where the better of its two values has fewer points', () => {
  for (const [kind, value, worse, better] of /** @type {[Kind, string, string, string][]} */ ([
    ['cost', '8.1', '9', '7.75'],
    ['parks', '28/32', '16', '32'],
    ['unseen', '0.6', '0.3', '0.9'],
  ])) {
    for (const points of [
      [worse, '0', better, '10'],
      [better, '10', worse, '0'],
      [worse, '5', better, '5'],
      ['', '', '', ''],
    ])
      assert.equal(isTurned(read(kind, value, ...points)), false, points.join(' '));
    for (const points of [
      [worse, '10', better, '0'],
      [better, '0', worse, '10'],
    ])
      assert.equal(isTurned(read(kind, value, ...points)), true, points.join(' '));
  }
});

pageTest('the field that is wrong is marked, and the buttons say why they do nothing', async (page) => {
  await openMaker(page, '#lab&v=1&aim=J%3C8.1&points=7.75:0,9:10');
  await page.until('that the scale is turned', () => document.getElementById('maker-turned'));
  const marked = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('#maker [aria-invalid="true"]')].map(
        (field) => `${field.id} ${field.getAttribute('aria-describedby')}`,
      ),
    );
  /** What stands in the elements that describe each button. */
  const reasons = () =>
    page.evaluate(() =>
      ['maker-copy-link', 'maker-copy-frame'].map((id) =>
        (document.getElementById(id)?.getAttribute('aria-describedby') ?? '')
          .split(' ')
          .map((one) => document.getElementById(one)?.textContent ?? '')
          .join(' '),
      ),
    );
  assert.deepEqual(await marked(), []);
  assert.deepEqual(await reasons(), ['', '']);
  for (const id of ['maker-value', 'maker-budget', ...pointIds]) {
    await page.focus(`#${id}`);
    await page.press(Key.END, 'x');
    assert.deepEqual(await marked(), [`${id} maker-aim-error`]);
    const error = await page.text('#maker-aim-error');
    for (const reason of await reasons()) assert.ok(reason.endsWith(error) && reason !== error, reason);
    await page.press(Key.BACK_SPACE);
    assert.deepEqual(await marked(), []);
    assert.deepEqual(await reasons(), ['', '']);
  }
  assert.deepEqual(await page.problems(), []);
});
