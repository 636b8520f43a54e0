// The host's side of the frame, without a browser: every call settles, and what is posted is what the frame accepts.

import assert from 'node:assert/strict';
import { afterEach, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { connectFrame } from '../../dist/sdk/frame/host.js';
import { messageToFrame } from '../../dist/sdk/frame/messages.js';

const ORIGIN = 'https://files.example';
const UNSETTLED = Symbol('unsettled');

/** A connected frame whose messages are kept. `ready` is what the page in it says, `page` when it was loaded; `load` is the event of the browser. */
function hosted(listener) {
  const listeners = new Set();
  const loads = new Set();
  globalThis.location = { href: 'https://shop.example/' };
  globalThis.window = { addEventListener: (_, listen) => listeners.add(listen), removeEventListener: (_, listen) => listeners.delete(listen) };
  const posted = [];
  const contentWindow = { postMessage: (message) => posted.push(structuredClone(message)) };
  const iframe = { src: `${ORIGIN}/frame.html`, contentWindow, addEventListener: (_, listen) => loads.add(listen), removeEventListener: (_, listen) => loads.delete(listen) };
  const frame = connectFrame(iframe, listener);
  const say = (message) => listeners.forEach((listen) => listen({ source: contentWindow, origin: ORIGIN, data: { kerfway: 1, ...message } }));
  /** What the frame has accepted since this was asked last. */
  const accepted = () => posted.splice(0).map(messageToFrame).filter((message) => message?.type !== 'hello');
  return { frame, say, accepted, load: () => loads.forEach((listen) => listen()), ready: (page = 1) => say({ type: 'ready', page, machines: [], methods: [] }) };
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

/** A function that lets seconds pass, instead of the clock. Node's own replacement keeps an interval that is cleared while it runs. */
function clock(t) {
  const ticks = new Set();
  t.mock.method(globalThis, 'setInterval', (tick) => (ticks.add(tick), tick));
  t.mock.method(globalThis, 'clearInterval', (tick) => ticks.delete(tick));
  return (seconds) => {
    for (let k = 0; k < seconds; k += 1) ticks.forEach((tick) => tick());
  };
}

/** What a promise has come to by now; `UNSETTLED` if it waits. */
async function byNow(promise) {
  return Promise.race([promise.then((value) => value, (error) => error), (async () => {
    for (let k = 0; k < 20; k += 1) await null;
    return UNSETTLED;
  })()]);
}

it('a call to a frame that never loads, or whose page never answers, never settled', async (t) => {
  const pass = clock(t);
  const { frame, accepted, load, ready } = hosted();
  frame.setOptions({ seconds: 1 });
  const calls = [frame.open(new ArrayBuffer(3), 'a.dxf'), frame.quote(new ArrayBuffer(3), 'a.dxf'), frame.render('svg')];
  // A slow network: the page after 100 seconds, and its planner not within another 100.
  pass(100);
  load();
  pass(100);
  for (const call of calls) assert.equal(await byNow(call), UNSETTLED);
  pass(20);
  for (const call of calls) {
    const { code, retryable, message, params } = await byNow(call);
    assert.deepEqual([code, retryable, params], ['not-started', true, { seconds: 120 }]);
    assert.equal(message, 'The frame has not answered for 120 seconds. Check that https://files.example/frame.html is the frame page, and that "host" in its address is https://shop.example, then try again.');
  }
  // It answers after all: what nobody waits for is not done.
  ready();
  assert.deepEqual(accepted(), [{ type: 'options', options: { seconds: 1 } }]);
});

it('a frame that fell silent never settled its call, and one that reports its progress is not given up', async (t) => {
  const pass = clock(t);
  const { frame, say, ready } = hosted();
  ready();
  const opened = frame.open(new ArrayBuffer(3), 'a.dxf');
  for (let k = 0; k < 5; k += 1) {
    pass(290);
    say({ type: 'progress', progress: {} });
  }
  assert.equal(await byNow(opened), UNSETTLED);
  pass(300);
  const { code, message } = await byNow(opened);
  assert.deepEqual([code, message], ['planner-died', 'The frame has not answered for 300 seconds. Load the frame again, then open the drawing again.']);
  // Silence between two calls is none.
  pass(1000);
  const second = frame.open(new ArrayBuffer(3), 'a.dxf');
  pass(290);
  assert.equal(await byNow(second), UNSETTLED);
  frame.disconnect();
  await assert.rejects(second, { code: 'closed' });
});

it('a frame whose planner could not start left its calls waiting', async () => {
  const heard = [];
  const { frame, say, accepted, ready } = hosted({ onError: (message, { code }) => heard.push([message, code]) });
  const opened = frame.open(new ArrayBuffer(3), 'a.dxf');
  const error = { code: 'not-started', message: 'The planner could not be started.', params: {}, retryable: true };
  say({ type: 'error', error });
  const [message] = accepted();
  assert.deepEqual([message?.type, heard], ['open', [[error.message, error.code]]]);
  say({ type: 'refused', id: message.id, error });
  assert.equal((await settled(opened)).code, 'not-started');
  // Loaded again, it starts.
  frame.setOptions({ seconds: 1 });
  ready(2);
  assert.deepEqual(accepted().at(-1), { type: 'options', options: { seconds: 1 } });
});

it('a call could not be aborted', async () => {
  const { frame, accepted, ready } = hosted();
  const reason = new Error('no longer wanted');
  const open = (signal) => frame.open(new ArrayBuffer(3), 'a.dxf', { signal });
  assert.equal(await settled(open(AbortSignal.abort(reason))), reason);
  const waiting = new AbortController();
  const early = open(waiting.signal);
  waiting.abort(reason);
  assert.equal(await settled(early), reason);
  ready();
  assert.deepEqual(accepted(), []);

  const [first, second, third] = [1, 2, 3].map(() => new AbortController());
  const [replaced, running, picture] = [open(first.signal), open(second.signal), frame.render('svg', { signal: third.signal })];
  accepted();
  first.abort(reason);
  third.abort(reason);
  assert.deepEqual([await settled(replaced), await settled(picture), accepted()], [reason, reason, []]);
  second.abort(reason);
  assert.deepEqual([await settled(running), accepted()], [reason, [{ type: 'stop' }]]);
  assert.equal((await settled(open('signal'))).code, 'wrong-type');
  assert.equal((await settled(frame.quote(new ArrayBuffer(3), 'a.dxf', { name: 'b' }))).code, 'unknown-field');
});
