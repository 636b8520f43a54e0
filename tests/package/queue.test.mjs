// examples/queue: two hundred uploads, some of them broken, and several worker processes, one of which is killed.

import assert from 'node:assert/strict';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { Queue, QueueEvents } from 'bullmq';
import { quote } from 'kerfway';
import { bytes, circle, dxf, folder, KEYBOARD, ROOT, shared, square } from './support.mjs';

const REDIS = ['valkey-server', 'redis-server'].some((name) => spawnSync(name, ['--version']).status === 0);
const skip = REDIS || process.env.REDIS_URL ? false : 'there is neither valkey-server nor redis-server here: apt-get install redis-server';

const BROKEN = [
  [new Uint8Array(0), /empty/],
  [Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a), /PNG/],
  [new TextEncoder().encode('AC1032\0\0'), /DWG/],
];
const GOOD = 140;
const WORKERS = 3;

/** The example, started as a person would start it, and the events of its queue. */
async function started(t) {
  const drawings = folder(t);
  const env = { ...process.env, PORT: '0', WORKERS: String(WORKERS), DRAWINGS: drawings };
  const child = spawn(process.execPath, [join(ROOT, 'examples', 'queue', 'start.mjs')], { env, stdio: ['ignore', 'pipe', 'inherit'] });
  let told = '';
  child.stdout.on('data', (d) => (told += d));
  const said = async (pattern) => {
    for (let k = 0; k < 600; k++) {
      const found = pattern.exec(told);
      if (found !== null) return found[1];
      await wait(50);
    }
    throw new assert.AssertionError({ message: `nothing like ${pattern} in: ${told}` });
  };
  const [redis, url] = [await said(/Queue at (\S+)/), await said(/(http:\S+\/quotes)/)];
  const queue = new Queue('quotes', { connection: { url: redis } });
  const events = new QueueEvents('quotes', { connection: { url: redis } });
  await events.waitUntilReady();
  const seen = { completed: [], failed: [], stalled: [] };
  for (const type of Object.keys(seen)) events.on(type, ({ jobId }) => seen[type].push(jobId));
  // The client disconnects before the queue is closed.
  let ended = null;
  const end = () =>
    (ended ??= (async () => {
      await Promise.all([queue.close(), events.close()]);
      child.kill('SIGTERM');
      return once(child, 'exit');
    })());
  t.after(end);
  return { child, end, url, queue, seen, drawings, said };
}

const send = async (url, body, name) => {
  const answer = await fetch(`${url}?name=${name}`, { method: 'POST', body });
  assert.equal(answer.status, 202);
  return (await answer.json()).id;
};

async function answer(url, id) {
  for (;;) {
    const told = await fetch(`${url}/${id}`);
    if (told.status !== 202) return { status: told.status, body: await told.json() };
    await wait(50);
  }
}

/** The memory of each process of the example, in megabytes. */
function held(child) {
  const rows = execFileSync('ps', ['-A', '-o', 'pid=,ppid=,rss='], { encoding: 'utf8' }).trim().split('\n').map((r) => r.trim().split(/\s+/).map(Number));
  return rows.filter(([, parent]) => parent === child.pid).map(([, , kB]) => kB / 1e3);
}

/** Kills the worker that has this job, once it is another one than before; returns its id. */
async function killed(queue, id, before) {
  for (;;) {
    const job = await queue.getJob(id);
    if ((await job.getState()) === 'active' && job.processedBy !== undefined && job.processedBy !== before) {
      process.kill(Number(job.processedBy), 'SIGKILL');
      return job.processedBy;
    }
    await wait(5);
  }
}

