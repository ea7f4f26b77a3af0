// What of the page before outlasts the link that is opened next.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { pageNames, places } from '../../../www/parts/parts.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { samples } from '../parts/samples.js';
import { pageOf } from './page-of.js';

test('what a part keeps is in the link, passes, or is named in its sample with its reason', () => {
  const { opened } = links.openLink('lab', pageOf('lab').engine);
  for (const slice of places.slices) {
    const before = Object.fromEntries(Object.keys(slice.first).map((field) => [field, `before ${field}`]));
    const after = /** @type {Record<string, unknown>} */ (
      slice.opened({ slices: { [slice.name]: before } }, opened.parts[slice.name])
    );
    const stays = Object.keys(after).filter((field) => after[field] === before[field]);
    assert.deepEqual(
      stays.sort(),
      Object.keys(samples[slice.name].lasting ?? {}).sort(),
      `${slice.name}: what stays is in \`lasting\` of tests/page/parts/samples/${slice.name}.js, with its reason`,
    );
  }
});

const ofWindow = 'of the window';
const ofReader = 'how somebody works, not what is shown';

/** The same of the run; what parts keep is in their samples, and what begins anew begins later. */
const kept = {
  lastStep: 'where “Lesson” leads',
  pace: ofReader,
  until: ofReader,
  speed: ofReader,
  settings: 'what is open stays open',
  maker: 'an exercise in the making',
  versions: 'the way back',
  tried: 'what is tried, for the next part that tries it',
  refusals: 'a count',
  unpinned: 'told only of the very run that was refused',
  work: 'when it began',
  size: ofWindow,
  theme: ofWindow,
};

test('a link opens over any run what it opens in a new tab, but for what is named here with its reason', () => {
  const rich =
    'disturbance&v=1&goal.x=1&generation=2&drives=hand&gains=3,1,5&under=random,0.3,0.2,3&from=1,1,0&pin1=a~1,2,3';
  /** @type {Set<string>} */
  const differing = new Set();
  for (const name of pageNames) {
    const { store, actions, open } = pageOf(rich);
    actions.useSeed(7);
    const { experiment: now, handGains: gains, maker } = store.get();
    store.update({
      ...{ lastStep: 3, evolving: false, pace: 2, until: { kind: 'cost', value: 7 }, untilError: 'x' },
      ...{ gainErrors: ['x', '', ''], unpinned: { experiment: now, gains: /** @type {any} */ (gains) } },
      ...{
        settings: { open: true, error: { path: 'horizon', text: 'x' } },
        refusals: 3,
        message: 'x',
        speed: 2,
      },
      ...{ maker: { ...maker, open: true }, size: { width: 9, height: 9 }, theme: 4 },
    });
    open(name);
    const fresh = pageOf(name).store.get();
    const state = store.get();
    for (const [field, value] of Object.entries(fresh))
      if (JSON.stringify(value) !== JSON.stringify(state[/** @type {keyof typeof state} */ (field)])) {
        assert.ok(field in kept, `${name}: ${field}`);
        differing.add(field);
      }
    const { trial } = state;
    assert.deepEqual(trial, fresh.trial);
    assert.equal(state.settings.error, null);
    if (places.triesDisturbance(name)) assert.deepEqual(state.tried, fresh.tried, name);
    assert.equal(links.linkOf(state, experiment), links.linkOf(fresh, experiment));
  }
  assert.deepEqual([...differing].sort(), Object.keys(kept).sort());
});
