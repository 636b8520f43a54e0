// The frame page in a host of another origin: what the bridge carries, and what it does not hear.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { quote as quoted } from 'kerfway';
import { serve } from '../../scripts/serve.mjs';
import { DIST } from '../../scripts/tools.mjs';
import { bytes, circle, dxf, KEYBOARD, square } from '../package/support.mjs';
import { base64, embedding, openHost } from './embed-support.mjs';

const at = embedding();
const PLATE = base64(dxf(square(0, 0, 100), circle(50, 50, 10)));
const [LONG_FILE, LONG] = [base64(bytes(KEYBOARD)), { seconds: 60, seed: 1, allowOffBed: true }];

/** The frame page is served from an origin of its own. */
let frames;
before(async () => (frames = await serve(join(DIST, 'sdk'))));
after(() => frames.close());

const origin = (url) => new URL(url).origin;
/** What a host may do that frames other origins. */
const policy = () => `default-src 'none'; script-src 'self'; frame-src ${origin(frames.url)}`;

/** A host's page with the frame in it; `speaksFor`: the origin the frame is told is its host's. */
async function hosted(t, { speaksFor = origin(at.server.url), script, show = '' } = {}) {
  const src = `${frames.url}frame/frame.html${speaksFor === null ? '' : `?host=${encodeURIComponent(speaksFor)}`}${show}`;
  const connect = `
    import { connectFrame } from './frame/host.js';
    window.heard = [];
    const note = (type) => (detail) => window.heard.push([type, detail]);
    window.raw = 0;
    window.addEventListener('message', () => (window.raw += 1));
    window.frame = connectFrame(document.querySelector('iframe'), {
      onReady: note('ready'), onProgress: note('progress'), onResult: note('result'), onError: (message, error) => note('error')({ ...error.toJSON(), message }), onQuote: note('quote'),
      price: async ({ times, weight }) => (times.total + weight).toFixed(3) + ' EUR' });
    window.bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;`;
  const host = await openHost(t, at, { html: `<iframe src="${src}" width="800" height="500"></iframe>`, script: script ?? connect, policy: policy() });
  // The page has loaded, and with it the frame.
  const inside = host.page.frames().find((f) => f.url().startsWith(frames.url));
  return { ...host, inside };
}

const state = (inside) => inside.evaluate(() => document.querySelector('kerfway-planner').state);
const planner = (inside) => inside.waitForFunction(() => document.querySelector('kerfway-planner')?.state !== undefined);

