// examples/express: many simultaneous uploads, some of them broken, clients that disconnect, and an orderly shutdown.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { quote } from 'kerfway';
import { bytes, circle, dxf, KEYBOARD, line, ROOT, square } from './support.mjs';

let server, url;
/** Code in the server's process that records the workers and can end them. */
const PRELOAD = `data:text/javascript,${encodeURIComponent(`
  const workers = new Set();
  process.on('worker', (worker) => {
    workers.add(worker);
    worker.on('exit', () => workers.delete(worker));
  });
  process.on('SIGUSR2', () => {
    Promise.all([...workers].map((worker) => worker.terminate())).then(() => console.log('the workers died'));
  });
`)}`;
/** The first worker, which lists the machines, survives; the workers of the pool die as soon as they start. */
const DYING = `data:text/javascript,${encodeURIComponent(`
  let started = 0;
  process.on('worker', (worker) => started++ > 0 && worker.terminate());
`)}`;

async function start(t, preload, stderr = 'ignore') {
  const server = spawn(process.execPath, ['--import', preload, join(ROOT, 'examples', 'express', 'server.mjs')], { env: { ...process.env, PORT: '0' }, stdio: ['ignore', 'pipe', stderr] });
  t?.after(() => server.kill());
  const [told] = await once(server.stdout, 'data');
  return { server, url: /http:\S+\/quotes/.exec(String(told))[0] };
}

before(async () => {
  ({ server, url } = await start(null, PRELOAD, 'inherit'));
});
after(() => server.kill());

const send = (body, query = '') => fetch(`${url}${query}`, { method: 'POST', body, headers: { 'content-type': 'image/vnd.dxf' } });
const health = async () => (await fetch(new URL('/health', url))).json();

const BROKEN = [
  [new Uint8Array(0), /empty/],
  [Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a), /PNG/],
  [new TextEncoder().encode('AC1032\0\0'), /DWG/],
];

