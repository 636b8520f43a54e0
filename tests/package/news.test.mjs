// News for those who read slower than they come. Told by hand, so that no clock has a say.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { News } from '../../dist/sdk/news.js';

const step = (moves, path = null) => ({ moves, path });

describe('news of a plan', () => {
  it('merges what a slow reader missed, and loses no path', async () => {
    const news = new News(() => assert.fail('nobody left'));
    const slow = news[Symbol.asyncIterator]();
    const quick = news[Symbol.asyncIterator]();
    const all = [step(1, 'first'), step(2), step(3, 'better'), step(4)];
    const read = [];
    for (const one of all) {
      news.tell(one);
      read.push((await quick.next()).value);
    }
    assert.deepEqual(read, all);
    assert.deepEqual(await slow.next(), { done: false, value: step(4, 'better') });
    news.tell(step(5));
    news.tell(step(6));
    news.end();
    assert.deepEqual(await slow.next(), { done: false, value: step(6) });
    assert.deepEqual(await slow.next(), { done: true, value: undefined });
    assert.equal((await quick.next()).value.moves, 6);
  });

  it('wakes whoever waits', async () => {
    const news = new News(() => {});
    const reader = news[Symbol.asyncIterator]();
    const first = reader.next();
    news.tell(step(1));
    assert.deepEqual(await first, { done: false, value: step(1) });
    const last = reader.next();
    news.end();
    assert.deepEqual(await last, { done: true, value: undefined });
  });

  it('hears of who leaves, who then reads no more', async () => {
    let left = 0;
    const news = new News(() => (left += 1));
    const leaving = (async () => {
      for await (const _ of news) break;
    })();
    news.tell(step(1));
    await leaving;
    assert.equal(left, 1);
    news.end();
    for await (const _ of news) assert.fail('there is no more');
    assert.equal(left, 1);
  });

  it('fails each reader once, after what it has not read', async () => {
    const news = new News(() => {});
    const reader = news[Symbol.asyncIterator]();
    news.tell(step(1));
    news.end({ error: new Error('lost') });
    assert.equal((await reader.next()).value.moves, 1);
    await assert.rejects(reader.next(), /lost/);
    assert.deepEqual(await reader.next(), { done: true, value: undefined });
    await assert.rejects(news[Symbol.asyncIterator]().next(), /lost/);
  });
});