describe('the frame page', () => {
  it('plans what its host hands it, tells the way, and renders', async (t) => {
    const { page, requests } = await hosted(t);
    const { result, svg, png, heard, refused } = await page.evaluate(async (plate) => {
      window.frame.setOptions({ units: 'in', moves: 50, seed: 2, allowOffBed: true });
      const result = await window.frame.open(window.bytes(plate), 'plate.dxf');
      const svg = await window.frame.render('svg');
      const png = [...(await window.frame.render('png', { width: 64 })).subarray(0, 4)];
      const refused = await window.frame.open(new ArrayBuffer(0), 'empty.dxf').catch((error) => error.message);
      return { result, svg, png, refused, heard: window.heard.map(([type]) => type) };
    }, PLATE);
    assert.deepEqual([result.loaded.name, result.loaded.bounds[2], result.seed], ['plate.dxf', 2540, 2]);
    assert.match(result.outputs.gcode, /^; Kerfway/);
    assert.match(svg, /<svg /);
    assert.deepEqual(png, [0x89, 0x50, 0x4e, 0x47]);
    assert.match(refused, /empty/);
    assert.deepEqual([...new Set(heard)], ['ready', 'progress', 'result', 'error']);
    assert.ok(requests.every((r) => [at.server.url, frames.url].some((url) => r.startsWith(url))), requests.join(' '));
  });

  it('quotes with show=quote, and shows the price that its host tells', async (t) => {
    const { page, inside } = await hosted(t, { show: '&show=quote' });
    const { quote, heard, refused, wrong } = await page.evaluate(async (plate) => {
      window.frame.setOptions({ units: 'mm', allowOffBed: true });
      window.frame.setMaterial({ name: 'Acrylic', thickness: 3, density: 1.19 });
      const quote = await window.frame.quote(window.bytes(plate), 'plate.dxf');
      const refused = await window.frame.render('gcode').catch((error) => error.toJSON());
      const wrong = await window.frame.quote(new ArrayBuffer(0), 'empty.dxf').catch((error) => error.toJSON());
      return { quote, refused, wrong, heard: window.heard };
    }, PLATE);
    const own = await quoted(Buffer.from(PLATE, 'base64'), { name: 'plate.dxf', units: 'mm', material: { name: 'Acrylic', thickness: 3, density: 1.19 } });
    assert.equal(quote.hash, own.hash);
    assert.deepEqual(heard.filter(([type]) => type === 'quote').map(([, { hash }]) => hash), [own.hash]);
    assert.equal(refused.code, 'not-in-this-build');
    assert.equal(wrong.code, 'not-a-drawing');
    assert.equal(heard.at(-1)[1].code, 'not-a-drawing');
    assert.equal(await inside.locator('[part=price]').textContent(), '');
    await page.evaluate((plate) => window.frame.quote(window.bytes(plate), 'plate.dxf'), PLATE);
    assert.equal(await inside.locator('[part=price]').textContent(), `${(own.times.total + own.weight).toFixed(3)} EUR`);
  });

  it('tells of a file that a person chooses in it, planned with the host\'s options', async (t) => {
    const { page, inside } = await hosted(t);
    await page.evaluate(() => window.frame.setOptions({ units: 'mm', moves: 50, seed: 9 }));
    await page.waitForFunction(() => window.heard.length > 0);
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), inside.getByRole('button', { name: 'Choose a file' }).click()]);
    await chooser.setFiles({ name: 'own.dxf', mimeType: 'image/vnd.dxf', buffer: Buffer.from(PLATE, 'base64') });
    await page.waitForFunction(() => window.heard.at(-1)?.[0] === 'result');
    const { loaded, seed } = await page.evaluate(() => window.heard.at(-1)[1]);
    assert.deepEqual([loaded.name, seed], ['own.dxf', 9]);
  });

  it('stops when its host says so', async (t) => {
    const { page } = await hosted(t);
    await page.evaluate(({ file, options }) => {
      window.frame.setOptions(options);
      window.result = window.frame.open(window.bytes(file), 'long.dxf');
    }, { file: LONG_FILE, options: LONG });
    await page.waitForFunction(() => window.heard.some(([type]) => type === 'progress'));
    const reason = await page.evaluate(async () => {
      window.frame.stop();
      return (await window.result).reason;
    });
    assert.ok(['stopped', 'exhausted'].includes(reason));
  });
});

/** Every message that a host can send, sent without the helper. */
const HOSTILE = `
  window.raw = [];
  window.addEventListener('message', ({ data }) => window.raw.push(data));
  const bytes = new TextEncoder().encode('0\\nSECTION\\n2\\nENTITIES\\n0\\nCIRCLE\\n10\\n5\\n20\\n5\\n40\\n4\\n0\\nENDSEC\\n0\\nEOF\\n').buffer;
  window.attack = (mark, bad) => {
    const { contentWindow } = document.querySelector('iframe');
    const good = [
      { type: 'hello' }, { type: 'options', options: { seconds: 1, units: 'in' } }, { type: 'open', id: 1, bytes, name: 'evil.dxf' },
      { type: 'stop' }, { type: 'render', id: 2, kind: 'svg', width: null },
    ];
    const messages = bad ?? good;
    for (const message of messages) contentWindow.postMessage(mark ? { kerfway: 1, ...message } : message, '*');
    return messages.length;
  };`;

/** Counts the messages that the frame receives from now on. */
const countMessages = (inside) => inside.evaluate(() => {
  window.received = 0;
  window.addEventListener('message', () => (window.received += 1));
});

