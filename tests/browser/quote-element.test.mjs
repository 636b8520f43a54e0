// <kerfway-quote> in a host's page, under a strict Content-Security-Policy.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { quote } from 'kerfway';
import { bytes, circle, dxf, square } from '../package/support.mjs';
import { base64, embedding, openHost } from './embed-support.mjs';
import { inBothThemes, picture, serious } from './page-pictures.mjs';
import { until } from './page-support.mjs';

const at = embedding();
/** A real drawing of eight parts, which is quoted in a second. */
const PLATES = 'dxf-dev/gdsestimating_dxf-parser__polylines.dxf';
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
/** 100 x 100 less a hole of 20 across, mm2. */
const NET = 1e4 - Math.PI * 100;

const SCRIPT = `
  import './element/index.js';
  const element = document.querySelector('kerfway-quote');
  element.price = (quote) => (quote.times.cut * 0.02 + (quote.weight ?? 0) * 0.01).toFixed(2) + ' EUR';
  window.events = [];
  for (const type of ['ready', 'progress', 'result', 'error']) element.addEventListener(type, ({ detail }) => window.events.push([type, type === 'progress' ? null : detail]));`;

const open = (t, attributes = '', more = {}) => openHost(t, at, { html: `<kerfway-quote units="mm" ${attributes}></kerfway-quote>`, script: SCRIPT, ...more });

const state = (page, wanted) => page.waitForFunction((s) => document.querySelector('kerfway-quote').state === s, wanted);
const results = (page) => page.evaluate(() => window.events.filter(([type]) => type === 'result').map(([, detail]) => detail));
const count = (page, n) => page.waitForFunction((n) => window.events.filter(([type]) => type === 'result').length === n, n);
const choose = async (page, name, bytes) => {
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: /Choose a file|Another file/ }).click()]);
  await chooser.setFiles({ name, mimeType: 'image/vnd.dxf', buffer: Buffer.from(bytes) });
};
/** The report as it stands there, by term. */
const shown = async (page) => {
  const [terms, figures] = await Promise.all(['term', 'figure'].map((part) => page.locator(`[part=${part}]`).allTextContents()));
  return Object.fromEntries(terms.map((term, k) => [term, figures[k]]));
};

/** Runs in the page: whether a canvas is drawn in the colour that CSS gives it now. */
function isInItsColour(canvas) {
  const wanted = getComputedStyle(canvas).color.match(/\d+/g).map(Number);
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255 && wanted.every((v, k) => Math.abs(data[i + k] - v) <= 1)) return true;
  return false;
}

