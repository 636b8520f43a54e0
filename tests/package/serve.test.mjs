// kerfway serve: uploads of all kinds, errors with codes, keys, CORS, backpressure, and its description.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { connect } from 'node:net';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { gzipSync } from 'node:zlib';
import { Validator } from '@seriousme/openapi-schema-validator';
import { quote } from 'kerfway';
import { keysIn } from '../../dist/sdk/server/keys.js';
import { serve as startService } from '../../dist/sdk/server/serve.js';
import { DEFAULTS } from '../../dist/sdk/server/settings.js';
import { answerUnreadable } from '../../dist/sdk/server/unreadable.js';
import { safeName } from '../../dist/sdk/server/body.js';
import { hostile } from './hostile.mjs';
import { form, serve } from './serving.mjs';
import { bytes, circle, dxf, folder, KEYBOARD, shared, square } from './support.mjs';

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = 'moves=1000&seed=1';

async function refused(response, status, code) {
  const { error } = await response.json();
  assert.deepEqual([response.status, error.code], [status, code], error.message);
  assert.deepEqual(Object.keys(error), ['code', 'message', 'params', 'retryable']);
  return error;
}

/** Everything that a service answers to these bytes, until it closes the connection. */
const answer = (url, text) => new Promise((resolve, reject) => {
  const { hostname, port } = new URL(url);
  let said = '';
  const socket = connect(Number(port), hostname, () => socket.write(text));
  socket.on('data', (data) => (said += data)).on('close', () => resolve(said)).on('error', reject);
});

/** The head of a request to quote. */
const post = (...headers) => `${['POST /quote HTTP/1.1', 'Host: x', ...headers].join('\r\n')}\r\n\r\n`;