/** Waits until the frame has handled that many messages. */
const handled = (inside, count) => inside.waitForFunction((n) => window.received >= n, count);

/** What the frame has sent to its host so far: everything before a message that is sent now. */
async function answers(page, inside) {
  await inside.evaluate(() => window.parent.postMessage('end', '*'));
  await page.waitForFunction(() => window.raw.at(-1) === 'end');
  return page.evaluate(() => window.raw.slice(0, -1).map(({ type }) => type));
}

describe('a hostile host', () => {
  it('of another origin than the stated one changes nothing and hears nothing', async (t) => {
    for (const speaksFor of ['https://shop.example', null]) {
      const { page, inside } = await hosted(t, { speaksFor, script: HOSTILE });
      await planner(inside);
      const options = await inside.evaluate(() => JSON.stringify(document.querySelector('kerfway-planner').options));
      await countMessages(inside);
      await handled(inside, await page.evaluate(() => window.attack(true)));
      assert.equal(await state(inside), 'empty', `${speaksFor}`);
      assert.equal(await inside.evaluate(() => JSON.stringify(document.querySelector('kerfway-planner').options)), options);
      assert.deepEqual(await answers(page, inside), [], `${speaksFor}`);
      await page.context().close();
    }
  });

  it('of the stated origin changes nothing by messages that are none', async (t) => {
    const { page, inside } = await hosted(t, { script: HOSTILE });
    await page.waitForFunction(() => window.raw.length > 0);
    await countMessages(inside);
    const sent = await page.evaluate(() => {
      const bytes = new ArrayBuffer(8);
      const marked = window.attack(true, [
        { type: 'open', bytes, name: 'a.dxf' }, { type: 'open', id: 1, bytes: 'text', name: 'a.dxf' }, { type: 'open', id: 1, bytes, name: { toString: 1 } },
        { type: 'open', id: 1, bytes, name: '' }, { type: 'open', id: 1, bytes, name: 'x'.repeat(256) }, { type: 'options', options: [] },
        { type: 'options', options: null }, { type: 'options', options: { onLoaded: 1, signal: 'x', outputs: ['png'], name: 'x' } },
        { type: 'render', id: 1, kind: 'json', width: null }, { type: 'render', id: 1, kind: 'svg', width: -1 },
        { type: 'constructor' }, { type: '__proto__' }, {}, { kerfway: 2, type: 'stop' },
      ]);
      return marked + window.attack(false, [null, 1, 'text', [], { type: 'open', id: 1, bytes, name: 'a.dxf' }]);
    });
    await handled(inside, sent);
    assert.equal(await state(inside), 'empty');
    assert.deepEqual(await inside.evaluate(() => document.querySelector('kerfway-planner').options), {});
    // Options that cannot be used are answered with a sentence.
    assert.deepEqual(await answers(page, inside), ['ready', 'error']);
  });

  it('beside the frame, of the stated origin but not its parent, is not heard', async (t) => {
    const { page, inside } = await hosted(t);
    await page.waitForFunction(() => window.heard.length > 0);
    await countMessages(inside);
    const [other] = await Promise.all([page.waitForEvent('popup'), page.evaluate(() => void window.open('index.js'))]);
    await other.evaluate((plate) => {
      const bytes = Uint8Array.from(atob(plate), (c) => c.charCodeAt(0)).buffer;
      window.opener.frames[0].postMessage({ kerfway: 1, type: 'open', id: 1, bytes, name: 'a.dxf' }, '*');
    }, PLATE);
    await handled(inside, 1);
    assert.equal(await state(inside), 'empty');
  });
});

it('the host hears only its frame', async (t) => {
  const { page } = await hosted(t);
  await page.waitForFunction(() => window.heard.length > 0);
  const before = await page.evaluate(() => window.heard.length);
  await page.evaluate(async () => {
    const received = new Promise((resolve) => window.addEventListener('message', resolve, { once: true }));
    window.postMessage({ kerfway: 1, type: 'result', result: { forged: true } }, '*');
    await received;
  });
  assert.equal(await page.evaluate(() => window.heard.length), before);
});
