// What the frame page accepts as an origin and as a message. tests/browser/frame.test.mjs tests the bridge itself.

import assert from 'node:assert/strict';
import { it } from 'node:test';
import { messageToFrame, originOf } from '../../dist/sdk/frame/messages.js';

it('an origin is exactly one http or https origin', () => {
  for (const origin of ['https://shop.example', 'http://127.0.0.1:8080', 'https://xn--mnchen-3ya.example']) assert.equal(originOf(origin), origin);
  const none = [null, '', 'null', '*', 'shop.example', 'https://shop.example/', 'https://shop.example/a', 'https://SHOP.example',
    'https://a@shop.example', 'https://shop.example:443', 'javascript:alert(1)', 'file:///etc/passwd', 'data:text/html,x', 'https://a.example https://b.example'];
  for (const text of none) assert.equal(originOf(text), null, `${text}`);
});

it('a message is exactly one of the known messages, without other fields', () => {
  const bytes = new ArrayBuffer(4);
  const marked = (message) => messageToFrame({ kerfway: 1, ...message });
  assert.deepEqual(marked({ type: 'stop', more: 1 }), { type: 'stop' });
  assert.deepEqual(marked({ type: 'open', id: 3, bytes, name: 'a.dxf', options: {} }), { type: 'open', id: 3, bytes, name: 'a.dxf' });
  assert.deepEqual(marked({ type: 'render', id: 1, kind: 'png', width: 64 }), { type: 'render', id: 1, kind: 'png', width: 64 });
  assert.deepEqual(marked({ type: 'material', material: { thickness: 3 } }), { type: 'material', material: { thickness: 3 } });
  assert.deepEqual(marked({ type: 'priced', id: 1, text: '5 EUR' }), { type: 'priced', id: 1, text: '5 EUR' });
  assert.deepEqual(messageToFrame({ type: 'stop' }), null);
  const none = [
    { type: 'open', id: 1, bytes: 'text', name: 'a' }, { type: 'open', id: 1.5, bytes, name: 'a' }, { type: 'open', id: 1, bytes, name: '' },
    { type: 'open', id: 1, bytes, name: 'x'.repeat(256) }, { type: 'options', options: [] }, { type: 'render', id: 1, kind: 'json', width: null },
    { type: 'render', id: 1, kind: 'png', width: 0 }, { type: 'render', id: 1, kind: 'png' }, { type: 'material', material: 5 }, { type: 'priced', id: 1, text: 5 }, { type: 'priced', id: 1, text: 'x'.repeat(1001) }, { type: 'constructor' }, { type: 'ready' }, {},
  ];
  for (const message of none) assert.equal(marked(message), null, JSON.stringify(message));
  for (const data of [null, undefined, 1, 'stop', [], [{ kerfway: 1, type: 'stop' }]]) assert.equal(messageToFrame(data), null);
});