describe('the service', () => {
  /** One with the usual settings. */
  const usual = shared(serve);

  it('takes a drawing alone or in a form, under any content type, and comes to the hash of the package', async () => {
    const { send } = usual;
    const { hash, confidence } = await quote(bytes(KEYBOARD), { moves: 1000, seed: 1, material: { thickness: 3, density: 7.85 } });
    const query = `/quote?name=keyboard.dxf&${SHORT}&material.thickness=3&material.density=7.85`;
    for (const type of ['image/vnd.dxf', 'application/octet-stream', 'application/x-www-form-urlencoded', 'text/plain']) {
      const report = await (await send(query, bytes(KEYBOARD), { headers: { 'content-type': type } })).json();
      assert.deepEqual([report.hash, report.input.name], [hash, 'keyboard.dxf'], type);
    }
    const options = { moves: 1000, seed: 1, material: { thickness: 3, density: 7.85 } };
    const inForm = await (await send('/quote', form(bytes(KEYBOARD), 'board.dxf', { options }))).json();
    // A reader that looked for the drawing inside the envelope would find damage around it.
    assert.deepEqual([inForm.hash, inForm.input.name, inForm.confidence], [hash, 'board.dxf', confidence]);
    const asJson = await (await send(`/quote?options=${encodeURIComponent(JSON.stringify(options))}`, bytes(KEYBOARD))).json();
    assert.equal(asJson.hash, hash);
  });

  it('plans, and describes drawings with pictures of their parts', async () => {
    const { send } = usual;
    const planned = await (await send(`/plan?${SHORT}&outputs=gcode,png`, PLATE)).json();
    assert.equal(planned.schema, 'kerfway.planned/1');
    assert.match(planned.outputs.gcode, /^G21 /m);
    assert.equal(Buffer.from(planned.outputs.png, 'base64').subarray(1, 4).toString(), 'PNG');
    const seen = await (await send('/inspect?thumbnails=64', PLATE)).json();
    assert.deepEqual([seen.schema, seen.totals.closed, Object.keys(seen.thumbnails)], ['kerfway.inspect/1', 2, ['0']]);
    assert.match(seen.thumbnails[0], /^<svg [^>]*width="64"/);
  });

  it('took a list of lists in the query for lists of one, which ask for nothing', async () => {
    const { send } = usual;
    const taken = async (query) => (await (await send(`/plan?${SHORT}&${query}`, bytes(KEYBOARD))).json()).options.together;
    assert.deepEqual(await taken('together=1,2'), [[1, 2]]);
    assert.deepEqual(await taken('together=1,2&together=3,4'), [[1, 2], [3, 4]]);
    assert.deepEqual(await taken(`options=${encodeURIComponent('{"together":[[1,2],[3,4]]}')}`), [[1, 2], [3, 4]]);
  });

  it('took a client that left for a fault of its own', async (t) => {
    const { send, metric, log } = await serve(t, '--workers', '1');
    await assert.rejects(send('/plan?seconds=20&seed=1', bytes(KEYBOARD), { signal: AbortSignal.timeout(1_000) }), { name: 'TimeoutError' });
    while (!log.some((l) => l.event === 'request')) await wait(20);
    assert.deepEqual(log.filter((l) => l.event === 'request').map((l) => [l.level, l.status, l.code]), [['info', 499, 'closed']]);
    assert.equal(await metric('kerfway_requests_total'), 1);
  });

  it('writes no program in a unit that is in doubt', async () => {
    const { send } = usual;
    // 10 x 10, and nothing but the header says millimetres: as likely inches.
    const small = dxf(square(0, 0, 10), circle(5, 5, 1));
    const error = await refused(await send(`/plan?${SHORT}&outputs=gcode`, small), 422, 'unwritable');
    assert.match(error.message, /inches.*in doubt/);
    assert.equal((await refused(await send(`/plan?${SHORT}&outputs=gcode&acceptGuess=yes`, small), 400, 'wrong-type')).params.field, 'acceptGuess');
    for (const sure of ['units=mm', 'acceptGuess=true']) {
      const planned = await (await send(`/plan?${SHORT}&outputs=gcode&${sure}`, small)).json();
      assert.match(planned.outputs.gcode, /^G21 /m, sure);
    }
    // A picture cuts nothing.
    const drawn = await (await send(`/plan?${SHORT}&outputs=svg`, small)).json();
    assert.match(drawn.outputs.svg, /^<svg /);
  });

  it('refuses with a status, a code and the name of the field', async (t) => {
    const { url, send } = await serve(t, '--largest', '0.1', '--most-seconds', '5');
    const field = async (query, status, code) => (await refused(await send(query, PLATE), status, code)).params.field;
    assert.equal(await field('/quote?secnds=1', 400, 'unknown-field'), 'secnds');
    assert.equal(await field('/quote?seconds=600', 400, 'out-of-range'), 'seconds');
    assert.equal(await field('/quote?seconds=soon', 400, 'wrong-type'), 'seconds');
    assert.equal(await field('/quote?workers=8', 400, 'unknown-field'), 'workers');
    assert.equal(await field('/quote?machine=co2-10w', 400, 'not-a-choice'), 'machine');
    assert.equal(await field('/quote?material.thickness=0', 400, 'out-of-range'), 'material.thickness');
    assert.equal(await field('/quote?options=[1]', 400, 'wrong-type'), 'options');
    assert.equal(await field('/quote?options={', 400, 'not-json'), 'options');
    assert.equal(await field('/quote?__proto__=1', 400, 'unknown-field'), '__proto__');
    assert.equal(await field('/inspect?thumbnails=x', 400, 'out-of-range'), 'thumbnails');
    // The rest of a path was dropped, and the option before it was set.
    assert.equal(await field('/plan?moves.foo=10', 400, 'unknown-field'), 'moves.foo');
    assert.equal(await field('/plan?machine=co2-100w&machine.kerf_width=0.2', 400, 'unknown-field'), 'machine.kerf_width');
    assert.equal(await field('/quote?moves=1000&moves=2000', 400, 'wrong-type'), 'moves');
    // The first was taken, and the second had no effect.
    for (const twice of ['name=a&name=b', 'options={}&options={"units":"in"}', 'acceptGuess=true&acceptGuess=false']) assert.equal(await field(`/plan?${twice}`, 400, 'wrong-type'), twice.split('=')[0]);
    await refused(await send('/quote', new Uint8Array(0)), 422, 'not-a-drawing');
    const large = await refused(await send('/quote', new Uint8Array(200_000)), 413, 'too-large');
    assert.equal(large.message, 'The body has more than 0.1 MB, which is the limit of this service.');
    await refused(await send('/quote', PLATE, { headers: { 'content-type': 'multipart/mixed; boundary=x' } }), 415, 'unsupported-media-type');
    // It was read as a damaged drawing.
    const packed = await refused(await send('/inspect', gzipSync(PLATE), { headers: { 'content-encoding': 'gzip' } }), 415, 'unsupported-media-type');
    assert.equal(packed.message, 'The body is encoded as "gzip". Send it as it is, without a content encoding.');
    assert.equal((await send('/inspect', PLATE, { headers: { 'content-encoding': 'identity' } })).status, 200);
    await refused(await send('/quote', `--x\r\nContent-Disposition: form-data; name="a"\r\n\r\n`), 415, 'unsupported-media-type');
    await refused(await fetch(`${url}/nothing`), 404, 'not-found');
    const wrong = await fetch(`${url}/quote`);
    assert.equal(wrong.headers.get('allow'), 'POST');
    await refused(wrong, 405, 'method-not-allowed');
  });

  it('asked for an AbortController, listed options that it refuses, and ignored some that do nothing', async () => {
    const { send } = usual;
    const told = async (query) => (await refused(await send(query, PLATE), 400, 'unknown-field')).message;
    for (const name of ['signal', 'onProgress']) assert.equal(await told(`/plan?${name}=x`), `plan has no option "${name}" in this service.`);
    assert.equal(await told('/plan?options={"signal":null}'), 'plan has no option "signal" in this service.');
    for (const [kind, last] of [['inspect', 'contours'], ['plan', 'outputs'], ['quote', 'limits']]) {
      const names = /There are: (.*)\.$/.exec(await told(`/${kind}?zzzzzzzzzzzz=1`))[1].split(', ');
      assert.deepEqual(['workers', 'warm', 'signal', 'onLoaded'].filter((name) => names.includes(name)), []);
      assert.ok(names.includes(last) && names.includes('name'), `${kind}: ${names}`);
    }
    for (const query of ['/plan?thumbnails=96', '/quote?thumbnails=96', '/quote?acceptGuess=true', '/inspect?acceptGuess=true']) assert.match(await told(query), /^\w+ has no option "(thumbnails|acceptGuess)"\. /);
  });

  it('let requests without a budget have the default one, which may be above its limits', async (t) => {
    const { url, send } = await serve(t, '--most-seconds', '0.2', '--most-moves', '1000');
    const limits = ({ properties: { seconds, moves } }) => [seconds.maximum, moves.maximum];
    const { schemas } = (await (await fetch(`${url}/openapi.json`)).json()).components;
    assert.deepEqual([limits(schemas.PlanOptions), limits(schemas.QuoteOptions)], [[0.2, 1000], [0.2, 1000]]);
    const planned = await (await send('/plan', bytes(KEYBOARD))).json();
    assert.deepEqual([planned.options.seconds, planned.reason], [0.2, 'budget']);
    const quoted = await (await send('/quote', bytes(KEYBOARD))).json();
    assert.deepEqual([quoted.moves, quoted.seed], [1000, 1]);
    // A request that states its budget gets that one, and a seed is none.
    assert.equal((await (await send('/quote?moves=500&seed=7', bytes(KEYBOARD))).json()).moves, 500);
    const seeded = await (await send('/quote?seed=7', bytes(KEYBOARD))).json();
    assert.deepEqual([seeded.moves, seeded.seed], [1000, 7]);
  });

  it('refuses forms without a file, with several, with too many parts, and broken ones', async () => {
    const { send } = usual;
    const two = form(PLATE, 'a.dxf');
    two.append('second', new Blob([PLATE]), 'b.dxf');
    const many = form(PLATE, 'a.dxf', Object.fromEntries(Array.from({ length: 40 }, (_, k) => [`f${k}`, 'x'])));
    const none = new FormData();
    none.set('options', '{}');
    const twice = form(PLATE, 'a.dxf', { options: { moves: 1000 } });
    twice.append('options', '{}');
    for (const body of [two, many, none, twice]) await refused(await send('/quote', body), 400, 'malformed-form');
    for (const type of ['multipart/form-data', 'multipart/form-data; boundary=other']) await refused(await send('/quote', PLATE, { headers: { 'content-type': type } }), 400, 'malformed-form');
  });

  it('ended when the reader of its log had gone', async (t) => {
    const { child, url, send } = await serve(t);
    child.stderr.destroy();
    for (let k = 0; k < 3; k += 1) {
      assert.equal((await fetch(`${url}/healthz`)).status, 200);
      await wait(100);
    }
    assert.equal((await send('/inspect', PLATE)).status, 200);
    assert.equal(child.exitCode, null);
  });

  it('counted the parts of a form by another boundary than its parser took', async () => {
    const { send } = usual;
    const real = '-'.repeat(28) + 'abcdef';
    const part = (head, content) => `--${real}\r\ncontent-disposition: form-data; ${head}\r\n\r\n${content}\r\n`;
    const drawing = part('name="f"; filename="a.dxf"', new TextDecoder().decode(PLATE));
    const sent = (fields, type) => send(`/quote?${SHORT}`, `${part('name="name"', 'b.dxf').repeat(fields)}${drawing}--${real}--\r\n`, { headers: { 'content-type': type } });
    const many = 'The form has more than 32 parts. Send one file, and its options in one field.';
    const other = 'The form cannot be read: its parts do not end as they should.';
    for (const [before, sentence] of [['', many], ['xboundary=zzz; ', many], ['x="; boundary=zzz"; ', many], ['x="; boundary=zzz; "; ', other]]) {
      const { message } = await refused(await sent(40, `multipart/form-data; ${before}boundary=${real}`), 400, 'malformed-form');
      assert.equal(message, sentence, before);
    }
    for (const type of [`boundary=${real}`, `boundary="${real}"; charset=utf-8`, `xboundary=zzz; BOUNDARY=${real}`]) {
      const report = await (await sent(1, `multipart/form-data; ${type}`)).json();
      assert.equal(report.input?.name, 'b.dxf', JSON.stringify(report));
    }
  });

  it('drew a picture of each of a hundred thousand parts, and answered nobody else meanwhile', async () => {
    const { send } = usual;
    const many = dxf(...Array.from({ length: 1200 }, (_, k) => circle(6 * (k % 40), 6 * Math.floor(k / 40), 2)));
    const { parts, thumbnails } = await (await send('/inspect?thumbnails=8', many)).json();
    assert.equal(parts.length, 1200);
    assert.deepEqual(Object.keys(thumbnails).sort(), parts.slice(0, 1000).map(({ outer }) => String(outer)).sort());
  });

  it('kept any number of answers for clients that did not read them', async (t) => {
    const log = [];
    const body = { data: 'x'.repeat(8e6) };
    const backend = { full: async () => false, take: async () => ({ status: 200, body }), find: async () => ({ status: 200, body }), waiting: () => 0, close: async () => {} };
    const service = await startService({ ...DEFAULTS, workers: 1, waiting: 1, port: 0, upload: 0.2, grace: 1 }, backend, '0', (_, event) => log.push(event));
    const { hostname, port } = new URL(service.url);
    const clients = [1, 2].map(() => connect(Number(port), hostname).on('error', () => {}));
    t.after(() => Promise.all([service.stop(), ...clients.map((client) => client.destroy())]));
    const asked = ['POST /inspect HTTP/1.1\r\nhost: a\r\ncontent-length: 1\r\n\r\nx', `GET /jobs/${'0'.repeat(64)} HTTP/1.1\r\nhost: a\r\n\r\n`];
    clients.forEach((client, k) => {
      client.pause();
      client.write(asked[k]);
    });
    const post = () => fetch(`${service.url}/inspect`, { method: 'POST', body: 'x' });
    for (let k = 0; k < 100 && (await (await fetch(`${service.url}/healthz`)).json()).running < 2; k += 1) await wait(20);
    await refused(await post(), 429, 'busy');
    // An answer of 8 MB may take 8.2 seconds.
    await wait(9_000);
    const after = await post();
    assert.deepEqual([after.status, (await after.json()).data.length, log.filter((event) => event === 'unread').length], [200, 8e6, 2]);
    assert.equal((await (await fetch(`${service.url}/healthz`)).json()).running, 0);
  });

  it('took addresses like // for a fault of its own', async () => {
    const { url, log } = usual;
    const { hostname, port } = new URL(url);
    const status = (address) => new Promise((resolve) => {
      const socket = connect(Number(port), hostname);
      socket.once('data', (data) => (socket.destroy(), resolve(Number(String(data).split(' ')[1]))));
      socket.write(`GET ${address} HTTP/1.1\r\nHost: x\r\n\r\n`);
    });
    for (const address of ['//', '///x', '/\\', 'http://[/', '*', '//x/healthz']) assert.equal(await status(address), 404, address);
    for (const address of ['/healthz', 'http://proxied.example/healthz']) assert.equal(await status(address), 200, address);
    assert.deepEqual(log.filter(({ event }) => event === 'fault'), []);
  });

  it('did not start with a time for uploads like 2.3 seconds', async (t) => {
    const { send } = await serve(t, '--upload-seconds', '2.3');
    assert.equal((await send('/inspect', PLATE)).status, 200);
  });

  it('needs a key when it has keys, but not for its health', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'keys'), '# shops\nshop-a 0123456789abcdef0123\nfedcba98765432100000\n');
    const { url, send, log, stop } = await serve(t, '--keys', join(at, 'keys'));
    await refused(await send(`/quote?${SHORT}`, PLATE), 401, 'unauthorized');
    await refused(await send(`/quote?${SHORT}`, PLATE, { headers: { authorization: 'Bearer wrong' } }), 401, 'unauthorized');
    await refused(await fetch(`${url}/metrics`), 401, 'unauthorized');
    for (const headers of [{ authorization: 'Bearer 0123456789abcdef0123' }, { 'x-api-key': 'fedcba98765432100000' }]) {
      assert.equal((await send(`/quote?${SHORT}`, PLATE, { headers })).status, 200);
    }
    assert.equal((await fetch(`${url}/healthz`)).status, 200);
    await stop();
    assert.doesNotMatch(JSON.stringify(log), /0123456789abcdef0123|fedcba98765432100000/);
    assert.throws(() => keysIn('short'), /16/);
    assert.throws(() => keysIn('# none\n'), /no key/);
  });

  it('read the names of keys, and told nobody whose a request was', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'keys'), '# shops\nshop-a 0123456789abcdef0123\nfedcba98765432100000\n');
    const { send, log, stop } = await serve(t, '--keys', join(at, 'keys'));
    for (const key of ['0123456789abcdef0123', 'fedcba98765432100000', 'wrong']) await send(`/quote?${SHORT}`, PLATE, { headers: { 'x-api-key': key } });
    await stop();
    assert.deepEqual(log.filter(({ event }) => event === 'request').map(({ status, key }) => [status, key]), [[200, 'shop-a'], [200, 'line 3'], [401, undefined]]);
    assert.throws(() => keysIn('a 0123456789abcdef0123\nb 0123456789abcdef0123\n'), { message: 'The key in line 2 is in a line before, too. Give each key once.' });
  });

  it('answers pages of the configured origins only', async (t) => {
    const { url, send } = await serve(t, '--cors', 'https://shop.example');
    const asked = await fetch(`${url}/quote`, { method: 'OPTIONS', headers: { origin: 'https://shop.example', 'access-control-request-method': 'POST' } });
    assert.deepEqual([asked.status, asked.headers.get('access-control-allow-origin')], [204, 'https://shop.example']);
    const other = await send(`/quote?${SHORT}`, PLATE, { headers: { origin: 'https://else.example' } });
    assert.equal(other.headers.get('access-control-allow-origin'), null);
  });

  it('answers 429 with Retry-After when it is full, and loses nothing that it has taken', async (t) => {
    const { url, send, metric } = await serve(t, '--workers', '1', '--waiting', '2');
    const answers = await Promise.all(Array.from({ length: 24 }, () => send('/quote?moves=200000&seed=1', bytes(KEYBOARD))));
    const full = answers.filter((a) => a.status === 429);
    const done = answers.filter((a) => a.status === 200);
    assert.equal(full.length + done.length, 24);
    assert.ok(full.length > 0 && done.length >= 3, `${full.length} refused`);
    const error = await refused(full[0], 429, 'busy');
    assert.deepEqual([full[0].headers.get('retry-after'), error.retryable], [String(error.params.retryAfter), true]);
    const hashes = new Set(await Promise.all(done.map(async (a) => (await a.json()).hash)));
    assert.equal(hashes.size, 1);
    assert.equal((await fetch(`${url}/healthz`)).status, 200);
    assert.equal(await metric('kerfway_errors_total'), full.length);
  });

  it('answered what is no request without a body, although each error has one', async (t) => {
    const { url, send } = await serve(t);
    for (const [text, status, code] of [
      ['GARBAGE\r\n\r\n', 400, 'malformed-form'],
      [post('Content-Length: abc'), 400, 'malformed-form'],
      [post('Content-Length: 3', 'Transfer-Encoding: chunked'), 400, 'malformed-form'],
      [`${post('Transfer-Encoding: chunked')}zz\r\n`, 400, 'malformed-form'],
      [post(`X-Long: ${'x'.repeat(100_000)}`), 413, 'too-large'],
      ['POST /quote HTTP/1.1\r\nConnection: close\r\nContent-Length: 2\r\n\r\nxx', 422, 'not-a-drawing'],
    ]) {
      const [head, body] = (await answer(url, text)).split('\r\n\r\n');
      assert.match(head, new RegExp(`^HTTP/1\\.1 ${status} `), text.slice(0, 60));
      const { error } = JSON.parse(body);
      assert.deepEqual([error.code, error.retryable, error.params], [code, false, {}], text.slice(0, 60));
    }
    assert.equal((await send(`/quote?${SHORT}`, PLATE)).status, 200);
  });

  it('did not count what is no request, and counted half of one as a client that left', async (t) => {
    const { url, log } = await serve(t);
    for (const text of ['GARBAGE\r\n\r\n', `${post('Transfer-Encoding: chunked')}zz\r\n`]) await answer(url, text);
    const figures = await (await fetch(`${url}/metrics`)).text();
    const counted = figures.split('\n').filter((text) => /^kerfway_(requests|errors)_total\{/.test(text));
    assert.deepEqual(counted, ['kerfway_requests_total{route="unreadable",status="400"} 2', 'kerfway_errors_total{code="malformed-form"} 2']);
    assert.deepEqual(log.map(({ event, status }) => [event, status]).filter(([, status]) => status >= 400), [['unreadable', 400], ['unreadable', 400]]);
  });

  it('answered a connection on which nothing was sent, and counted it', async (t) => {
    const counted = [];
    const server = createServer({ headersTimeout: 100, connectionsCheckingInterval: 50 });
    answerUnreadable(server, (status) => counted.push(status));
    await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
    t.after(() => server.close());
    const url = `http://127.0.0.1:${server.address().port}`;
    assert.deepEqual([await answer(url, ''), counted], ['', []]);
    assert.match(await answer(url, 'GET / HTTP/1.1\r\n'), /^HTTP\/1\.1 408 /);
    assert.deepEqual(counted, [408]);
  });

  it('answered an expectation with a bare 417, and a request for a tunnel with nothing', async (t) => {
    const { url } = await serve(t);
    for (const [text, status, code] of [
      [`${post('Expect: something-else', 'Connection: close', 'Content-Length: 2')}xx`, 422, 'not-a-drawing'],
      ['GET /nothing HTTP/1.1\r\nExpect: something-else\r\nConnection: close\r\n\r\n', 404, 'not-found'],
      ['CONNECT shop.example:443 HTTP/1.1\r\nHost: x\r\n\r\n', 405, 'method-not-allowed'],
    ]) {
      const [head, body] = (await answer(url, text)).split('\r\n\r\n');
      assert.match(head, new RegExp(`^HTTP/1\\.1 ${status} `), text);
      assert.equal(JSON.parse(body).error.code, code, text);
    }
    assert.match(await (await fetch(`${url}/metrics`)).text(), /requests_total\{route="quote",status="422"\} 1\n/);
  });

  it('ends a slow upload and a drawing that takes too long', async (t) => {
    const { url, send } = await serve(t, '--upload-seconds', '0.5', '--deadline', '3');
    const { hostname, port } = new URL(url);
    const socket = connect(Number(port), hostname);
    socket.write('POST /quote HTTP/1.1\r\nHost: x\r\nContent-Length: 1000\r\n\r\n0\n');
    const said = await new Promise((resolve) => socket.once('data', (data) => resolve(String(data))));
    assert.match(said, /^HTTP\/1\.1 408 [\s\S]*"slow-upload"/);
    socket.destroy();
    await refused(await send('/plan?moves=100000000&seed=1', bytes(KEYBOARD)), 504, 'deadline');
    assert.equal((await send(`/quote?${SHORT}`, PLATE)).status, 200);
  });

  it('stays well under uploads of which a third are hostile', async (t) => {
    const { url, send, metric } = await serve(t, '--largest', '1', '--upload-seconds', '1');
    const said = await hostile({ url, send, metric, uploads: 90, atOnce: 8 });
    assert.deepEqual(said.wrong, []);
  });

  it('describes itself in valid OpenAPI', async () => {
    const { url } = usual;
    const described = await (await fetch(`${url}/openapi.json`)).json();
    const { seconds, moves } = described.components.schemas.QuoteOptions.properties;
    assert.deepEqual([seconds.maximum, moves.maximum], [60, 500_000_000]);
    const { valid, errors } = await new Validator().validate(structuredClone(described));
    assert.equal(valid, true, JSON.stringify(errors));
    // tests/package/matrix/service.test.mjs generates a client from it.
  });
});

describe('names of files', () => {
  it('lose their folders and control characters', () => {
    for (const [given, name] of [['../../etc/passwd', 'passwd'], ['C:\\x\\plate.dxf', 'plate.dxf'], ['a\u0000b\u001b[2J.dxf', 'ab[2J.dxf'], ['..', 'drawing.dxf'], ['', 'drawing.dxf'], [null, 'drawing.dxf'], ['x'.repeat(400), 'x'.repeat(255)]]) {
      assert.equal(safeName(given), name);
    }
  });
});
