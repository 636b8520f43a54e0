// examples/express: many uploads at once, broken ones among them, people who hang up, and an orderly end.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { quote } from 'kerfway';
import { bytes, circle, dxf, KEYBOARD, ROOT, square } from './support.mjs';

let server, url;
/** In the server's process: knows the workers, and has them die when told. */
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
before(async () => {
  server = spawn(process.execPath, ['--import', PRELOAD, join(ROOT, 'examples', 'express', 'server.mjs')], { env: { ...process.env, PORT: '0' }, stdio: ['ignore', 'pipe', 'inherit'] });
  const [told] = await once(server.stdout, 'data');
  url = /http:\S+\/quotes/.exec(String(told))[0];
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
  it('answers two hundred uploads at once, each with its own, without growing', async () => {
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

  it('answers every upload, though its workers die in the middle', async () => {
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

  it('says what the package says', async () => {
    const told = await (await send(bytes(KEYBOARD), '?machine=diode-hobby&thickness=3&density=0.7')).json();
    const material = { thickness: 3, density: 0.7 };
    assert.deepEqual(told, await quote(bytes(KEYBOARD), { machine: 'diode-hobby', material, moves: 10_000, seed: 1 }));
    assert.ok(told.weight > 0);
  });

  it('names the machine it does not know, and the limit that is passed', async () => {
    assert.match((await (await send(bytes(KEYBOARD), '?machine=jelly')).json()).problem, /no machine named jelly/);
    const large = await send(new Uint8Array(21 * 2 ** 20));
    assert.deepEqual([large.status, await large.json()], [413, { problem: 'The drawing is larger than 20mb.' }]);
  });

  it('gives the places of those who hang up to the others', async () => {
    const control = new AbortController();
    const leaving = Array.from({ length: 200 }, () => fetch(url, { method: 'POST', body: bytes(KEYBOARD), signal: control.signal }).catch((e) => e.name));
    while ((await health()).waiting === 0) await new Promise((resolve) => setImmediate(resolve));
    control.abort();
    const gone = (await Promise.all(leaving)).filter((name) => name === 'AbortError').length;
    assert.ok(gone > 0, 'all were answered before');
    assert.equal((await send(dxf(square(0, 0, 30)))).status, 200);
    assert.equal((await health()).waiting, 0);
  });

  it('ends when told to', async () => {
    server.kill('SIGTERM');
    const [code] = await once(server, 'exit');
    assert.equal(code, 0);
  });
});
