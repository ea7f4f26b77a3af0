// The package as its readers have it: packed, and installed into an empty project without a network.
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';
import { npm, top } from '../../../../.tasks/run.mjs';
import { onceOnly } from '../../harness/once.js';

export const project = await mkdtemp(join(tmpdir(), 'ep-locomotion-'));
after(() => rm(project, { recursive: true }));
export const installed = join(project, 'node_modules', 'ep-locomotion');
export const manifest = JSON.parse(await readFile(join(top, 'package.json'), 'utf8'));

/** The example of the README there. @param {string} folder */
export const exampleIn = async (folder) =>
  /```js\n(.*?)```/s.exec(await readFile(join(folder, 'README.md'), 'utf8'))?.[1] ?? '';

/** Installs the package; what comes back is the example of its README. */
export const install = onceOnly(async () => {
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
  return exampleIn(installed);
});

/** What a program of the project prints, line by line. @param {string} program */
export async function printedBy(program) {
  await writeFile(join(project, 'program.js'), program);
  return execFileSync(process.execPath, ['program.js'], { cwd: project, encoding: 'utf8' })
    .trim()
    .split('\n');
}
