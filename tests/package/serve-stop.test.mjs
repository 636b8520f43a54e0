// kerfway serve begins with settings that make sense, takes what it has room for, and ends in order.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { Agent, request } from 'node:http';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { Queue } from 'bullmq';
import { serve as startService } from '../../dist/sdk/server/serve.js';
import { DEFAULTS } from '../../dist/sdk/server/settings.js';
import { form, serve } from './serving.mjs';
import { bytes, circle, CLI, dxf, folder, kerfway, KEYBOARD, square } from './support.mjs';

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = 'moves=1000&seed=1';

/** Waits until the service answers this many requests. */
async function running(url, count) {
  while ((await (await fetch(`${url}/healthz`)).json()).running !== count) await wait(20);
}

/** A service in this process, whose backend the test makes. */
async function own(t, backend, settings = {}) {
  const service = await startService({ ...DEFAULTS, workers: 8, port: 0, grace: 1, ...settings }, { full: async () => false, find: async () => null, waiting: () => 0, close: async () => {}, ...backend }, '0', () => {});
  t.after(() => service.stop());
  return service;
}

describe('the service, when it starts', () => {
  it('is started with settings that make sense, or not at all', async (t) => {
    for (const [args, exit, says] of [
      [['--port', '99999'], 2, /--port 99999/], [['--host', '203.0.113.1', '--port', '0'], 1, /This computer has no such address\. Choose another with --host\./], [['--workers', '0'], 2, /--workers 0/], [['--cors', 'shop.example'], 2, /--cors/], [['plate.dxf'], 2, /options only/],
      [['--keys', join(folder(t), 'none')], 1, /cannot be read/], [['--queue', 'localhost'], 2, /--queue/],
    ]) {
      const { code, stderr } = await kerfway('serve', ...args);
      assert.deepEqual([code, says.test(stderr)], [exit, true], stderr);
    }
    assert.equal((await kerfway('work')).code, 2);
  });

  it('took times that no timer can wait, and ended what it should have waited for at once', async () => {
    for (const [args, says] of [
      [['--grace', '3000000'], /^kerfway: --grace 3000000: give at most 2147000 seconds, which are 24 days\.\n/], [['--upload-seconds', '1e9'], /--upload-seconds 1000000000: give at most/],
      [['--expires', '0'], /--expires 0: give a whole number of seconds from 1 to 31536000\./], [['--expires', '0.5'], /--expires 0\.5: give a whole number/],
      [['--queue', 'redis://127.0.0.1:1', '--waiting', '0'], /--waiting 0: in a queue every job waits/],
    ]) {
      const { code, stderr } = await kerfway('serve', ...args);
      assert.deepEqual([code, says.test(stderr)], [2, true], stderr);
    }
  });
});

describe('the room of a service', () => {
  it('was none at all with --waiting 0', async (t) => {
    const { url, send } = await serve(t, '--workers', '1', '--waiting', '0');
    assert.equal((await send(`/quote?${SHORT}`, PLATE)).status, 200);
    await running(url, 0);
    const control = new AbortController();
    const long = send('/plan?seconds=30&seed=1', bytes(KEYBOARD), { signal: control.signal });
    await running(url, 1);
    assert.equal((await send(`/quote?${SHORT}`, PLATE)).status, 429);
    control.abort();
    await assert.rejects(long, { name: 'AbortError' });
  });

  it('was that of the queue when an upload began, and any number of them was put into it', async (t) => {
    const taken = [];
    const service = await own(t, { full: async (arriving) => taken.length + arriving >= 2, take: async ({ name }) => (taken.push(name), { status: 200, body: {} }) });
    /** An upload whose body ends when the test says so. */
    const upload = (name) => {
      const sent = request(`${service.url}/inspect?name=${name}`, { method: 'POST', headers: { 'content-length': 2 } });
      const status = once(sent, 'response').then(([response]) => (response.resume(), response.statusCode));
      // The rest of a body that is refused has no reader.
      sent.on('error', () => {});
      sent.write('x');
      return { status, end: () => sent.end('x') };
    };
    const [first, second] = [upload('first'), upload('second')];
    await running(service.url, 2);
    assert.equal(await upload('third').status, 429);
    for (const { end } of [first, second]) end();
    assert.deepEqual([await first.status, await second.status, taken.sort()], [200, 200, ['first', 'second']]);
    assert.equal(await upload('fourth').status, 429);
    taken.length = 0;
    const fifth = upload('fifth');
    fifth.end();
    assert.deepEqual([await fifth.status, taken], [200, ['fifth']]);
  });

  it('has drawings with the name that their options give', async (t) => {
    const service = await own(t, { take: async ({ name }) => ({ status: 200, body: { name } }) });
    const named = async (query, fields) => (await (await fetch(`${service.url}/inspect${query}`, { method: 'POST', body: form(PLATE, 'file.dxf', fields) })).json()).name;
    // The option was taken and had no effect.
    assert.deepEqual([await named('', {}), await named('', { options: { name: 'option.dxf' } }), await named('?name=query.dxf', { options: { name: 'option.dxf' } })], ['file.dxf', 'option.dxf', 'query.dxf']);
  });
});

