// The words of both languages, as they stand in the sources.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { because, notStarted } from '../../../www/core/hands.js';
import { pageNames, parts } from '../../../www/parts/parts.js';
import { said } from '../../../www/words/ko/messages.js';
import { languageAfter, languageNames, languageOf, usualLanguage } from '../../../www/words/language.js';
import { experiment, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';
import { en, inEach, ko, latinWord, sameInBoth } from '../harness/words.js';

const source = fileURLToPath(new URL('../../../www/', import.meta.url));

/** Every text of a language by its place; functions are named. @param {unknown} value @param {string} place @returns {[string, string][]} */
function textsOf(value, place) {
  if (typeof value === 'function') return [[place, 'function']];
  if (value === null || typeof value !== 'object') return [[place, `${typeof value}: ${value}`]];
  return Object.entries(value).flatMap(([key, inner]) => textsOf(inner, place ? `${place}.${key}` : key));
}

/** Places that hold an identifier, which is the same in every language. @param {string} place */
const isIdentifier = (place) =>
  /\.(value|id|symbol|className|unit|letter|index)$|^lab\.(costParts|untils)\.\d\.0$|^keys\.single\.\d\.[02]$|^lab\.gains|^(disturbance|curves)\.units|^luck\.gainColumns|^disturbance\.(formulas|parts)|^lesson\.steps\.build\.program\.\w+\.\d+\.1$/.test(
    place,
  );

test('whatever word a field may have, Korean says it without an English one', () => {
  for (const { path, words } of wordFields()) {
    const [name, field] = path.split('.');
    const wrong = field ? { [name]: { [field]: 'x' } } : { [name]: 'x' };
    assert.throws(
      () => experiment(/** @type {{}} */ (wrong)),
      ({ message }) => {
        const told = said(message);
        assert.ok(words.every((word) => told.includes(`'${word}'`)) && !/ or | must /.test(told), told);
        return true;
      },
    );
  }
});

test('how small a population may be with a method Korean says without an English word', () => {
  for (const [method, least] of /** @type {const} */ ([
    ['de', 4],
    ['cma-es', 2],
  ]))
    assert.throws(
      () => experiment({ evolution: { method, population: least - 1 } }),
      ({ message }) => {
        const told = said(message);
        assert.ok(told.includes(`'${method}' 방법에서는 ${least} 이상`) && !/ or | with /.test(told), told);
        return true;
      },
    );
});

test('what a Korean refusal demands has its large numbers in groups, and what was typed stays as it was', () => {
  const rows = /** @type {const} */ ([
    [{ limits: { speed: 9999999 } }, /: 허용되는 값은 0 이상 1,000,000 m\/s 이하.*입력값: 9999999\.$/],
    [{ evolution: { seed: -1 } }, /0 이상 4,294,967,295 이하의 정수/],
    [{ sampleTime: 0 }, /0\.00001 이상/],
  ]);
  for (const [wrong, told] of rows)
    assert.throws(
      () => experiment(wrong),
      ({ message }) => {
        assert.match(said(message), told);
        return true;
      },
    );
});

test('what becomes of a worker Korean says without an English word', () => {
  const text = readFileSync(join(source, 'core/hands.js'), 'utf8');
  const reasons = [...text.matchAll(/lose\(hand, '([^']*)'/g)].map(([, reason]) => reason);
  assert.ok(reasons.length > 2, `${reasons}`);
  for (const reason of ['', ...reasons])
    for (const message of [`A worker was lost${because(reason)}`, notStarted(reason).message])
      assert.doesNotMatch(said(message).replace('(worker-src, sandbox)', ''), latinWord);
});

test('a J below the large one stands in one line with what it belongs to', () => {
  for (const { lab } of Object.values(inEach))
    for (const note of [lab.costNote(lab.driverName('paper-ep', 0, 'hand'), 7.935), lab.meanNote(2, 7.935)])
      assert.match(note, /[^ ]\u00a07\.935$/);
});

test('every language has the words of English, and none of them is English', () => {
  const { en: usual, ...others } = Object.fromEntries(
    languageNames.map((name) => [name, { ...inEach[name], called: parts.map(({ called }) => called[name]) }]),
  );
  const english = new Map(textsOf(usual, ''));
  const kind = (/** @type {string | undefined} */ text) => text?.split(':')[0];
  for (const [language, words] of Object.entries(others)) {
    const own = new Map(textsOf(words, ''));
    assert.deepEqual([...own.keys()].sort(), [...english.keys()].sort(), language);
    for (const [place, text] of english) {
      assert.equal(kind(own.get(place)), kind(text), `${place} in ${language}`);
      if (!text.startsWith('string: ') || isIdentifier(place)) continue;
      const said = text.slice('string: '.length).replaceAll(sameInBoth, '');
      if (latinWord.test(said)) assert.notEqual(own.get(place), text, `${place} is English in ${language}`);
    }
  }
});

test('no name of the sources stands in a sentence', () => {
  for (const [language, words] of Object.entries({ en, ko }))
    for (const [place, text] of textsOf(words, language)) {
      const prose = text.replaceAll(/\{[^}]*\}|\]\([^)]*\)/g, '');
      if (!isIdentifier(place.replace(`${language}.`, '')))
        assert.doesNotMatch(prose, /\b[a-z]+[A-Z]/, place);
    }
});

test('from language to language one comes to all', () => {
  const met = new Set();
  /** @type {import('../../../www/words/language.js').Language} */
  let name = usualLanguage;
  for (; !met.has(name); name = languageAfter(name)) met.add(name);
  assert.deepEqual([...met], languageNames);
});

