// <kerfway-planner> in a host's page, under a strict Content-Security-Policy.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { bytes, circle, dxf, KEYBOARD, square } from '../package/support.mjs';
import { base64, embedding, openHost } from './embed-support.mjs';
import { beamRuns } from './page-drawings.mjs';

const at = embedding();
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));

/** The host notes every event, and shows the machine's light. */
const SCRIPT = `
  import './element/index.js';
  const planner = document.querySelector('kerfway-planner');
  window.events = [];
  for (const type of ['ready', 'progress', 'result', 'error']) {
    planner.addEventListener(type, ({ detail }) => window.events.push([type, type === 'progress' ? detail.summary.total_time : detail]));
  }`;

const open = (t, attributes = 'seed="3" moves="20000" units="mm" allow-off-bed', more = {}) =>
  openHost(t, at, { html: `<kerfway-planner ${attributes}></kerfway-planner>`, script: SCRIPT, ...more });

const state = (page, wanted) => page.waitForFunction((s) => document.querySelector('kerfway-planner').state === s, wanted);
const events = (page) => page.evaluate(() => window.events.map(([type]) => type));
const choose = async (page, name, bytes) => {
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: /Choose a file|Another file/ }).click()]);
  await chooser.setFiles({ name, mimeType: 'image/vnd.dxf', buffer: Buffer.from(bytes) });
};

