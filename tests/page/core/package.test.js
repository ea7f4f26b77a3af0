// The npm package, used as its readers would.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cp, mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { join, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { top } from '../../../.tasks/run.mjs';
import { openLink } from '../../../src/link.js';
import { changesOf } from '../../../www/link/experiment.js';
import { pageNames } from '../../../www/parts/parts.js';
import { presets } from '../../../www/run/state.js';
import { noStep, unknownPart } from '../../../www/words/en/link.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { Evolution, evaluate, experiment, landscape, simulate, version, wasm } from '../harness/core.js';
import { onceOnly, test } from '../harness/once.js';
import { serve } from '../harness/server.js';
import { exampleIn, install, installed, manifest, printedBy, project } from './package/installed.js';

// What is packed is installed once, for the bundled page.
const writePlain = onceOnly(async () => {
  await cp(join(top, 'pkg'), join(project, 'pkg'), { recursive: true });
  await writePage('plain', '../pkg/ep_locomotion.js', await exampleIn(top));
});
const writeBundled = onceOnly(async () => {
  const bundled = await writePage('bundled', 'ep-locomotion', await install());
  await build({ root: bundled, base: './', logLevel: 'warn', build: { target: 'es2022' } });
});

/** A page that keeps what the example prints. @param {string} folder @param {string} specifier where the package is @param {string} example */
async function writePage(folder, specifier, example) {
  const page = join(project, folder);
  await mkdir(page);
  await writeFile(
    join(page, 'index.html'),
    '<!doctype html><head><script type="module" src="./main.js"></script></head>',
  );
  await writeFile(
    join(page, 'main.js'),
    `const lines = [];
     console.log = (...words) => lines.push(words.join(' '));
     await import('./example.js');
     window.printed = lines;`,
  );
  await writeFile(join(page, 'example.js'), example.replace("'ep-locomotion'", `'${specifier}'`));
  return page;
}

/** What the README's example prints, from the core that the page was built with. */
function expectedLines() {
  const e = experiment('velocity-limits');
  const run = simulate(e, [3.23673, 0.09678, 5.17891]);
  const evolution = new Evolution({ ...e, evolution: { ...e.evolution, seed: 7 } });
  for (let i = 0; i < 30; i++) evolution.step();
  const map = landscape(e, {
    x: { gain: 'kx', from: 0.1, to: 10, count: 64, log: true },
    y: { gain: 'ktheta', from: 1, to: 10, count: 64 },
    gains: [0, 0.1, 0],
  }).subarray(0, 32 * 64);
  return [
    `${run.cost.total} ${run.finalTime} ${run.arrived}`,
    evaluate(e, [3, 0.1, 5, 10, 10, 10]).join(' '),
    `${run.linear[0]}`,
    `${evolution.statistics().best.cost}`,
    `${e.evolution.population}`,
    evolution.hash(),
    `${map.length} ${Math.min(...map)}`,
  ];
}

test('the package holds what it needs, and nothing of the machine that built it', async () => {
  await install();
  const entries = await readdir(installed, { recursive: true, withFileTypes: true });
  const files = entries
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => join(parentPath, name));
  assert.deepEqual(files.map((file) => file.slice(installed.length + 1).replaceAll(sep, '/')).sort(), [
    'LICENSE-APACHE',
    'LICENSE-MIT',
    'README.md',
    'docs/embedding.md',
    'docs/exercises.md',
    'docs/javascript.md',
    'docs/python.md',
    'docs/teaching.md',
    'package.json',
    'pkg/ep_locomotion.d.ts',
    'pkg/ep_locomotion.js',
    'pkg/ep_locomotion_bg.wasm',
    'pkg/link.js',
    'src/link.d.ts',
    'src/node.js',
    'src/search/METHODS.md',
  ]);
  const places = [top, process.env.CARGO_HOME].filter((place) => place !== undefined);
  for (const file of files) {
    const text = await readFile(file, 'latin1');
    const found = /.*([\\/](root|home|Users)[\\/]|sourceMappingURL).*/.exec(text)?.[0];
    assert.equal(found, undefined, `${file}: ${found}`);
    for (const place of places) assert.ok(!text.includes(place), `${file} names ${place}`);
  }
  assert.deepEqual(await readFile(join(installed, 'pkg', 'ep_locomotion_bg.wasm')), await readFile(wasm));
});

