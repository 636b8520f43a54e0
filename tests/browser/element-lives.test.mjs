// The elements before they are defined, after a report that failed, and in another document.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { circle, dxf, square } from '../package/support.mjs';
import { base64, embedding, openHost } from './embed-support.mjs';

const at = embedding();
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));

/** Opens the plate in the element; resolves to what it has then, without what no page can send. */
const opened = (page, what) => page.evaluate(async ([text, what]) => {
  const element = document.querySelector('kerfway-planner, kerfway-quote');
  const result = await element.open(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), 'plate.dxf');
  return what.split('.').reduce((value, name) => value[name], { element, result });
}, [base64(PLATE), what]);

describe('the elements', () => {
  it('lost the properties that a host had set before they were defined', async (t) => {
    const early = (name, properties) => `
      const element = document.createElement('${name}');
      document.body.append(element);
      Object.assign(element, { labels: { choose: 'Datei' }, ${properties} });
      await import('./element/index.js');`;
    const planner = await openHost(t, at, { html: '', script: early('kerfway-planner', "options: { units: 'mm', moves: 100, seed: 7, allowOffBed: true, machine: 'k40' }") });
    await planner.page.waitForFunction(() => document.querySelector('kerfway-planner')?.state === 'empty');
    assert.equal(await planner.page.locator('[part~=choose]').textContent(), 'Datei');
    assert.deepEqual(await opened(planner.page, 'result.options'), { units: 'mm', moves: 100, seed: 7, allowOffBed: true, machine: 'k40' });

    const quoted = await openHost(t, at, { html: '', script: early('kerfway-quote', "options: { units: 'mm', moves: 100 }, material: { thickness: 3, density: 8 }, price: () => '5 EUR'") });
    await quoted.page.waitForFunction(() => document.querySelector('kerfway-quote')?.state === 'empty');
    assert.deepEqual(await opened(quoted.page, 'result.material'), { name: null, thickness: 3, density: 8 });
    assert.equal(await quoted.page.locator('[part=price]').textContent(), '5 EUR');
  });

  it('stayed failed when a thickness that cannot be one was put right', async (t) => {
    const { page } = await openHost(t, at, { html: '<kerfway-quote units="mm" moves="100" thickness="3," density="8"></kerfway-quote>', script: "import './element/index.js';" });
    const state = (wanted) => page.waitForFunction((s) => document.querySelector('kerfway-quote').state === s, wanted);
    const thickness = (text) => page.evaluate((text) => document.querySelector('kerfway-quote').setAttribute('thickness', text), text);
    await assert.rejects(opened(page, 'result.hash'), /thickness/);
    await state('failed');
    await thickness('3');
    await state('done');
    assert.match(await page.locator('[part=numbers]').textContent(), /^Job /);
    await thickness('x');
    await state('failed');
    await thickness('6');
    await state('done');
    assert.equal(await page.evaluate(() => document.querySelector('kerfway-quote').result.material.thickness), 6);
    // A drawing that cannot be read has no plan, and the one before it has nothing to do with it.
    await assert.rejects(page.evaluate(() => document.querySelector('kerfway-quote').open(new Uint8Array(9))));
    await thickness('3');
    await page.waitForTimeout(300);
    assert.deepEqual(await page.evaluate(() => [document.querySelector('kerfway-quote').state, document.querySelector('kerfway-quote').result]), ['failed', null]);
  });

  it('lost their styles in another document', async (t) => {
    const { page } = await openHost(t, at, { html: '<kerfway-planner units="mm" moves="100" allow-off-bed></kerfway-planner><iframe></iframe>', script: "import './element/index.js';" });
    await page.waitForFunction(() => document.querySelector('kerfway-planner').state === 'empty');
    const [before, after] = await page.evaluate(async () => {
      const element = document.querySelector('kerfway-planner');
      const look = () => [element.shadowRoot.adoptedStyleSheets.length, element.ownerDocument.defaultView.getComputedStyle(element).display];
      const before = look();
      document.querySelector('iframe').contentDocument.body.append(element);
      window.moved = element;
      return [before, look()];
    });
    assert.deepEqual(after, before);
    assert.equal(await page.evaluate(async (text) => {
      const { summary } = await window.moved.open(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)));
      return summary.contours;
    }, base64(PLATE)), 2);
  });
});