describe('<kerfway-planner>', () => {
  it('plans the file that is chosen, tells its host, and hands out the program', async (t) => {
    const { page } = await open(t);
    await page.waitForFunction(() => window.events.length === 1);
    assert.deepEqual(await page.evaluate(() => [window.events[0][0], window.events[0][1].machines[0].name]), ['ready', 'co2-100w']);
    await choose(page, 'keyboard.dxf', bytes(KEYBOARD));
    await state(page, 'done');
    const told = await page.evaluate(() => window.events);
    const times = told.filter(([type]) => type === 'progress').map(([, time]) => time);
    assert.ok(times.length > 0);
    const [type, result] = told.at(-1);
    assert.equal(type, 'result');
    assert.equal(result.loaded.name, 'keyboard.dxf');
    assert.deepEqual([result.seed, result.options.units, result.options.moves], [3, 'mm', 20_000]);
    assert.match(await page.locator('[part=numbers]').textContent(), /^Job [\d.]+( min \d\d)? s, \d+ contours, [\d.]+ s less than as drawn$/);
    const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download G-code' }).click()]);
    assert.equal(file.suggestedFilename(), 'keyboard.nc');
    const program = readFileSync(await file.path(), 'utf8');
    assert.equal(program, result.outputs.gcode);
    const length = beamRuns(program).reduce((sum, run) => sum + run.length, 0);
    assert.ok(Math.abs(length / result.summary.cut_length - 1) < 1e-3, `${length} mm against ${result.summary.cut_length}`);
  });

  it('lost the focus with each button that was pressed by keyboard', async (t) => {
    const { page } = await open(t, 'seconds="60" units="mm" allow-off-bed');
    await page.waitForFunction(() => window.events.length === 1);
    const focused = () => page.evaluate(() => document.querySelector('kerfway-planner').shadowRoot.activeElement?.textContent);
    await page.keyboard.press('Tab');
    assert.equal(await focused(), 'Choose a file');
    // A key is quicker than the browser is told that files are chosen by a test; what is asked after that is answered after that.
    const chosen = page.waitForEvent('filechooser');
    await focused();
    await page.keyboard.press('Enter');
    const chooser = await chosen;
    await chooser.setFiles({ name: 'keyboard.dxf', mimeType: 'image/vnd.dxf', buffer: Buffer.from(bytes(KEYBOARD)) });
    await state(page, 'planning');
    assert.equal(await focused(), 'Stop');
    await page.keyboard.press('Enter');
    await state(page, 'done');
    assert.equal(await focused(), 'Download G-code');
  });

  it('plans with options that its framework has set to nothing, and says that nothing is no drawing', async (t) => {
    const { page } = await open(t, 'moves="100" units="mm" seed="1"');
    const told = await page.evaluate(async (text) => {
      const element = document.querySelector('kerfway-planner');
      const drawing = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const contours = [];
      for (const options of [null, undefined]) {
        element.options = options;
        contours.push((await element.open(drawing, 'plate.dxf')).summary.contours);
      }
      const refused = [];
      for (const nothing of [null, undefined]) refused.push(await element.open(nothing).catch((error) => error.code));
      return { contours, refused, state: element.state };
    }, base64(PLATE));
    assert.deepEqual(told, { contours: [2, 2], refused: ['not-bytes', 'not-bytes'], state: 'failed' });
  });

  it('takes a file that is dropped on it, and draws contours and way in its host\'s colours', async (t) => {
    const { page } = await open(t, 'moves="100" units="mm"');
    await page.evaluate((text) => {
      const element = document.querySelector('kerfway-planner');
      element.style.setProperty('--kerfway-contour', 'rgb(10, 120, 30)');
      element.style.setProperty('--kerfway-accent', 'rgb(200, 20, 60)');
      const data = new DataTransfer();
      data.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], 'plate.dxf'));
      element.dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
    }, base64(PLATE));
    await state(page, 'done');
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const seen = await page.evaluate(() => {
      const root = document.querySelector('kerfway-planner').shadowRoot;
      const colours = (part) => {
        const canvas = root.querySelector(`[part=${part}]`);
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        const solid = new Map();
        for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255) solid.set(`${data[i]},${data[i + 1]},${data[i + 2]}`, (solid.get(`${data[i]},${data[i + 1]},${data[i + 2]}`) ?? 0) + 1);
        return [...solid];
      };
      return [colours('contours'), colours('path')];
    });
    for (const [drawn, colour] of [[seen[0], '10,120,30'], [seen[1], '200,20,60']]) {
      assert.ok(drawn.find(([c, n]) => c === colour && n > 20), `${colour}: ${JSON.stringify(drawn)}`);
    }
  });

  it('drew the first and the last travel move to where the head would be if the job lay as drawn, although the job was placed', async (t) => {
    const { page } = await open(t, 'moves="100" units="mm"');
    // The head starts at the corner of the bed, which is that of the plate; so no move is left or below of it.
    const marks = await page.evaluate(async (text) => {
      const element = document.querySelector('kerfway-planner');
      const beside = [];
      for (const options of [{}, { place: { point: 'lower-left', at: [0, 0] } }, { place: { from: [500, 500], at: [500, 500] } }, { start: 'current', place: { at: [0, 0] } }]) {
        element.options = { ...options, allowOffBed: true };
        await element.open(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), 'plate.dxf');
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        const canvas = element.shadowRoot.querySelector('[part=path]');
        // Twelve pixels around the drawing are free.
        const { data } = canvas.getContext('2d').getImageData(0, canvas.height - 8 * devicePixelRatio, canvas.width, 8 * devicePixelRatio);
        beside.push(data.some((value, i) => i % 4 === 3 && value > 0));
      }
      return beside;
    }, base64(dxf(square(500, 500, 100), circle(550, 550, 10))));
    assert.deepEqual(marks, [true, false, true, false]);
  });

  it('stops when told, and keeps the best', async (t) => {
    const { page } = await open(t, 'seed="1" seconds="60" allow-off-bed');
    await choose(page, 'keyboard.dxf', bytes(KEYBOARD));
    await page.getByRole('button', { name: 'Stop' }).click();
    await state(page, 'done');
    assert.ok(['stopped', 'exhausted'].includes(await page.evaluate(() => window.events.at(-1)[1].reason)));
    assert.equal(await page.getByRole('button', { name: 'Stop' }).isVisible(), false);
  });

  it('says in one sentence what it cannot use, and goes on with the next file', async (t) => {
    const { page } = await open(t);
    await choose(page, 'empty.dxf', new Uint8Array(0));
    await state(page, 'failed');
    const sentence = await page.getByRole('alert').textContent();
    assert.match(sentence, /empty/);
    const [type, error] = await page.evaluate(() => window.events.at(-1));
    assert.deepEqual([type, error.message, Object.keys(error)], ['error', sentence, ['code', 'message', 'params', 'retryable']]);
    await choose(page, 'plate.dxf', PLATE);
    await state(page, 'done');
    assert.equal(await page.getByRole('alert').isVisible(), false);
  });

  it('is opened by its host, which renders what it likes; the later of two drawings wins', async (t) => {
    const { page } = await open(t);
    const { first, contours, svg, results } = await page.evaluate(async ({ keyboard, plate }) => {
      const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const planner = document.querySelector('kerfway-planner');
      planner.options = { layers: [{ name: '0', operation: 'mark' }] };
      const first = planner.open(bytes(keyboard), 'keyboard.dxf').catch((error) => error.name);
      const second = await planner.open(bytes(plate), 'plate.dxf');
      const svg = await planner.render('svg');
      return { first: await first, contours: second.loaded.contours.map((c) => c.operation), svg, results: window.events.filter(([type]) => type === 'result').length };
    }, { keyboard: base64(bytes(KEYBOARD)), plate: base64(PLATE) });
    assert.equal(first, 'AbortError');
    assert.deepEqual(contours, ['mark', 'mark']);
    assert.match(svg, /<svg /);
    assert.equal(results, 1);
    assert.deepEqual((await events(page)).filter((e) => e === 'error'), []);
  });

  it('rendered the plan of the next drawing, where that was opened before the rendering of this one had ended', async (t) => {
    const { page } = await open(t);
    const [plates, rings] = [40, 20].map((size) => dxf(square(0, 0, 100), circle(50, 50, size)));
    const { render, second } = await page.evaluate(async ({ first, second }) => {
      const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const planner = document.querySelector('kerfway-planner');
      await planner.open(bytes(first), 'first.dxf');
      const render = planner.render('dxf').then((text) => text, (error) => error.name);
      const { loaded, outputs } = await planner.open(bytes(second), 'second.dxf');
      return { render: await render, second: [loaded.name, outputs.gcode.length > 0, (await planner.render('dxf')).length > 0] };
    }, { first: base64(plates), second: base64(rings) });
    assert.equal(render, 'AbortError');
    assert.deepEqual(second, ['second.dxf', true, true]);
  });

  it('ends its worker when it is taken out of the page', async (t) => {
    const { page } = await open(t, 'seconds="60" allow-off-bed');
    await choose(page, 'keyboard.dxf', bytes(KEYBOARD));
    await state(page, 'planning');
    assert.equal(page.workers().length, 1);
    const closed = new Promise((resolve) => page.workers()[0].once('close', resolve));
    await page.evaluate(() => (window.element = document.querySelector('kerfway-planner')).remove());
    await closed;
    assert.equal(await page.evaluate(() => {
      const { element } = window;
      document.body.append(element);
      return element.state;
    }), 'empty');
    await page.waitForFunction(() => window.events.filter(([type]) => type === 'ready').length === 2);
  });

  it('speaks to nobody but its own files', async (t) => {
    const { page, requests, url } = await open(t);
    await choose(page, 'keyboard.dxf', bytes(KEYBOARD));
    await state(page, 'done');
    assert.deepEqual(requests.filter((r) => !r.startsWith(url) && !r.startsWith('blob:')), []);
    assert.ok(requests.every((r) => /\/(embedder\.(html|js)|favicon\.ico|[\w/-]+\.(js|wasm))$/.test(r)), requests.join(' '));
  });
});
