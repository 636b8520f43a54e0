// The single-file build by a script tag, as examples/script-tag shows it: from disk and by http.

import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { after, before, describe, it } from 'node:test';
import * as kerfway from 'kerfway';
import { serve } from '../../scripts/serve.mjs';
import { DIST, ROOT } from '../../scripts/tools.mjs';
import { bytes, fixture, KEYBOARD } from '../package/support.mjs';
import { base64, embedding } from './embed-support.mjs';

const at = embedding();
let folder, server;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'kerfway-script-'));
  cpSync(join(ROOT, 'examples', 'script-tag'), folder, { recursive: true });
  cpSync(join(DIST, 'sdk', 'kerfway.global.js'), join(folder, 'kerfway.global.js'));
  server = await serve(folder, 0, { 'worker-src': 'blob:' });
});
after(async () => {
  await server.close();
  rmSync(folder, { recursive: true });
});

for (const place of ['disk', 'http']) {
  describe(`from ${place}`, () => {
    let page;
    const [requests, wrong] = [[], []];
    before(async () => {
      page = await at.browser.newPage();
      page.on('request', (request) => requests.push(request.url()));
      page.on('pageerror', (error) => wrong.push(String(error)));
      page.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
      await page.goto(place === 'disk' ? pathToFileURL(join(folder, 'index.html')).href : server.url);
    });
    after(() => page.close());

    it('the functions plan what Node plans, byte for byte, with its bound; what is not inside is told', async () => {
      const options = { units: 'mm', seed: 4, moves: 20_000, allowOffBed: true, name: 'keyboard.dxf', outputs: ['json', 'gcode'] };
      const here = await page.evaluate(async ({ file, options }) => {
        const drawing = Uint8Array.from(atob(file), (c) => c.charCodeAt(0));
        const { outputs } = await Kerfway.plan(drawing, options);
        const planner = await Kerfway.createPlanner();
        const papers = await planner.paperMethods().catch((error) => error.message);
        planner.close();
        const png = await Kerfway.plan(drawing, { moves: 1, outputs: ['png'] }).catch((error) => error.message);
        const other = await Kerfway.createPlanner();
        const [machine] = other.machines;
        other.close();
        const withKerf = await Kerfway.plan(drawing, { units: 'mm', seed: 4, moves: 1000, machine: { ...machine, kerf_width: 0.2 } });
        return { outputs, papers, png, machine, cutWithKerf: withKerf.summary.cut_length };
      }, { file: base64(bytes(KEYBOARD)), options });
      const { outputs } = await kerfway.plan(bytes(KEYBOARD), options);
      assert.ok(here.outputs.json === outputs.json, 'another plan than under Node');
      assert.ok(here.outputs.gcode === outputs.gcode, 'another program than under Node');
      assert.match(here.papers, /single-file build reads no SVG, has no methods from papers, and does not plan the levers fly, chains, bridges, common_cuts, tips, heat and corners/);
      assert.match(here.png, /single-file build writes no PNG/);
      const withKerf = await kerfway.plan(bytes(KEYBOARD), { units: 'mm', seed: 4, moves: 1000, machine: { ...here.machine, kerf_width: 0.2 } });
      assert.equal(here.cutWithKerf, withKerf.summary.cut_length);
    });

    it('every function of the package is there', async () => {
      const here = await page.evaluate(() => Object.keys(Kerfway));
      assert.deepEqual(Object.keys(kerfway).filter((name) => !here.includes(name)), []);
    });

    it('the example tells the time of the job and counts the lines', async () => {
      await page.locator('#file').setInputFiles(fixture(KEYBOARD));
      await page.getByRole('button', { name: 'Stop' }).last().click();
      await page.waitForFunction(() => /^[\d.]+ s, \d+ lines of G-code$/.test(document.querySelector('#told').textContent));
    });

    it('the element is there, and nothing but the page and its scripts was loaded', async () => {
      await page.waitForFunction(() => document.querySelector('kerfway-planner').state === 'empty');
      const files = requests.filter((r) => !r.startsWith('blob:')).map((r) => r.replace(/^.*\//, ''));
      assert.deepEqual(files.filter((f) => f !== 'favicon.ico').sort(), [place === 'disk' ? 'index.html' : '', 'example.js', 'kerfway.global.js'].sort());
      assert.deepEqual(wrong.filter((w) => !w.includes('404')), []);
    });
  });
}
