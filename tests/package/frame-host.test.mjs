// The host's side of the frame, without a browser: every call settles, and what is posted is what the frame accepts.

import assert from 'node:assert/strict';
import { afterEach, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { connectFrame } from '../../dist/sdk/frame/host.js';
import { messageToFrame } from '../../dist/sdk/frame/messages.js';

const ORIGIN = 'https://files.example';
const UNSETTLED = Symbol('unsettled');

/** A connected frame whose messages are kept. `ready` is what the page in it says, `page` when it was loaded. */
function hosted(listener) {
  const listeners = new Set();
  globalThis.location = { href: 'https://shop.example/' };
  globalThis.window = { addEventListener: (_, listen) => listeners.add(listen), removeEventListener: (_, listen) => listeners.delete(listen) };
  const posted = [];
  const contentWindow = { postMessage: (message) => posted.push(structuredClone(message)) };
  const frame = connectFrame({ src: `${ORIGIN}/frame.html`, contentWindow, addEventListener() {}, removeEventListener() {} }, listener);
  const say = (message) => listeners.forEach((listen) => listen({ source: contentWindow, origin: ORIGIN, data: { kerfway: 1, ...message } }));
  /** What the frame has accepted since this was asked last. */
  const accepted = () => posted.splice(0).map(messageToFrame).filter((message) => message?.type !== 'hello');
  return { frame, say, accepted, ready: (page = 1) => say({ type: 'ready', page, machines: [], methods: [] }) };
}

afterEach(() => {
  delete globalThis.window;
  delete globalThis.location;
});

const settled = (promise) => Promise.race([promise.then((value) => value, (error) => error), wait(200, UNSETTLED)]);

it('views, blobs and shared memory were ignored by the frame, and the call never settled', async () => {
  const { frame, say, accepted, ready } = hosted();
  ready();
  accepted();
  const shared = new Uint8Array(new SharedArrayBuffer(3));
  shared.set([2, 3, 4]);
  for (const bytes of [new Uint8Array([1, 2, 3, 4, 5]).subarray(1, 4), new DataView(new Uint8Array([2, 3, 4]).buffer), new Blob([new Uint8Array([2, 3, 4])]), shared]) {
    const opened = frame.open(bytes, 'a.dxf');
    await wait(20);
    const [message, ...more] = accepted();
    assert.deepEqual([message?.type, [...new Uint8Array(message?.bytes)], message?.name, more], ['open', [2, 3, 4], 'a.dxf', []]);
    say({ type: 'answer', id: message.id, value: 'planned' });
    assert.equal(await settled(opened), 'planned');
  }
});

it('arguments that the frame ignores never settled', async () => {
  const { frame, accepted, ready } = hosted();
  ready();
  accepted();
  const buffer = new ArrayBuffer(3);
  const cases = [
    [() => frame.open('text', 'a.dxf'), 'not-bytes'], [() => frame.open(buffer), 'wrong-type'], [() => frame.open(buffer, ''), 'out-of-range'], [() => frame.quote(buffer, 'x'.repeat(256)), 'out-of-range'],
    [() => frame.render('lbrn2'), 'not-a-choice'], [() => frame.render('png', { width: 10_000 }), 'out-of-range'], [() => frame.render('png', { width: '64' }), 'wrong-type'],
  ];
  for (const [call, code] of cases) assert.equal((await settled(call())).code, code, String(call));
  assert.deepEqual(accepted(), []);
});

it('calls after disconnect never settled', async () => {
  const { frame, accepted, ready } = hosted();
  ready();
  const running = frame.open(new ArrayBuffer(3), 'a.dxf');
  accepted();
  frame.disconnect();
  assert.equal((await settled(running)).code, 'closed');
  for (const call of [() => frame.open(new ArrayBuffer(3), 'a.dxf'), () => frame.quote(new Blob(['x']), 'a.dxf'), () => frame.render('svg')]) assert.equal((await settled(call())).code, 'closed');
  frame.setOptions({ seconds: 1 });
  assert.deepEqual(accepted(), []);
});

it('a frame that was loaded again left its calls waiting, without options and material', async () => {
  let started = 0;
  const { frame, accepted, ready } = hosted({ onReady: () => (started += 1) });
  frame.setOptions({ seconds: 9 });
  frame.setOptions({ seconds: 1 });
  frame.setMaterial({ thickness: 3 });
  const opened = frame.open(new ArrayBuffer(3), 'a.dxf');
  ready(1);
  assert.deepEqual(accepted().map(({ type, options }) => [type, options?.seconds]), [['options', 9], ['options', 1], ['material', undefined], ['open', undefined]]);
  // The same page, greeted again.
  ready(1);
  assert.deepEqual([accepted(), started, await settled(opened)], [[], 1, UNSETTLED]);
  ready(2);
  const { code, retryable } = await settled(opened);
  assert.deepEqual([code, retryable, started], ['planner-died', true, 2]);
  assert.deepEqual(accepted(), [{ type: 'options', options: { seconds: 1 } }, { type: 'material', material: { thickness: 3 } }]);
});

it('a frame that is none was a TypeError of the engine, or never answered', () => {
  globalThis.location = { href: 'https://shop.example/' };
  for (const none of [null, undefined, 5, {}, { src: '' }, { src: null }]) {
    assert.throws(() => connectFrame(none), { name: 'KerfwayError', code: 'wrong-type', params: { field: 'iframe' }, message: /^The frame is .*, not an iframe with an address\. Give the element once its src is set\.$/ });
  }
  assert.throws(() => connectFrame({ src: `${ORIGIN}/frame.html` }, null), { code: 'wrong-type', params: { field: 'listener' } });
});

it('options that are null, and a material that is undefined, were no refusals', async () => {
  const { frame, accepted, ready } = hosted();
  ready();
  accepted();
  await assert.rejects(frame.render('svg', null), { name: 'KerfwayError', code: 'wrong-type' });
  for (const none of [null, undefined]) assert.throws(() => frame.setMaterial(none), { code: 'wrong-type', params: { field: 'material', value: 'null' } });
  assert.throws(() => frame.setOptions(null), { code: 'wrong-type' });
  assert.deepEqual(accepted(), []);
});