describe('<kerfway-quote>', () => {
  it('reports again for another attribute after its material was set to nothing', async (t) => {
    const { page } = await open(t, 'thickness="3" density="7.85" moves="100" seed="1"');
    await choose(page, 'plate.dxf', PLATE);
    await state(page, 'done');
    // As React does with a property that is taken away.
    await page.evaluate(() => (document.querySelector('kerfway-quote').material = undefined));
    await count(page, 2);
    await page.evaluate(() => document.querySelector('kerfway-quote').setAttribute('thickness', '6'));
    await count(page, 3);
    const weights = (await results(page)).map(({ weight }) => weight);
    assert.equal(weights[1], weights[0]);
    assert.ok(Math.abs(weights[2] - 2 * weights[0]) < 1e-9, String(weights));
  });

  it('had a report that no server can confirm, once its worker had died', async (t) => {
    const { page } = await open(t, 'moves="3000000" seed="1"');
    await page.evaluate(() => {
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function (message, ...rest) {
        const { onmessage } = this;
        if (message.type === 'plan') {
          this.onmessage = (event) => {
            onmessage(event);
            if (event.data.progress?.moves > 0) this.onerror({ message: 'gone' });
          };
          Worker.prototype.postMessage = postMessage;
        }
        return postMessage.call(this, message, ...rest);
      };
    });
    await choose(page, 'plates.dxf', bytes(PLATES));
    await state(page, 'failed');
    const [[, { code, message, retryable }]] = await page.evaluate(() => window.events.filter(([type]) => type === 'error'));
    assert.deepEqual([code, message, retryable], ['planner-died', 'The planner had to be started again. Open the drawing again.', true]);
    assert.deepEqual(await results(page), []);
    await choose(page, 'plates.dxf', bytes(PLATES));
    await state(page, 'done');
    assert.equal((await results(page))[0].moves, 3_000_000);
  });

  it('speaks the language of its host, and chooses sentences by the code of an error', async (t) => {
    const { page } = await open(t);
    await page.evaluate(() => {
      document.querySelector('kerfway-quote').labels = {
        drop: 'Hierher <b>ziehen</b>', choose: 'Datei auswählen', again: 'Andere Datei', job: ({ contours }) => `${contours} Konturen`,
        error: ({ code }) => `Fehler ${code}`, facts: (quote) => [['Teile', String(quote.part_count)]],
      };
    });
    // Labels are text, not markup.
    assert.equal(await page.locator('[part=drop] span').textContent(), 'Hierher <b>ziehen</b>');
    const german = async (name, bytes) => {
      const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: /Datei auswählen|Andere Datei/ }).click()]);
      await chooser.setFiles({ name, mimeType: 'image/vnd.dxf', buffer: Buffer.from(bytes) });
    };
    await german('plate.dxf', PLATE);
    await state(page, 'done');
    assert.deepEqual(await shown(page), { Teile: '1' });
    assert.equal(await page.locator('[part=numbers]').textContent(), '2 Konturen');
    await german('empty.dxf', new Uint8Array(0));
    await state(page, 'failed');
    assert.equal(await page.locator('[part=message]').textContent(), 'Fehler not-a-drawing');
  });

  it('reports the file that is chosen, as a server that plans again confirms by the hash', async (t) => {
    const { page } = await open(t, 'thickness="3" density="0.7" material="birch"');
    await choose(page, 'plates.dxf', bytes(PLATES));
    await state(page, 'done');
    const [told] = await results(page);
    const again = await quote(bytes(PLATES), { name: 'plates.dxf', units: 'mm', material: { name: 'birch', thickness: 3, density: 0.7 } });
    assert.equal(told.hash, again.hash);
    assert.deepEqual(told, again);
    const types = await page.evaluate(() => window.events.map(([type]) => type));
    assert.deepEqual([types[0], types.at(-1), types.includes('progress')], ['ready', 'result', true]);
    const rows = await shown(page);
    assert.equal(rows.Parts.split(',')[0], String(told.part_count));
    assert.match(rows.Confidence, new RegExp(`^${told.confidence.level}`));
    const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download the report' }).click()]);
    assert.equal(file.suggestedFilename(), 'plates.quote.json');
    assert.deepEqual(JSON.parse(readFileSync(await file.path(), 'utf8')), told);
  });

  it('weighs and prices anew when the material changes, without planning anew', async (t) => {
    const { page } = await open(t);
    await choose(page, 'plate.dxf', PLATE);
    await state(page, 'done');
    assert.equal((await shown(page)).Weight, undefined);
    const without = await page.locator('[part=price]').textContent();
    await page.evaluate(() => {
      const element = document.querySelector('kerfway-quote');
      element.setAttribute('thickness', '2');
      element.setAttribute('density', '7.85');
    });
    await page.waitForFunction(() => document.querySelector('kerfway-quote').result.weight !== null);
    const [first, ...others] = await results(page);
    const last = others.at(-1);
    assert.ok(Math.abs(last.weight / ((NET / 100) * 0.2 * 7.85) - 1) < 1e-9, `${last.weight} g`);
    assert.equal((await shown(page)).Weight, '152 g');
    assert.deepEqual([last.times, last.moves], [first.times, first.moves]);
    const price = Number.parseFloat(await page.locator('[part=price]').textContent());
    assert.ok(Math.abs(price - Number.parseFloat(without) - last.weight * 0.01) < 0.011, `${price} after ${without}`);

    const told = (await results(page)).length;
    await page.evaluate(() => (document.querySelector('kerfway-quote').material = { name: 'steel', thickness: 4, density: 7.85 }));
    await count(page, told + 1);
    const set = (await results(page)).at(-1);
    assert.ok(Math.abs(set.weight / last.weight - 2) < 1e-9);
    await page.evaluate(() => document.querySelector('kerfway-quote').setAttribute('thickness', '9'));
    assert.equal((await results(page)).length, told + 1);
  });

  it('plans again for another material when it was moved in its page meanwhile', async (t) => {
    const { page } = await open(t);
    await choose(page, 'plate.dxf', PLATE);
    await state(page, 'done');
    await page.evaluate(() => {
      const element = document.querySelector('kerfway-quote');
      document.body.append(document.createElement('main'));
      document.querySelector('main').append(element);
      element.material = { thickness: 1, density: 1 };
    });
    await count(page, 2);
    const [first, second] = await results(page);
    assert.equal(first.weight, null);
    assert.ok(Math.abs(second.weight / (NET / 1000) - 1) < 1e-9);
  });

  it('told its host the report of the drawing before, once another one had been opened, and was done while that was being read', async (t) => {
    const { page } = await open(t, 'thickness="3" density="7.85" moves="100" seed="1"');
    const told = await page.evaluate(async ({ first, second }) => {
      const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const element = document.querySelector('kerfway-quote');
      await element.open(bytes(first), 'first.dxf');
      const told = [];
      for (const type of ['result', 'error']) element.addEventListener(type, ({ detail }) => told.push([type, detail.input?.name ?? detail.code, element.state]));
      element.setAttribute('thickness', '6');
      const { material } = await element.open(bytes(second), 'second.dxf');
      return [...told, material.thickness];
    }, { first: base64(PLATE), second: base64(bytes(PLATES)) });
    assert.deepEqual(told, [['result', 'second.dxf', 'done'], 6]);
  });

  it('says in one sentence what it cannot use, and the price function may fail, too', async (t) => {
    const { page } = await open(t);
    await choose(page, 'empty.dxf', new Uint8Array(0));
    await state(page, 'failed');
    assert.match(await page.getByRole('alert').textContent(), /empty/);
    await page.evaluate(() => (document.querySelector('kerfway-quote').price = () => { throw new Error('No price for this machine.'); }));
    await choose(page, 'plate.dxf', PLATE);
    await page.getByText('No price for this machine.').waitFor();
    assert.deepEqual(await page.evaluate(() => window.events.filter(([type]) => type === 'error').map(([, d]) => d.message).slice(1)), ['No price for this machine.']);
    assert.deepEqual(await results(page), []);
  });

  for (const width of [900, 390]) {
    it(`is readable at ${width} px in both themes, and takes its host's looks`, async (t) => {
      const { page } = await open(t, 'thickness="3" density="7.85"', { size: { width, height: 800 } });
      await page.evaluate(() => {
        document.documentElement.style.colorScheme = 'light dark';
        document.querySelector('kerfway-quote').style.setProperty('--kerfway-accent', 'rgb(10, 125, 79)');
        document.querySelector('kerfway-quote').style.setProperty('--kerfway-on-accent', 'white');
      });
      await choose(page, 'plates.dxf', bytes(PLATES));
      await state(page, 'done');
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      await inBothThemes(page, async (theme) => {
        assert.equal(await page.locator('[part~=download]').evaluate((b) => getComputedStyle(b).backgroundColor), 'rgb(10, 125, 79)', theme);
        for (const part of ['contours', 'path']) await until(page, `the ${part} have the colour of the ${theme} theme`, () => page.locator(`[part=${part}]`).evaluate(isInItsColour));
        await picture(page, `quote-element-${width}-${theme}`);
      });
      assert.deepEqual(await serious(page, 'kerfway-quote'), []);
    });
  }
});
