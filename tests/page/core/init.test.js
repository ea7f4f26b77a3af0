// How the package's core is made ready under Node.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from '../harness/once.js';
import { install, installed, printedBy, project } from './package/installed.js';

test('a call before the core is ready says so, and init takes bytes by either name', async () => {
  await install();
  const early = `import init, { Task, evaluate } from 'ep-locomotion';
    import { readFileSync } from 'node:fs';
    for (const call of [() => evaluate({}, [1, 2, 3]), () => new Task({})])
      try { call(); } catch (error) { console.log(error.message); }
    const bytes = readFileSync('node_modules/ep-locomotion/pkg/ep_locomotion_bg.wasm');
    await init({ NAME: bytes });
    console.log(evaluate({}, [1, 2, 3]).length);`;
  for (const name of ['module', 'module_or_path']) {
    const said = 'ep-locomotion: call init() and wait for it before anything else';
    assert.deepEqual(await printedBy(early.replace('NAME', name)), [said, said, '1']);
  }
});

test('init takes the address of its file, and after what is no core another', async () => {
  await install();
  const several = `import init, { evaluate } from 'ep-locomotion';
    const file = import.meta.resolve('ep-locomotion/ep_locomotion_bg.wasm');
    const other = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0);
    for (const module of [Uint8Array.of(1), other])
      await init({ module }).catch((error) => console.log(error.message));
    await init({ module: FILE });
    console.log(evaluate({}, [1, 2, 3]).length);`;
  for (const file of ['file', 'new URL(file)', 'Promise.resolve(file)', 'undefined']) {
    const [, said, count] = await printedBy(several.replace('FILE', file));
    assert.deepEqual([said, count], ['ep-locomotion: what init() was given is not its core', '1'], file);
  }
});

test('what cannot be read ends no program that catches it, also where nobody waits for it any more', async () => {
  await install();
  const twice = `import init, { evaluate } from 'ep-locomotion';
    const said = await Promise.allSettled([init({ module: 'file:///none.wasm' }), init({ module: 'file:///none.wasm' })]);
    console.log(said.map(({ status }) => status).join());
    await init();
    await Promise.allSettled([init({ module: 'file:///none.wasm' })]);
    // Whatever nobody catches is heard of by then.
    await new Promise((resolve) => setTimeout(resolve));
    console.log(evaluate({}, [1, 2, 3]).length);`;
  assert.deepEqual(await printedBy(twice), ['rejected,rejected', '1']);
});

test('in a bundle that cannot say where it lies the core comes from its bytes', async () => {
  await install();
  const entry = await readFile(join(installed, 'src', 'node.js'), 'utf8');
  assert.match(entry, /import\.meta\.url/);
  const bundle = entry
    .replace('import.meta.url', 'undefined')
    .replaceAll("'../pkg/", "'./node_modules/ep-locomotion/pkg/");
  await writeFile(join(project, 'bundle.js'), bundle);
  const given = `import { readFileSync } from 'node:fs';
    import init, { evaluate } from './bundle.js';
    await init({ module: readFileSync('node_modules/ep-locomotion/pkg/ep_locomotion_bg.wasm') });
    console.log(evaluate({}, [1, 2, 3]).length);`;
  assert.deepEqual(await printedBy(given), ['1']);
});
