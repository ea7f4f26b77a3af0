// What is taken of text that comes from others.
import assert from 'node:assert/strict';
import { escaped } from '../../../www/kit/markup.js';
import { seenText } from '../../../www/kit/text.js';
import { test } from '../harness/once.js';

test('XML gets no character that it cannot have', () => {
  assert.equal(escaped('a\u0001\u000b<b>\uffff & \ud800"\n\t🤖'), 'a&lt;b&gt; &amp; &quot;\n\t🤖');
});

test('what nobody sees is left out, but for what is seen in how letters are joined', () => {
  for (const unseen of '\u00ad\u034f\u115f\u180e\u200b\u200c\u200d\u2063\u2800\u3164\ufe0f\ufeff\uffa0\u{e0041}') {
    assert.equal(seenText(`s47${unseen}11`), 's4711', unseen.codePointAt(0)?.toString(16));
    assert.equal(seenText(`Kim${unseen}ber ${unseen} ly`), 'Kimber ly');
    assert.equal(seenText(` ${unseen} `), '');
  }
  for (const name of [
    'علی\u200cرضا',
    'क्\u200dष',
    'ക്\u200d',
    '김 하나',
    'Ágnes-José O’Neil',
    '🤖',
    'র\u200d্যাচেল',
    '葛\u{e0100}城',
    'ن\u064b\u200cم',
  ])
    assert.equal(seenText(name), name);
  assert.equal(seenText('ع\u200d\u200d\u200bلی'), 'ع\u200dلی');
  assert.equal(seenText('❤\ufe0f\u200d🔥'), '❤\ufe0f\u200d🔥');
  for (const unseen of ['\u180b\u180b', '\u17b4\u200d']) assert.equal(seenText(unseen), '');
  assert.equal(seenText('Jose\u0301\u200d'), 'Jose\u0301');
});
