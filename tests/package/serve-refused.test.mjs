// kerfway serve: what clients see of a refusal while they are still sending.

import assert from 'node:assert/strict';
import { once } from 'node:events';
import { writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { serve } from './serving.mjs';
import { bytes, folder, KEYBOARD } from './support.mjs';

const KEY = '0123456789abcdef0123';

/** Sends a request with a body of some MB as many clients do: the answer is read when all has been sent. */
async function sentWhole(url, { path, headers = [], megabytes }) {
  const { hostname, port } = new URL(url);
  const socket = connect(Number(port), hostname);
  const closed = new Promise((resolve) => socket.on('close', resolve));
  let failure = null;
  socket.on('error', (error) => (failure = error.code));
  socket.write([`POST ${path} HTTP/1.1`, 'Host: x', `Content-Length: ${megabytes * 1e6}`, ...headers, '', ''].join('\r\n'));
  const piece = Buffer.alloc(1e5);
  for (let k = 0; k < megabytes * 10 && failure === null; k++) {
    if (!socket.write(piece)) await Promise.race([once(socket, 'drain'), closed]);
  }
  let said = '';
  socket.on('data', (data) => (said += data));
  await closed;
  return failure ?? /^HTTP\/1\.1 (\d+)/.exec(said)?.[1] ?? said;
}

describe('a refusal', () => {
  it('closed the connection while the body was being sent, so that many clients saw a broken pipe instead of it', async (t) => {
    const keys = join(folder(t), 'keys');
    writeFileSync(keys, `${KEY}\n`);
    const { url, send, metric } = await serve(t, '--largest', '1', '--workers', '1', '--waiting', '0', '--keys', keys);
    const key = { 'x-api-key': KEY };
    const withKey = { path: '/inspect', headers: [`x-api-key: ${KEY}`], megabytes: 20 };
    assert.equal(await sentWhole(url, withKey), '413');
    assert.equal(await sentWhole(url, { path: '/inspect', megabytes: 20 }), '401');
    assert.equal(await sentWhole(url, { path: '/nothing', megabytes: 20 }), '404');
    const busy = send('/plan?seconds=3', bytes(KEYBOARD), { headers: key });
    while ((await metric('kerfway_running', key)) === 0);
    assert.equal(await sentWhole(url, withKey), '429');
    assert.equal((await busy).status, 200);
  });

  it('frees its place although the rest of the body still arrives', async (t) => {
    const { url, send } = await serve(t, '--largest', '1', '--workers', '1', '--waiting', '0');
    const { hostname, port } = new URL(url);
    const socket = connect(Number(port), hostname);
    t.after(() => socket.destroy());
    socket.write('POST /inspect HTTP/1.1\r\nHost: x\r\nContent-Length: 5000000\r\n\r\n');
    await once(socket, 'data');
    socket.write('0');
    assert.equal((await send('/inspect', bytes(KEYBOARD))).status, 200);
  });
});
