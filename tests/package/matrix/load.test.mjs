// npm run test:matrix: the service under a bounded load on the loopback address, a third of it hostile; and the queue, whose workers
// are killed at random.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { quote } from 'kerfway';
import { hostile } from '../hostile.mjs';
import { serve } from '../serving.mjs';
import { circle, CLI, dxf, square } from '../support.mjs';

describe('kerfway serve', () => {
  it('answers 1,000 uploads, 16 at once, a third of them hostile, on a plateau of memory', { timeout: 900_000 }, async (t) => {
    const { url, send, metric } = await serve(t, '--largest', '1', '--upload-seconds', '1');
    const { wrong, times, memory } = await hostile({ url, send, metric, uploads: 1000, atOnce: 16 });
    const at = (share) => Math.round(times[Math.floor(times.length * share)]);
    const [middle, end] = memory.map((b) => b / 1e6);
    console.log(`${times.length} good uploads: p50 ${at(0.5)} ms, p99 ${at(0.99)} ms; memory ${middle.toFixed(0)} MB at the middle, ${end.toFixed(0)} MB at the end`);
    assert.deepEqual(wrong, []);
    assert.ok(end < 1.25 * middle + 20, `${middle} MB, ${end} MB`);
  });
});

const redisServer = ['valkey-server', 'redis-server'].find((name) => spawnSync(name, ['--version']).status === 0);

describe('kerfway serve --queue', { skip: redisServer === undefined ? 'there is no Redis or Valkey' : false }, () => {
  it('does every job once, by its hash, while workers are killed at random', { timeout: 900_000 }, async (t) => {
    const free = createServer().listen(0, '127.0.0.1');
    await once(free, 'listening');
    const { port } = free.address();
    free.close();
    await once(free, 'close');
    const redis = spawn(redisServer, ['--bind', '127.0.0.1', '--port', String(port), '--save', '', '--appendonly', 'no', '--maxmemory-policy', 'noeviction'], { stdio: 'ignore' });
    t.after(() => redis.kill('SIGKILL'));
    const queue = `redis://127.0.0.1:${port}`;
    const { send, url } = await serve(t, '--queue', queue, '--waiting', '500');
    let ended = false;
    const workers = new Set();
    const work = () => {
      const worker = spawn(process.execPath, [CLI, 'work', '--queue', queue, '--workers', '1'], { stdio: 'ignore' });
      workers.add(worker);
      worker.on('exit', () => {
        workers.delete(worker);
        if (!ended) setTimeout(() => !ended && work(), 200);
      });
    };
    work();
    work();
    t.after(() => {
      ended = true;
      for (const worker of workers) worker.kill('SIGKILL');
    });
    const JOBS = 60;
    const drawings = Array.from({ length: JOBS }, (_, k) => dxf(square(0, 0, 20 + k), circle(10, 10, 4)));
    const query = '/quote?moves=20000&seed=1&name=x.dxf';
    const accepted = await Promise.all(drawings.map(async (drawing) => send(query, drawing)));
    assert.deepEqual(new Set(accepted.map((a) => a.status)), new Set([202]));
    const ids = await Promise.all(accepted.map(async (a) => (await a.json()).id));
    assert.equal(new Set(ids).size, JOBS);
    // The same upload is the same job.
    assert.equal((await (await send(query, drawings[0])).json()).id, ids[0]);
    let killed = 0;
    const killing = (async () => {
      while (!ended && killed < 6) {
        await wait(1500 + ((killed * 977) % 1500));
        const [victim] = workers;
        if (victim === undefined) continue;
        victim.kill('SIGKILL');
        killed += 1;
      }
    })();
    const hashes = await Promise.all(ids.map(async (id) => {
      for (;;) {
        const response = await fetch(`${url}/jobs/${id}`);
        if (response.status === 200) return (await response.json()).hash;
        assert.equal(response.status, 202, await response.clone().text());
        await wait(400);
      }
    }));
    ended = true;
    await killing;
    const expected = await Promise.all(drawings.map(async (drawing) => (await quote(drawing, { moves: 20_000, seed: 1 })).hash));
    assert.deepEqual(hashes, expected);
    console.log(`${JOBS} jobs, ${killed} workers killed`);
    assert.ok(killed >= 2);
  });
});
