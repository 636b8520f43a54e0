// The bed: where a job lies, and programs that would leave it.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { inspect, plan } from 'kerfway';
import { bytes, dxf, folder, kerfway, square } from './support.mjs';

const QUICK = ['--moves', '20', '--seed', '1', '--units', 'mm'];

/** The extent of all coordinates of a program: xmin, ymin, xmax, ymax. */
function extent(program) {
  const of = (letter) => [...program.matchAll(new RegExp(`^G[01].* ${letter}(-?[\\d.]+)`, 'gm'))].map((m) => Number(m[1]));
  const [x, y] = [of('X'), of('Y')];
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)];
}

/** Plans a square of 30 mm with its corner at (x, y). */
async function planned(t, at, ...options) {
  const path = folder(t);
  writeFileSync(join(path, 'a.dxf'), dxf(square(...at, 30)));
  const run = await kerfway('plan', join(path, 'a.dxf'), ...QUICK, '--gcode', join(path, 'a.nc'), '--json', join(path, 'a.json'), ...options);
  const read = (name) => (existsSync(join(path, name)) ? readFileSync(join(path, name), 'utf8') : null);
  return { ...run, program: read('a.nc'), document: read('a.json') };
}

describe('a job that leaves the bed', () => {
  it('is refused without a search, if a program is asked for', async () => {
    const sheet = bytes('dxf-dev/gtips_reviung__reviung53_2mm_450x300_ver1.1.dxf');
    const begun = performance.now();
    await assert.rejects(plan(sheet, { seconds: 40, outputs: ['svg', 'gcode'] }), (error) => error.code === 'off-bed');
    assert.ok(performance.now() - begun < 20_000, 'it searched');
    assert.equal((await plan(sheet, { moves: 3000, seed: 1, outputs: ['svg'] })).moves, 3000);
  });
});

describe('kerfway plan', () => {
  it('refuses negative coordinates with one sentence, and writes nothing', async (t) => {
    const { code, stderr, program, document } = await planned(t, [-5, 10]);
    assert.equal(code, 1);
    assert.match(stderr, /The job reaches from x -5 to 25 and y 10 to 40 mm, beyond the bed \(x 0 to \d+, y 0 to \d+ mm\)\. .* Nothing was written/);
    assert.deepEqual([program, document], [null, null]);
  });

  it('refuses a drawing larger than the bed', async (t) => {
    const { code, stderr, program } = await planned(t, [0, 0], '--machine', 'diode-hobby', '--units', 'm');
    assert.equal(code, 1);
    assert.match(stderr, /The job of 30000 x 30000 mm is larger than the bed of 400 x 400 mm/);
    assert.equal(program, null);
  });

  it('writes it with --allow-off-bed', async (t) => {
    const { code, program, stderr } = await planned(t, [-5, 10], '--allow-off-bed');
    assert.equal(code, 0);
    assert.match(stderr, /^kerfway: \S+: The job reaches from x -5/m);
    assert.equal(extent(program)[0], -5);
  });

  it('places a point of the job at a place or a point of the bed', async (t) => {
    const at = async (...options) => extent((await planned(t, [-5, 10], '--no-return', ...options)).program).slice(2);
    assert.deepEqual(await at('--place', 'lower-left@10,10'), [40, 40]);
    assert.deepEqual(await at('--place', '0,10@100,50'), [125, 80]);
    assert.deepEqual(await at('--place', 'upper-right@upper-right', '--machine', 'diode-hobby'), [400, 400]);
    assert.deepEqual(await at('--place', 'center@200,100', '--turn', '90'), [215, 115]);
  });

  it('starts where the head stands', async (t) => {
    const { program, document } = await planned(t, [-5, 10], '--start', 'current', '--place', 'center@0,0');
    assert.match(program, /^G21 G91 /m);
    assert.deepEqual(JSON.parse(document).placement, { shift: [-10, -25], start: 'current' });
  });

  it('refuses a place that it does not understand', async (t) => {
    for (const [words, sentence] of [
      [['--place', 'left@1,2'], /--place left@1,2: write POINT@PLACE/],
      [['--place', 'center'], /write POINT@PLACE/],
      [['--place', 'center@1,2@3'], /write POINT@PLACE/],
      [['--place', 'center@center', '--machine', 'length'], /the machine length has no bed/],
      [['--turn', '45'], /--turn 45: choose one of 0, 90, 180, 270/],
      [['--start', 'here'], /--start here: choose one of absolute, current/],
    ]) {
      const { code, stderr } = await planned(t, [0, 0], ...words);
      assert.equal(code, 2, words.join(' '));
      assert.match(stderr, sentence);
    }
  });
});

describe('the package', () => {
  it('reports the placement, and refuses a turn that is none', async () => {
    const file = () => dxf(square(-5, 10, 30));
    const { shift, findings } = await plan(file(), { units: 'mm', moves: 1, place: { point: 'upper-left', at: [0, 30] } });
    assert.deepEqual([shift, findings], [[5, -10], []]);
    await assert.rejects(inspect(file(), { turn: 45 }), /The option "turn" is 45\. Give a number from 0 to 270 degrees/);
    await assert.rejects(plan(file(), { place: { at: [0] } }), /"place\.at" is a list\. Give a list of two/);
    await assert.rejects(plan(file(), { place: { at: [0, 0], point: 'middle' } }), /"place\.point" is "middle"\. Choose one of: lower-left/);
  });
});