test('every part of the page has its folder', () => {
  const folders = readdirSync(join(source, 'parts'), { withFileTypes: true })
    .filter((one) => one.isDirectory())
    .map(({ name }) => name);
  assert.deepEqual(
    ['lab', ...folders].sort(),
    [...pageNames].sort(),
    'www/parts/parts.js has a row for each',
  );
});

const modules = readdirSync(source, { recursive: true, encoding: 'utf8' }).filter((name) =>
  name.endsWith('.js'),
);

test('no language has anything of the other, so that one is loaded without the other', () => {
  const place = new RegExp(String.raw`(^|[\\/])(${[...languageNames, 'common'].join('|')})(?=[\\/]|\.js$)`);
  for (const name of modules) {
    const own = place.exec(name.replace(/^words/, ''))?.[2];
    if (!own) continue;
    const others = languageNames.filter((language) => language !== own).join('|');
    const text = readFileSync(join(source, name), 'utf8');
    assert.doesNotMatch(text, new RegExp(`(from|import\\() ?'[^']*\\b(${others})(/|\\.js)`), name);
  }
});

test('Korean is written at one speech level, and never offers two particles to choose from', () => {
  const korean = modules.filter(
    (name) => /(^|[\\/])words[\\/](ko[\\/]|([\w-]+-)?ko\.js$)/.test(name) || name.endsWith('part.js'),
  );
  assert.ok(korean.length > 40, `${korean.length}`);
  for (const name of korean) {
    const text = readFileSync(join(source, name), 'utf8');
    assert.doesNotMatch(text, /이\(가\)|은\(는\)|을\(를\)|과\(와\)|와\(과\)|\(으\)로/, name);
    assert.doesNotMatch(text, /(?:[세해예네나어아여]요|죠)[.?!”’'`]/, name);
    // A percent sign follows its number at once.
    assert.doesNotMatch(text, /[\d}] %/, name);
  }
});

test('an index is no plain letter behind its symbol, nor behind a low line', () => {
  const words = modules.filter((name) => /(^|[\\/])words[\\/]/.test(name));
  assert.ok(words.length > 80);
  for (const name of words)
    assert.doesNotMatch(readFileSync(join(source, name), 'utf8'), /θ_?e|\b[xyqN]_[a-z]\b/, name);
});

test('no view has words of its own language', () => {
  // The element stands in pages of others, and has its language from them.
  const views = modules.filter(
    (name) => !/(^|[\\/])words[\\/]/.test(name) && name !== join('embed', 'element.js'),
  );
  assert.ok(views.length > 50);
  const ofLanguage = new RegExp(`from '[^']*words/(${languageNames.join('|')})(/|\\.js)`);
  for (const name of views) assert.doesNotMatch(readFileSync(join(source, name), 'utf8'), ofLanguage, name);
});

test('every word of index.html comes from the languages, which have one for each of its places', () => {
  const html = readFileSync(join(source, '../index.html'), 'utf8');
  // What is there before the page runs cannot know the language: it is told in both.
  const built = html.replace(/<(title|noscript)>.*?<\/\1>|<div id="instead".*?<\/div>/gs, '');
  const tags = [...built.matchAll(/<[a-z][^>]*>([^<]*)/g)];
  assert.ok(tags.length > 50);
  for (const [tag, text] of tags) {
    assert.ok(!/\p{L}/u.test(text) || /^<[^>]* data-text="/.test(tag), tag);
    assert.doesNotMatch(
      tag,
      /^<[^>]* (aria-(label|description|valuetext|roledescription)|title|placeholder|alt)="/,
    );
  }
  const keys = [...built.matchAll(/ data-(?:text|label|content)="([^"]*)"/g)].map(([, key]) => key);
  for (const [language, words] of Object.entries({ en, ko })) {
    const texts = Object.assign(
      {},
      ...Object.values(words).map((part) => ('texts' in part ? part.texts : {})),
    );
    for (const key of keys) {
      // A word stands before its number or after it.
      const [, name] = /^(.*)(?:Before|After)$/.exec(key) ?? [];
      const text = name ? texts[`${name}Before`] + texts[`${name}After`] : texts[key];
      assert.match(text ?? '', /\p{L}/u, `${language} has nothing for ${key}`);
    }
  }
});

test('the link says the language; without a link the browser does', () => {
  for (const [link, preferred, language] of /** @type {const} */ ([
    ['', ['en-GB'], 'en'],
    ['', ['ko-KR', 'en'], 'ko'],
    ['', ['fr', 'ko'], 'ko'],
    ['', ['fr'], 'en'],
    ['', ['kok-IN', 'kok', 'en-IN'], 'en'],
    ['', ['KO'], 'ko'],
    ['', [], 'en'],
    ['lab', ['ko'], 'en'],
    ['lab&v=1&seed=7', ['ko'], 'en'],
    ['lab&v=1&lang=ko', ['en'], 'ko'],
    ['curves&v=1&seed=7&lang=ko', ['en'], 'ko'],
    ['lab&v=1&seed=7?lang=ko', ['en'], 'ko'],
    ['lab&v=1&lang=xx', ['ko'], 'en'],
  ]))
    assert.equal(languageOf(link, preferred), language, `#${link} for ${preferred}`);
});

test('with many starts the cost is that of the first, and evolution’s mean is not what to beat', () => {
  for (const { lab } of Object.values(inEach)) {
    assert.doesNotMatch(lab.costMeaning(1), /\d/);
    assert.match(lab.costMeaning(32), /32/);
    for (const isPapers of [true, false]) {
      assert.match(lab.gainsNote('hand', isPapers, 8.5), /8\.5/);
      assert.doesNotMatch(lab.gainsNote('hand', isPapers, null), /\d|null/);
    }
    assert.notEqual(lab.gainsNote('hand', true, 8.5), lab.gainsNote('hand', false, 8.5));
  }
});