describe('the upload server', () => {
  it('answers two hundred simultaneous uploads, each with its own report, without using more memory', async () => {
    const wave = async (count) => {
      const uploads = Array.from({ length: count }, (_, k) => (k % 10 < 3 ? BROKEN[k % 10][0] : dxf(square(0, 0, 20 + k), circle(10, 10, 4))));
      const answers = await Promise.all(uploads.map((body, k) => send(body, `?name=${k}.dxf`)));
      const told = await Promise.all(answers.map((a) => a.json()));
      for (const [k, { status }] of answers.entries()) {
        if (k % 10 < 3) {
          assert.equal(status, 422);
          assert.match(told[k].problem, BROKEN[k % 10][1]);
        } else {
          assert.equal(status, 200, told[k].problem);
          assert.equal(told[k].input.name, `${k}.dxf`);
          assert.deepEqual(told[k].bounds.slice(2), [20 + k, 20 + k]);
        }
      }
    };
    await wave(60);
    const { megabytes } = await health();
    await wave(200);
    const { megabytes: later, waiting } = await health();
    assert.equal(waiting, 0);
    assert.ok(later < megabytes + 60, `${megabytes} MB, then ${later} MB`);
  });

  it('answers every upload, even if its workers die', async () => {
    const died = once(server.stdout, 'data');
    // Long enough that a worker is at it when they die; the others wait or come after it.
    const long = send(bytes('sheets/sheet_2000.dxf'));
    await new Promise((resolve) => setTimeout(resolve, 150));
    const sent = Array.from({ length: 60 }, (_, k) => send(k % 10 < 3 ? BROKEN[k % 10][0] : dxf(square(0, 0, 20 + k)), `?name=${k}.dxf`));
    server.kill('SIGUSR2');
    assert.match(String(await died), /the workers died/);
    const answers = await Promise.all(sent);
    assert.deepEqual(answers.map((a) => a.status), answers.map((_, k) => (k % 10 < 3 ? 422 : 200)));
    assert.deepEqual((await Promise.all(answers.map((a) => a.json()))).map((a) => a.input?.name ?? a.problem.length > 0), answers.map((_, k) => (k % 10 < 3 ? true : `${k}.dxf`)));
    assert.equal((await long).status, 200);
  });

  it('returns the sentence of the package', async () => {
    const told = await (await send(bytes(KEYBOARD), '?machine=diode-hobby&thickness=3&density=0.7')).json();
    const material = { thickness: 3, density: 0.7 };
    assert.deepEqual(told, await quote(bytes(KEYBOARD), { machine: 'diode-hobby', material, moves: 10_000, seed: 1 }));
    assert.ok(told.weight > 0);
  });

  it('refuses a form, which is not a drawing', async () => {
    const form = new FormData();
    form.set('drawing', new Blob([dxf(square(0, 0, 30))]), 'plate.dxf');
    const multipart = await fetch(url, { method: 'POST', body: form });
    assert.equal(multipart.status, 415);
    assert.match((await multipart.json()).problem, /is a form.*Send the bytes of the DXF file alone/);
    // A form under another name is a form.
    const envelope = await new Response(form).arrayBuffer();
    assert.equal((await send(envelope)).status, 415);
  });

  it('accepts the bytes of a drawing with any content type', async () => {
    for (const type of ['application/octet-stream', 'application/x-www-form-urlencoded', 'text/plain', 'application/dxf', 'application/json']) {
      const answer = await fetch(url, { method: 'POST', body: dxf(square(0, 0, 30)), headers: { 'content-type': type } });
      assert.equal(answer.status, 200, type);
      assert.deepEqual((await answer.json()).bounds, [0, 0, 30, 30], type);
    }
  });

  it('names the wrong field of the query', async () => {
    const wrong = {
      'thickness=3mm': /field thickness must be a number above 0 in mm/,
      'thickness=': /field thickness/,
      'thickness=-1': /field thickness/,
      'thickness=Infinity': /field thickness/,
      'thickness=1&thickness=2': /field thickness/,
      'density=heavy': /field density/,
      'machine=jelly': /field machine: there is no machine named jelly. Choose one of: co2-100w/,
      'machine[a]=1': /no field|no machine/,
      'name=a&name=b': /field name/,
      'thicknes=3': /no field "thicknes"/,
    };
    for (const [query, message] of Object.entries(wrong)) {
      const answer = await send(dxf(square(0, 0, 30)), `?${query}`);
      assert.equal(answer.status, 400, query);
      assert.match((await answer.json()).problem, message, query);
    }
  });

  it('answers 422 to a drawing without anything to cut', async () => {
    for (const drawing of [dxf(), dxf(line(5, 5, 5, 5))]) {
      const answer = await send(drawing);
      assert.equal(answer.status, 422);
      assert.match((await answer.json()).problem, /nothing to cut/);
    }
  });

  it('answers 500 to an internal error, without details', async (t) => {
    const { server: faulty, url: at } = await start(t, DYING);
    const answer = await fetch(at, { method: 'POST', body: dxf(square(0, 0, 30)) });
    assert.deepEqual([answer.status, await answer.json()], [500, { problem: 'The quote could not be made because of a fault of the server. Try again later.' }]);
    assert.equal(faulty.exitCode, null);
  });

  it('names the limit that is exceeded', async () => {
    const large = await send(new Uint8Array(21 * 2 ** 20));
    assert.deepEqual([large.status, await large.json()], [413, { problem: 'The drawing is larger than 20mb.' }]);
  });

  it('frees the places of clients that disconnect', async () => {
    const control = new AbortController();
    const leaving = Array.from({ length: 200 }, () => fetch(url, { method: 'POST', body: bytes(KEYBOARD), signal: control.signal }).catch((e) => e.name));
    while ((await health()).waiting === 0) await new Promise((resolve) => setImmediate(resolve));
    control.abort();
    const gone = (await Promise.all(leaving)).filter((name) => name === 'AbortError').length;
    assert.ok(gone > 0, 'all were answered before');
    assert.equal((await send(dxf(square(0, 0, 30)))).status, 200);
    assert.equal((await health()).waiting, 0);
  });

  it('ends when told to, and answers first what it has received', async () => {
    const sent = Array.from({ length: availableParallelism() + 1 }, () => send(bytes('sheets/sheet_2000.dxf')));
    // One waits, so the others have arrived.
    while ((await health()).waiting === 0) await new Promise((resolve) => setImmediate(resolve));
    const exited = once(server, 'exit');
    server.kill('SIGTERM');
    assert.deepEqual((await Promise.all(sent)).map((answer) => answer.status), sent.map(() => 200));
    const [code] = await exited;
    assert.equal(code, 0);
  });
});
