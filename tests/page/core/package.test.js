// The npm package: packed, installed into an empty project without a network, and used there as its readers would.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, sep } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { npm, top } from '../../../.tasks/run.mjs';
import { engineTest } from '../harness/browsers.js';
import { Evolution, evaluate, experiment, landscape, simulate, version, wasm } from '../harness/core.js';
import { onceOnly, test } from '../harness/once.js';
import { serve } from '../harness/server.js';

const project = await mkdtemp(join(tmpdir(), 'ep-locomotion-'));
after(() => rm(project, { recursive: true }));
const installed = join(project, 'node_modules', 'ep-locomotion');
const manifest = JSON.parse(await readFile(join(top, 'package.json'), 'utf8'));

/** Installs the package; what comes back is the example of its README. */
const install = onceOnly(async () => {
  await writeFile(join(project, 'package.json'), '{ "type": "module" }');
  // The core is built already.
  await npm(['pack', '--ignore-scripts', '--silent', '--pack-destination', project], { keepColours: false });
  await npm(
    [
      ...['install', '--prefix', project, '--offline', '--no-audit', '--no-fund', '--silent'],
      join(project, `ep-locomotion-${manifest.version}.tgz`),
    ],
    { keepColours: false },
  );
  return /```js\n(.*?)```/s.exec(await readFile(join(installed, 'README.md'), 'utf8'))?.[1] ?? '';
});

const writePages = onceOnly(async () => {
  await writePage('plain', '../node_modules/ep-locomotion/pkg/ep_locomotion.js');
  const bundled = await writePage('bundled', 'ep-locomotion');
  await build({ root: bundled, base: './', logLevel: 'warn', build: { target: 'es2022' } });
});

/** A page that keeps what the example prints. @param {string} folder @param {string} specifier where the package is */
async function writePage(folder, specifier) {
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
  const example = await install();
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
    'package.json',
    'pkg/ep_locomotion.d.ts',
    'pkg/ep_locomotion.js',
    'pkg/ep_locomotion_bg.wasm',
    'src/node.js',
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
  await writeFile(join(project, 'example.js'), await install());
  const printed = execFileSync(process.execPath, [join(project, 'example.js')], { encoding: 'utf8' });
  assert.deepEqual(printed.trim().split('\n'), expectedLines());
});

test('a strict TypeScript project has the types of all of it', async () => {
  const fixture = fileURLToPath(new URL('package/consumer.ts', import.meta.url));
  await cp(fixture, join(project, 'consumer.ts'));
  await writeFile(join(project, 'example.ts'), await install());
  const files = ['consumer.ts', 'example.ts'];
  // As old as the language may be, and with the package's own declarations checked too.
  const compilerOptions = { strict: true, noEmit: true, target: 'es2022', module: 'nodenext', types: [] };
  await writeFile(join(project, 'tsconfig.json'), JSON.stringify({ compilerOptions, files }));
  const compiler = fileURLToPath(new URL('../../../node_modules/typescript/bin/tsc', import.meta.url));
  try {
    execFileSync(process.execPath, [compiler, '-p', project], { encoding: 'utf8' });
  } catch (error) {
    assert.fail(/** @type {{ stdout: string }} */ (error).stdout);
  }
});

for (const [how, path] of [
  ['in a plain page', 'plain/index.html'],
  ['in a page that Vite bundled', 'bundled/dist/index.html'],
]) {
  engineTest(`${how} the README's example prints the core's numbers`, async (page) => {
    await writePages();
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