test('every file tells the same version', async () => {
  assert.equal(version(), manifest.version);
  for (const [file, line] of [
    ['CITATION.cff', `\nversion: ${manifest.version}\n`],
    ['CHANGELOG.md', `\n## ${manifest.version}`],
    ['README.md', `\`ep-locomotion-${manifest.version}.tgz\``],
  ]) {
    assert.ok((await readFile(join(top, file), 'utf8')).includes(line), `${file} has no ${line.trim()}`);
  }
});

test("under Node the README's example prints the core's numbers", async () => {
  assert.deepEqual(await printedBy(await install()), expectedLines());
});

test('the types show no name of the inside of the core', async () => {
  await install();
  const types = await readFile(join(installed, 'pkg', 'ep_locomotion.d.ts'), 'utf8');
  const code = types.replaceAll(/\/\*\*.*?\*\//gs, '');
  assert.deepEqual(code.match(/\w+_\w*/g), null);
  assert.doesNotMatch(types, /r"/);
});

test('the package reads links of the page', async () => {
  await install();
  const reading = `import init from 'ep-locomotion';
    import { openLink } from 'ep-locomotion/link';
    await init();
    const links = ['https://a.host/ep/index.html#curves&amp;v=1&preset=acceleration-limits&seed=7&horizon=5&gains=3,0.1,5&drives=hand&t=1.5',
      'lab&goal.theta=90deg&sampleTime=0.001&limits.speed=off&gains=1,2&horizn=3', ''];
    console.log(JSON.stringify(links.map(openLink)));`;
  const [first, second, third] = JSON.parse((await printedBy(reading))[0]);
  const usual = experiment('velocity-limits');
  const changed = experiment('acceleration-limits', { horizon: 5, evolution: { seed: 7 } });
  const { preset, part, gains, drives, others, problems } = first;
  assert.deepEqual(first.experiment, changed);
  assert.deepEqual(
    { preset, part, gains, drives, others, problems },
    {
      preset: 'acceleration-limits',
      part: 'curves',
      gains: [3, 0.1, 5],
      drives: 'hand',
      others: { v: '1', t: '1.5' },
      problems: [],
    },
  );
  assert.deepEqual(second.experiment, {
    ...usual,
    goal: { ...usual.goal, theta: Math.PI / 2 },
    sampleTime: 0.001,
    limits: { ...usual.limits, speed: null },
  });
  assert.deepEqual(second.others, { horizn: '3' });
  assert.match(second.problems.join(), /^gains: it must be three numbers/);
  assert.deepEqual([third.part, third.experiment, third.problems], ['lab', usual, []]);
});

test('openLink finds who works there where the page does, and passes on what an exercise had', () => {
  for (const [link, seed, who] of /** @type {const} */ ([
    ['https://a.host/ep/?who=s4711#lab&v=1&vary=goal&seed=7', 7, 's4711'],
    ['https://a.host/ep/?embed&amp;who=s%204711#lab&v=1&vary=goal&seed=7', 7, 's 4711'],
    ['#lab&v=1&vary=goal&seed=7?who=s4711', 7, 's4711'],
    ['https://a.host/?who=other#lab&v=1&vary=goal&seed=7&who=own', 7, 'own'],
    ['https://a.host/?who=#lab&v=1&vary=goal', 1, undefined],
  ])) {
    const { experiment: opened, others, problems } = openLink(link);
    assert.deepEqual(
      [opened.evolution.seed, others.who, others.vary, problems],
      [seed, who, 'goal', []],
      link,
    );
  }
  const given = 'acceleration-limits~goal.x:3~seed:7';
  const { experiment: own, others, problems } = openLink(`lab&v=1&horizon=5&given=${given}`);
  assert.deepEqual([own, others.given, problems], [experiment({ horizon: 5 }), given, []]);
});

test('a spread copy of what openLink gives is completed from the preset of the link, whatever else that says', () => {
  for (const preset of presets) {
    const whole = experiment(preset);
    const keys = changesOf(whole, /** @type {typeof whole} */ ({}));
    assert.ok(keys.length > 30);
    for (const [key, text] of [...keys, ['generation', '3'], ['gains', '3,0.1,5']]) {
      const pairs = [`preset=${preset}`, `${key}=${text}`];
      for (const link of [pairs, pairs.toReversed()].map((all) => `lab&v=1&${all.join('&')}`)) {
        const { experiment: opened, problems } = openLink(link);
        assert.deepEqual([opened, problems], [whole, []], link);
        const limits = { ...whole.limits, speed: 1 };
        assert.deepEqual(experiment({ ...opened, limits: { speed: 1 } }), { ...whole, limits }, link);
      }
    }
  }
});

test('openLink says of a part, a driver, a version and a step what the page says', () => {
  for (const name of [...pageNames, 'lesson', ''])
    assert.deepEqual([openLink(name).part, openLink(name).problems], [name || 'lab', []]);
  for (const [link, problem] of /** @type {const} */ ([
    ['garbage&v=1', unknownPart('garbage', [...pageNames, 'lesson'])],
    ['https://a.host/ep/', unknownPart('https://a.host/ep/', [...pageNames, 'lesson'])],
    [
      'lab&drives=hnad',
      /^drives: it must be one of evolved, hand, paper-ep, paper-arbitrary, but was “hnad”/,
    ],
    ['lab&drives=hand', 'drives: it needs gains=kx,ky,kθ beside it.'],
    ['lab&v=2', 'v: the link was written by version 2, this page reads version 1.'],
    ['lesson&step=99', noStep('99')],
    ['lab&lesson=nothing', noStep('nothing')],
  ])) {
    const { problems, drives } = openLink(link);
    assert.deepEqual([problems.length, drives], [1, 'evolved'], link);
    if (typeof problem === 'string') assert.equal(problems[0], problem);
    else assert.match(problems[0], problem);
  }
  assert.equal(openLink('garbage&seed=7').part, 'lab');
  assert.deepEqual(openLink('lesson&step=duel').others, { step: 'duel' });
  for (const [link, found] of [
    [undefined, 'undefined'],
    [3, '3'],
    [null, 'null'],
    [['lab'], 'of type object'],
  ])
    assert.throws(() => openLink(/** @type {any} */ (link)), {
      name: 'TypeError',
      message: `link must be a text, but was ${found}`,
    });
});

test('a strict TypeScript project has the types of all of it', async () => {
  const fixture = fileURLToPath(new URL('package/consumer.ts', import.meta.url));
  await cp(fixture, join(project, 'consumer.ts'));
  await writeFile(join(project, 'example.ts'), await install());
  const compiler = fileURLToPath(new URL('../../../node_modules/typescript/bin/tsc', import.meta.url));
  for (const [file, lib] of /** @type {const} */ ([
    // The package's own declarations are checked too, and need nothing of a browser.
    ['consumer.ts', ['es2022']],
    ['example.ts', ['es2022', 'dom']],
  ])) {
    const compilerOptions = {
      strict: true,
      noEmit: true,
      target: 'es2022',
      lib,
      module: 'nodenext',
      types: [],
    };
    await writeFile(join(project, 'tsconfig.json'), JSON.stringify({ compilerOptions, files: [file] }));
    try {
      execFileSync(process.execPath, [compiler, '-p', project], { encoding: 'utf8' });
    } catch (error) {
      assert.fail(/** @type {{ stdout: string }} */ (error).stdout);
    }
  }
});

for (const [how, path, declare, write] of /** @type {const} */ ([
  ['in a plain page', 'plain/index.html', engineTest, writePlain],
  // It is the same core that runs there.
  ['in a page that Vite bundled', 'bundled/dist/index.html', pageTest, writeBundled],
])) {
  declare(`${how} the README's example prints the core's numbers`, async (page) => {
    await write();
    const site = await serve(project);
    try {
      await page.visit(site.address + path);
      const printed = await page.until('the example has ended', () => Reflect.get(window, 'printed'));
      assert.deepEqual(printed, expectedLines());
      assert.deepEqual([...(await page.problems()), ...site.problems], []);
    } finally {
      await site.close();
    }
  });
}
