// What files take of text that comes from others.
import assert from 'node:assert/strict';
import { escaped } from '../../../www/kit/markup.js';
import { test } from '../harness/once.js';

test('XML gets no character that it cannot have', () => {
  assert.equal(escaped('a\u0001\u000b<b>\uffff & \ud800"\n\t🤖'), 'a&lt;b&gt; &amp; &quot;\n\t🤖');
});
