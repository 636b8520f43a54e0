// Layers, materials and passes on the command line and in the package; calibration.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { createPlanner, plan, quote, verifyQuote } from 'kerfway';
import { circle, dxf, folder, kerfway, square } from './support.mjs';

const QUICK = ['--moves', '20', '--seed', '1', '--units', 'mm'];
const DRAWING = dxf(square(10, 10, 100), circle(60, 60, 20));
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-6, `${a} is not ${b}`);

/** A machine without accelerations, with a library of one material. */
async function machine() {
  const planner = await createPlanner();
  const preset = planner.machines.find((m) => m.name === 'co2-100w');
  planner.close();
  const process = { speed: 10, accel: null, power: 0.8 };
  const materials = [{ name: '3 mm birch ply', cut: { speed: 5, passes: 2 }, pierce_time: 0.4 }];
  return { ...preset, rapid: { speed: [100, 100], accel: null }, cut: process, mark: process, junction_deviation: null, pierce_time: 0.1, beam_on_delay: 0, beam_off_delay: 0, materials };
}

const LENGTH = 400 + 40 * Math.PI;

describe('layers and passes', () => {
  it('are set on the command line', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'a.dxf'), DRAWING);
    writeFileSync(join(at, 'm.json'), JSON.stringify(await machine()));
    const run = async (...more) => {
      const { code, stderr } = await kerfway('plan', join(at, 'a.dxf'), ...QUICK, '--machine', join(at, 'm.json'), '--json', join(at, 'a.json'), ...more);
      assert.equal(stderr, '');
      assert.equal(code, 0);
      return JSON.parse(readFileSync(join(at, 'a.json'), 'utf8'));
    };
    near((await run()).summary.cut_time, LENGTH / 10);
    const set = await run('--layer', '0=cut,speed=4,passes=3,air=on', '--pass-order', 'sheet');
    near(set.summary.cut_time, (3 * LENGTH) / 4);
    assert.deepEqual(set.options.layers, [{ name: '0', operation: 'cut', settings: { speed: 4, passes: 3, air: true } }]);
    assert.deepEqual([set.options.pass_order, set.contours.filter((c) => c.next_pass !== undefined).length], ['sheet', 4]);
    const ply = await run('--material', '3 mm birch ply');
    near(ply.summary.cut_time, (2 * LENGTH) / 5);
    near(ply.summary.pierce_time, 2 * 2 * 0.4);
    assert.equal(ply.material, '3 mm birch ply');
  });

  it('are refused with one sentence where they are wrong', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'a.dxf'), DRAWING);
    for (const [words, status, sentence] of [
      [['--layer', '0=cut,speed'], 2, /write NAME=cut, NAME=mark or NAME=ignore, and settings after commas/],
      [['--layer', '0=cut,sped=3'], 2, /setting sped: choose one of speed, power, min-power, passes, z-step, air/],
      [['--layer', '0=cut,speed=fast'], 2, /speed is "fast"\. Give a number/],
      [['--layer', '0=cut,air=maybe'], 2, /air maybe: choose one of on, off/],
      [['--layer', '0=cut,passes=1.5'], 2, /passes is 1\.5\. Give a whole number/],
      [['--material', 'oak'], 1, /The machine co2-100w has no setting for the material "oak"\. Its library is empty/],
    ]) {
      const { code, stderr } = await kerfway('plan', join(at, 'a.dxf'), ...QUICK, '--json', join(at, 'a.json'), ...words);
      assert.match(stderr, sentence);
      assert.equal(code, status, words.join(' '));
    }
  });
});

describe('quotes', () => {
  it('plan with the material they name, and refuse one that the machine has no setting for', async () => {
    const options = { units: 'mm', moves: 10, seed: 1, machine: await machine() };
    near((await quote(DRAWING, { ...options, material: { name: '3 mm birch ply' } })).times.cut, (2 * LENGTH) / 5);
    await assert.rejects(quote(DRAWING, { ...options, material: { name: '1 mm steel' } }), /The machine co2-100w has no setting for the material "1 mm steel"\. It has: 3 mm birch ply\./);
    const { confidence } = await quote(DRAWING, { ...options, machine: 'co2-100w', material: { name: '1 mm steel' } });
    assert.ok(confidence.reasons.some((r) => r.code === 'no-setting' && r.message.startsWith('The machine has no setting for 1 mm steel')), JSON.stringify(confidence));
  });
});

describe('verifyQuote', () => {
  it('confirms a quote with a setting of the library and settings of layers', async () => {
    const options = { units: 'mm', moves: 10, seed: 1, machine: await machine(), layers: [{ name: '0', operation: 'cut', minPower: 0.2, passes: 3 }], passOrder: 'sheet' };
    const report = await quote(DRAWING, { ...options, material: { name: '3 mm birch ply' } });
    assert.equal(report.setting, '3 mm birch ply');
    near(report.times.cut, (3 * LENGTH) / 5);
    near(report.parts.reduce((sum, p) => sum + p.items.reduce((s, i) => s + i.times.cut, 0), 0), report.times.cut);
    assert.deepEqual((await verifyQuote(DRAWING, report)).differences, []);
    const faster = { ...report, machine: { ...report.machine, cut: { ...report.machine.cut, speed: 50 } } };
    assert.equal((await verifyQuote(DRAWING, faster)).valid, false);
  });
});

describe('calibration', () => {
  it('fits a machine to the seconds of a job, with the error before and after', async (t) => {
    const at = folder(t);
    const { outputs, summary } = await plan(DRAWING, { units: 'mm', moves: 10, seed: 1, outputs: ['json'] });
    writeFileSync(join(at, 'a.json'), outputs.json);
    const took = summary.total_time + 1;
    const { code, stdout } = await kerfway('calibrate', `${join(at, 'a.json')}=${took}`, '--json', join(at, 'fitted.json'));
    assert.equal(code, 0);
    assert.match(stdout, /measured; planned .* before \(-[\d.]+ %\), .* after \((the same|[+-]0\.0\d %)\)/);
    assert.match(stdout, /^pierce_time +0\.1 to /m);
    const fitted = JSON.parse(readFileSync(join(at, 'fitted.json'), 'utf8'));
    const again = await plan(DRAWING, { units: 'mm', moves: 10, seed: 1, machine: fitted });
    assert.ok(Math.abs(again.summary.total_time / took - 1) < 0.005, `${again.summary.total_time} s, measured ${took} s`);
    for (const [word, sentence] of [['a.json', /write PLAN\.json=SECONDS/], ['a.json=-3', /write PLAN\.json=SECONDS/]]) {
      const { code: status, stderr } = await kerfway('calibrate', word);
      assert.equal(status, 2);
      assert.match(stderr, sentence);
    }
  });
});
