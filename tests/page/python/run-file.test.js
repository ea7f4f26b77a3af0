// A run that the page saved goes on in Python, as the document shows.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { areBuilt } from '../../../.tasks/examples.mjs';
import { links } from '../../../www/lesson/links.js';
import { runFile } from '../../../www/share/run-file.js';
import { createEngine, Evolution, experiment, version } from '../harness/core.js';
import { test } from '../harness/once.js';
import { valuesFrom } from './python.js';

const document = await readFile(new URL('../../../docs/python.md', import.meta.url), 'utf8');

test('a run that the page saved is the same run in Python, also before its first generation', {
  skip: !areBuilt() && 'npm test builds the wheel where Python is',
}, () => {
  const [, lines] = /```python\n(import json\n.*?)```/s.exec(document) ?? [];
  assert.ok(lines?.includes('open("run.json"'));
  const { parts, ...opened } = links.openLink('lab', createEngine()).opened;
  const runs = /** @type {const} */ ([
    ['velocity-limits', 0],
    ['acceleration-limits', 6],
  ]).map(([preset, generations]) => {
    const from = experiment(preset, { evolution: { seed: 9 } });
    const evolution = new Evolution(from);
    const history = [evolution.statistics()];
    while (history.length <= generations) history.push(evolution.step());
    const engine = /** @type {import('../../../www/core/engine.js').Engine} */ (
      /** @type {unknown} */ ({ experiment, version, hash: () => evolution.hash() })
    );
    const file = runFile({ ...opened, slices: parts, experiment: from, history }, engine, links);
    return { file, came: [evolution.hash(), generations] };
  });
  const values = valuesFrom(
    runs.flatMap(({ file }) => [
      {
        expression: `exec(given['lines'], {**globals(), 'open': lambda *_, **__: __import__('io').StringIO(given['file'])}, names := globals().setdefault('ran', {}))`,
        given: { lines, file },
      },
      { expression: "[ran['ev'].hash(), ran['ev'].generation]" },
    ]),
  );
  runs.forEach(({ came }, i) => {
    assert.deepEqual(values[2 * i + 1], came);
  });
});