describe('the service, when it is stopped', () => {
  it('finishes what runs when it is stopped, and refuses what comes then', async (t) => {
    const { child, url, send, log } = await serve(t, '--workers', '1');
    const running = send('/plan?seconds=2&seed=1', bytes(KEYBOARD));
    await wait(800);
    child.kill('SIGTERM');
    await wait(200);
    await assert.rejects(fetch(`${url}/healthz`));
    assert.equal((await running).status, 200);
    if (child.exitCode === null) await new Promise((resolve) => child.once('exit', resolve));
    assert.deepEqual(log.map((l) => l.event), ['started', 'stopping', 'request', 'stopped']);
    assert.equal(child.exitCode, 0);
  });

  it('kept connections for a next request that it would refuse', async (t) => {
    const { child, url, log } = await serve(t, '--workers', '1');
    const agent = new Agent({ keepAlive: true });
    t.after(() => agent.destroy());
    const sent = request(`${url}/plan?seconds=2&seed=1`, { method: 'POST', agent });
    sent.end(bytes(KEYBOARD));
    await running(url, 1);
    child.kill('SIGTERM');
    const [response] = await once(sent, 'response');
    assert.deepEqual([response.statusCode, response.headers.connection], [200, 'close']);
    response.resume();
    const answered = performance.now();
    const [code] = await once(child, 'exit');
    // An idle connection is kept for five seconds.
    assert.ok(performance.now() - answered < 4_000, `${performance.now() - answered} ms`);
    assert.deepEqual([code, log.at(-1).event], [0, 'stopped']);
  });

  it('a second signal ends it at once, whichever the first was', async (t) => {
    for (const [first, second, exit] of [['SIGINT', 'SIGTERM', 143], ['SIGTERM', 'SIGTERM', 143], ['SIGTERM', 'SIGINT', 130], ['SIGINT', 'SIGINT', 130]]) {
      const { child, url, send, log } = await serve(t, '--workers', '1');
      const lost = assert.rejects(send('/plan?seconds=60&seed=1', bytes(KEYBOARD)));
      await running(url, 1);
      child.kill(first);
      while (!log.some(({ event }) => event === 'stopping')) await wait(20);
      child.kill(second);
      const [code] = await Promise.race([once(child, 'exit'), wait(5_000, ['still running'], { ref: false })]);
      assert.equal(code, exit, `${first}, ${second}`);
      await lost;
    }
  });

  it('twice, the second call ended before the service had', async (t) => {
    let closed = false;
    const service = await own(t, { close: async () => {
      await wait(50);
      closed = true;
    } });
    void service.stop();
    await service.stop();
    assert.equal(closed, true);
  });

  const REDIS = ['valkey-server', 'redis-server'].find((name) => spawnSync(name, ['--version']).status === 0);
  const skip = REDIS === undefined;
  /** The server of a queue, and its address. */
  const queueServer = async (t) => {
    const free = createServer().listen(0, '127.0.0.1');
    await once(free, 'listening');
    const { port } = free.address();
    free.close();
    const redis = spawn(REDIS, ['--port', String(port), '--bind', '127.0.0.1', '--save', '', '--dir', folder(t)], { stdio: 'ignore' });
    t.after(() => redis.kill('SIGKILL'));
    return { redis, address: `redis://127.0.0.1:${port}` };
  };
  for (const signal of ['SIGKILL', 'SIGSTOP']) {
    it(`did not stop when the server of its queue had gone (${signal}) and was asked meanwhile`, { skip }, async (t) => {
      const { redis, address } = await queueServer(t);
      const { send, stop } = await serve(t, '--queue', address);
      while ((await send(`/quote?${SHORT}`, PLATE)).status !== 202) await wait(50);
      redis.kill(signal);
      assert.equal((await send(`/quote?${SHORT}`, PLATE)).status, 503);
      const [code] = await Promise.race([stop(), wait(20_000, ['still running'])]);
      assert.equal(code, 0);
    });
  }

  /** `kerfway work`, once it says that it runs, with the lines of its log. */
  const worker = async (t, address) => {
    const child = spawn(process.execPath, [CLI, 'work', '--queue', address, '--workers', '1'], { stdio: ['ignore', 'pipe', 'pipe'] });
    t.after(() => child.kill('SIGKILL'));
    let log = '';
    child.stderr.on('data', (data) => (log += data));
    const logged = async (words, ms) => {
      for (const until = Date.now() + ms; !log.includes(words); await wait(50)) assert.ok(Date.now() < until, `not within ${ms} ms: ${words}`);
    };
    const stop = () => (child.kill('SIGTERM'), Promise.race([once(child, 'exit'), wait(20_000, ['still running'])]));
    await once(child.stdout, 'data');
    return { logged, stop };
  };
  const SILENT = 'The queue does not answer within 5 seconds.';

  it('as a worker without its queue did not stop when it was told to', async (t) => {
    const { stop } = await worker(t, 'redis://127.0.0.1:1');
    assert.equal((await stop())[0], 0);
  });

  it('as a worker said nothing about a queue that takes connections and never answers', async (t) => {
    const mute = createServer((connection) => connection.on('error', () => {}).resume()).listen(0, '127.0.0.1');
    t.after(() => mute.close());
    await once(mute, 'listening');
    const { logged, stop } = await worker(t, `redis://127.0.0.1:${mute.address().port}`);
    await logged(SILENT, 15_000);
    assert.equal((await stop())[0], 0);
  });

  it('as a worker did not stop when its queue hung, and said nothing', { skip }, async (t) => {
    const { redis, address } = await queueServer(t);
    const { logged, stop } = await worker(t, address);
    const queue = new Queue('kerfway', { connection: { url: address } });
    t.after(() => queue.close());
    while ((await queue.getWorkers()).length === 0) await wait(50);
    redis.kill('SIGSTOP');
    await logged(SILENT, 20_000);
    redis.kill('SIGCONT');
    await logged('The queue answers again.', 5_000);
    redis.kill('SIGSTOP');
    assert.equal((await stop())[0], 0);
    redis.kill('SIGCONT');
  });
});
