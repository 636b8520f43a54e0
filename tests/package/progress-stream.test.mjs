// The progress stream with readers slower than the search. The test pushes the progress itself, so no result depends on timing.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { ProgressStream } from '../../dist/sdk/progress-stream.js';

const step = (moves, path = null) => ({ moves, path });

describe('the progress stream of a plan', () => {
  it('merges what a slow reader has missed, and loses no path', async () => {
    const stream = new ProgressStream(() => assert.fail('no reader has left'));
    const slow = stream[Symbol.asyncIterator]();
    const quick = stream[Symbol.asyncIterator]();
    const all = [step(1, 'first'), step(2), step(3, 'better'), step(4)];
    const read = [];
    for (const one of all) {
      stream.push(one);
      read.push((await quick.next()).value);
    }
    assert.deepEqual(read, all);
    assert.deepEqual(await slow.next(), { done: false, value: step(4, 'better') });
    stream.push(step(5));
    stream.push(step(6));
    stream.end();
    assert.deepEqual(await slow.next(), { done: false, value: step(6) });
    assert.deepEqual(await slow.next(), { done: true, value: undefined });
    assert.equal((await quick.next()).value.moves, 6);
  });

  it('wakes a reader that waits', async () => {
    const stream = new ProgressStream(() => {});
    const reader = stream[Symbol.asyncIterator]();
    const first = reader.next();
    stream.push(step(1));
    assert.deepEqual(await first, { done: false, value: step(1) });
    const last = reader.next();
    stream.end();
    assert.deepEqual(await last, { done: true, value: undefined });
  });

  it('calls onLeave when a reader leaves its loop', async () => {
    let left = 0;
    const stream = new ProgressStream(() => (left += 1));
    const leaving = (async () => {
      for await (const _ of stream) break;
    })();
    stream.push(step(1));
    await leaving;
    assert.equal(left, 1);
    stream.end();
    for await (const _ of stream) assert.fail('there is no more');
    assert.equal(left, 1);
  });

  it('throws the error once for each reader, after unread progress', async () => {
    const stream = new ProgressStream(() => {});
    const reader = stream[Symbol.asyncIterator]();
    stream.push(step(1));
    stream.end({ error: new Error('lost') });
    assert.equal((await reader.next()).value.moves, 1);
    await assert.rejects(reader.next(), /lost/);
    assert.deepEqual(await reader.next(), { done: true, value: undefined });
    await assert.rejects(stream[Symbol.asyncIterator]().next(), /lost/);
  });
});