describe('the queue', { skip, timeout: 240_000 }, () => {
  it('quotes every usable one of two hundred uploads once and answers the others, even if a worker is killed', async (t) => {
    const { child, url, queue, seen, drawings, said } = await started(t);
    // This drawing takes long, so that its worker can be killed during the work.
    const long = await send(url, bytes('sheets/sheet_2000.dxf'), 'long.dxf');
    const victim = await killed(queue, long);

    const upload = (k) => (k < GOOD ? dxf(square(0, 0, 20 + k), circle(10, 10, 4)) : BROKEN[k % 3][0]);
    // 199 drawings and their names, and the long one: 200.
    const order = Array.from({ length: 199 }, (_, i) => (i * 67) % 199);
    const ids = new Map();
    await Promise.all(order.map(async (k) => ids.set(k, await send(url, upload(k), `${k}.dxf`))));
    const answers = new Map(await Promise.all(order.map(async (k) => [k, await answer(url, ids.get(k))])));
    for (const [k, { status, body }] of answers) {
      if (k < GOOD) {
        assert.equal(status, 200, body.problem);
        assert.deepEqual([body.input.name, ...body.bounds.slice(2)], [`${k}.dxf`, 20 + k, 20 + k]);
      } else {
        assert.equal(status, 422);
        assert.match(body.problem, BROKEN[k % 3][1]);
      }
    }
    const last = await answer(url, long);
    assert.equal(last.status, 200, last.body.problem);

    await said(new RegExp(`Worker (${victim}) ended \\(SIGKILL\\)`));
    assert.deepEqual(seen.stalled, [long]);
    assert.deepEqual([...seen.completed].sort(), [long, ...order.filter((k) => k < GOOD).map((k) => ids.get(k))].sort());
    assert.deepEqual([...seen.failed].sort(), order.filter((k) => k >= GOOD).map((k) => ids.get(k)).sort());
    for (let k = 0; k < 100 && readdirSync(drawings).length > 0; k++) await wait(50);
    assert.deepEqual(readdirSync(drawings), []);

    // Repeated uploads cause no further work, and take no more memory.
    const before = held(child);
    assert.equal(await send(url, upload(7), '7.dxf'), ids.get(7));
    await Promise.all(order.map(async (k) => answer(url, await send(url, upload(k), `again-${k}.dxf`))));
    assert.equal(seen.completed.filter((id) => id === ids.get(7)).length, 1);
    const after = held(child);
    assert.equal(after.length, before.length);
    for (const [k, megabytes] of after.entries()) assert.ok(megabytes < before[k] + 60, `${before} MB, then ${after} MB`);
  });

  it('gives up a drawing that killed two workers, with a sentence, and continues', async (t) => {
    const { url, queue } = await started(t);
    const deadly = await send(url, bytes('sheets/sheet_2000.dxf'), 'deadly.dxf');
    await killed(queue, deadly, await killed(queue, deadly));
    assert.deepEqual(await answer(url, deadly), { status: 422, body: { problem: 'Two workers died of this drawing. It may need more memory than there is.' } });
    assert.equal((await answer(url, await send(url, dxf(square(0, 0, 30)), 'next.dxf'))).status, 200);
  });
});

describe('the queue, alive', { skip, timeout: 240_000 }, () => {
  const usual = shared(started);

  it('returns the sentence of the package, and refuses unknown requests', async () => {
    const { url } = usual;
    const asked = await fetch(`${url}?name=keyboard.dxf&machine=diode-hobby&thickness=3&density=0.7`, { method: 'POST', body: bytes(KEYBOARD) });
    const { status, body } = await answer(url, (await asked.json()).id);
    assert.equal(status, 200);
    const options = { name: 'keyboard.dxf', machine: 'diode-hobby', material: { thickness: 3, density: 0.7 }, moves: 10_000, seed: 1 };
    assert.deepEqual(body, JSON.parse(JSON.stringify(await quote(bytes(KEYBOARD), options))));
    assert.equal((await fetch(`${url}/nothing`)).status, 404);
    assert.equal((await fetch(url, { method: 'POST', body: new Uint8Array(21 * 2 ** 20) })).status, 413);
  });

  it('refuses a form, which is not a drawing', async () => {
    const { url } = usual;
    const form = new FormData();
    form.set('drawing', new Blob([dxf(square(0, 0, 30))]), 'plate.dxf');
    const envelope = await new Response(form).arrayBuffer();
    for (const body of [form, envelope]) {
      const refused = await fetch(url, { method: 'POST', body });
      assert.equal(refused.status, 415);
      assert.match((await refused.json()).problem, /is a form/);
    }
  });

  it('names the wrong field of the query', async () => {
    const { url } = usual;
    for (const [query, message] of [['thickness=3mm', /field thickness/], ['machine=jelly', /field machine/], ['thicknes=3', /no field "thicknes"/]]) {
      const refused = await fetch(`${url}?${query}`, { method: 'POST', body: dxf(square(0, 0, 30)) });
      assert.equal(refused.status, 400, query);
      assert.match((await refused.json()).problem, message);
    }
  });

  it('answers 500 to an internal error, without details', async () => {
    const { queue, url } = usual;
    // A job without its drawing: the file was lost, which is no fault of the sender.
    await queue.add('quote', {}, { jobId: 'lost', attempts: 1 });
    const { status, body } = await answer(url, 'lost');
    assert.deepEqual([status, body.problem], [500, 'The quote could not be made because of a fault of the server. Try again later.']);
  });

  it('ends when it is told to', async () => assert.deepEqual(await usual.end(), [0, null]));
});
