// A load of uploads on a service, of which a third are hostile. Each upload has the answer that it must get.

import { connect } from 'node:net';
import { circle, dxf, square } from './support.mjs';
import { form } from './serving.mjs';

const BOUNDARY = 'kerfway-test';

/** The kinds of hostile uploads, with the answers they may get. */
const HOSTILE = [
  ['multipart bomb', [400], ({ send }) => send('/quote', `--${BOUNDARY}\r\ncontent-disposition: form-data; name="a"\r\n\r\nx\r\n`.repeat(9_000), { headers: { 'content-type': `multipart/form-data; boundary=${BOUNDARY}` } })],
  ['slow body', [408], ({ url }) => raw(url, 'POST /quote HTTP/1.1\r\nHost: x\r\nContent-Length: 5000\r\n\r\n0\nSECTION\n')],
  ['picture', [422], ({ send }) => send('/quote', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a))],
  ['oversize', [413], ({ url }) => raw(url, 'POST /quote HTTP/1.1\r\nHost: x\r\nContent-Length: 900000000\r\n\r\n0\nSECTION\n')],
  ['path name', [200], ({ send }) => send('/quote?moves=200&seed=1&name=..%2F..%2Fetc%2Fpasswd%00', dxf(square(0, 0, 30)))],
  ['form with a path name', [200], ({ send }) => send('/quote?moves=200&seed=1', form(dxf(square(0, 0, 30)), '../../../x.dxf'))],
  ['no boundary', [400], ({ send }) => send('/quote', 'x', { headers: { 'content-type': 'multipart/form-data' } })],
  ['option that is none', [400], ({ send }) => send('/quote?options=%7B%22__proto__%22%3A1%7D', dxf(square(0, 0, 30)))],
  ['broken off', [null], ({ url }) => broken(url)],
  ['garbage', [422], ({ send }) => send('/quote', Uint8Array.from({ length: 5_000 }, (_, k) => (k * 7919) % 251))],
];

/**
 * Sends uploads, so many at once. Resolves to the milliseconds of good uploads, the answers that were not what they must be, and
 * the memory of the service at the middle and at the end.
 */
export async function hostile({ url, send, metric, uploads, atOnce }) {
  const service = { url, send };
  const [wrong, times] = [[], []];
  const memory = [];
  let next = 0;
  const one = async (k) => {
    const bad = k % 3 === 2 ? HOSTILE[((k - 2) / 3) % HOSTILE.length] : null;
    const [kind, allowed, upload] = bad ?? ['good', [200], () => send(`/quote?moves=2000&seed=1&name=${k}.dxf`, dxf(square(0, 0, 20 + (k % 50)), circle(10, 10, 4)))];
    const begun = performance.now();
    const answer = await upload(service).catch((error) => ({ status: `no answer: ${error.message}` }));
    const body = typeof answer?.json === 'function' ? await answer.json() : null;
    if (bad === null) times.push(performance.now() - begun);
    const status = answer?.status ?? null;
    if (!allowed.includes(status)) wrong.push([k, kind, status, body]);
    else if (status === 200 && !/^[0-9a-f]{64}$/.test(body.hash)) wrong.push([k, kind, 'no hash']);
    else if (status === 200 && /[\\/\u0000]/.test(body.input.name)) wrong.push([k, kind, body.input.name]);
    else if (bad === null && body.input.name !== `${k}.dxf`) wrong.push([k, kind, 'the answer of another upload']);
  };
  const lane = async () => {
    while (next < uploads) {
      const k = next++;
      if (k === Math.floor(uploads / 2)) memory.push(await metric('process_resident_memory_bytes'));
      await one(k);
    }
  };
  await Promise.all(Array.from({ length: atOnce }, lane));
  memory.push(await metric('process_resident_memory_bytes'));
  return { wrong, times: times.sort((a, b) => a - b), memory };
}

/** Sends bytes and resolves to the status of the answer. */
function raw(url, text) {
  const { hostname, port } = new URL(url);
  return new Promise((resolve, reject) => {
    const socket = connect(Number(port), hostname, () => socket.write(text));
    socket.once('data', (data) => {
      resolve({ status: Number(/^HTTP\/1\.1 (\d+)/.exec(String(data))?.[1]) });
      socket.destroy();
    });
    socket.once('error', reject);
    socket.setTimeout(20_000, () => reject(new Error('nothing came')));
  });
}

/** Sends half of a body and leaves. */
function broken(url) {
  const { hostname, port } = new URL(url);
  return new Promise((resolve, reject) => {
    const socket = connect(Number(port), hostname, () => {
      socket.write('POST /quote HTTP/1.1\r\nHost: x\r\nContent-Length: 5000\r\n\r\n0\nSECTION\n', () => {
        socket.destroy();
        resolve(null);
      });
    });
    socket.once('error', reject);
  });
}
