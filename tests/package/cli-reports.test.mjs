// What the command line reports to people: no rounding to nothing, no sentence about what is not there.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { area, duration, elapsed, grams, meters, millimetres, size } from '../../dist/sdk/words.js';
import { circle, dxf, fixture, folder, kerfway, line, square } from './support.mjs';

/** A drawing of one square, in a folder of its own. */
function drawing(t) {
  const at = folder(t);
  const path = join(at, 'plate.dxf');
  writeFileSync(path, dxf(square(0, 0, 40)));
  return { at, path };
}

describe('reports of the command line', () => {
  it('short searches take milliseconds and not 0.0 s', async (t) => {
    assert.deepEqual([0, 0.0002, 0.016, 0.9994, 0.9996, 10].map(elapsed), ['1 ms', '1 ms', '16 ms', '999 ms', '1.0 s', '10.0 s']);
    assert.match((await kerfway('plan', drawing(t).path, '--moves', '1')).stdout, /, 1 move in \d+ ms;/);
  });

  it('only nothing is shown as 0', () => {
    assert.deepEqual([0, 0.2, 344].map(meters), ['0.000 m', 'under 0.001 m', '0.344 m']);
    assert.deepEqual([0, 0.02, 0.05, 119.94, 119.96].map(duration), ['0.0 s', 'under 0.1 s', '0.1 s', '119.9 s', '2 min 00 s']);
    assert.deepEqual([7199.4, 7199.6, 11_040, 11_069, 11_071, 90_000].map(duration), ['119 min 59 s', '2 h 00 min', '3 h 04 min', '3 h 04 min', '3 h 05 min', '25 h 00 min']);
    assert.deepEqual([0.002, 0.011].map(millimetres), ['under 0.01 mm', '0.01 mm']);
    assert.deepEqual([0.0004, 0.4, 9.99, 344, 15_000].map(area), ['under 0.01 mm²', '0.40 mm²', '9.99 mm²', '344 mm²', '0.0150 m²']);
    assert.deepEqual([0.001, 0.4, 8.1, 12.4, 2500].map(grams), ['under 0.01 g', '0.40 g', '8.10 g', '12 g', '2.50 kg']);
    assert.equal(size([0, 0, 0.02, 40]), 'under 0.1 x 40.0 mm');
  });

  it('the warnings of a plan were in its JSON only', async (t) => {
    const { at, path } = drawing(t);
    // Two squares 0.1 mm apart, and a hole of 0.2 mm.
    writeFileSync(path, dxf(square(0, 0, 40), square(40.1, 0, 40), circle(20, 20, 0.1)));
    const words = ['plan', path, '--units', 'mm', '--kerf-width', '0.3', '--moves', '10', '--seed', '1'];
    for (const [more, findings] of [[[], /^Findings {3}4: --json lists them$/m], [['--json', join(at, 'plate.json')], /^Findings {3}4: the JSON lists them$/m], [['--quiet'], /^$/]]) {
      const { code, stdout, stderr } = await kerfway(...words, ...more);
      assert.equal(code, 0, stderr);
      assert.match(stdout, findings);
      const [kerf, small, end] = stderr.split('\n');
      assert.match(kerf, /^kerfway: \S+plate\.dxf: 3 warnings kerf-not-applied, for example: .*less than the kerf.* \(layer 0, at 40\.05, [\d.]+\)$/);
      assert.match(small, /^kerfway: \S+plate\.dxf: This contour is 0\.2 mm wide .* \(layer 0, at 20\.00, 20\.00\)$/);
      assert.equal(end, '', 'one line for each code');
    }
    assert.match((await kerfway('quote', ...words.slice(1))).stdout, /^ +3 contours are cut along their drawn lines, without kerf compensation\.$/m);
  });

  it('warnings of the drawing and of the plan are counted together, and --quiet prints both', async (t) => {
    const { path } = drawing(t);
    writeFileSync(path, dxf(square(0, 0, 40), square(40.1, 0, 40), line(100, 0, 120, 0), line(100, 9, 120, 9)));
    const words = ['plan', path, '--units', 'mm', '--kerf-width', '0.3', '--moves', '10', '--seed', '1'];
    const [loud, quiet] = [await kerfway(...words), await kerfway(...words, '--quiet')];
    assert.match(loud.stdout, /^Findings {3}4: kerfway inspect \S+plate\.dxf lists 2 of them, --json all$/m);
    const codes = ({ stderr }) => [...stderr.matchAll(/: (\d) warnings ([a-z-]+), for example: /g)].map(([, n, code]) => `${n} ${code}`);
    assert.deepEqual([codes(loud), codes(quiet)], [['2 kerf-not-applied'], ['2 open-contour', '2 kerf-not-applied']]);
    const inspected = await kerfway('inspect', path, '--units', 'mm', '--quiet');
    assert.deepEqual([inspected.stdout, codes(inspected)], ['', ['2 open-contour']]);
  });

  it('contours beyond those that are listed are counted', async (t) => {
    const { path } = drawing(t);
    writeFileSync(path, dxf(...Array.from({ length: 250 }, (_, k) => square(10 * (k % 25), 10 * Math.floor(k / 25), 4))));
    const { stderr } = await kerfway('plan', path, '--units', 'mm', '--joints', '9', '--joint-width', '2', '--moves', '10', '--seed', '1', '--quiet');
    assert.match(stderr, /^kerfway: \S+: 200 warnings joint-\w+, for example: Contour 0 has .*\nkerfway: \S+: Not listed one by one: 50 .*\n$/);
  });

  it('a misspelt layer is no finding of the drawing, in which inspect would look for it in vain', async (t) => {
    const { code, stdout, stderr } = await kerfway('plan', drawing(t).path, '--moves', '1', '--layer', 'none=mark');
    assert.deepEqual([code, /has no layer "none"/.test(stderr), /Findings/.test(stdout)], [0, true, false]);
  });

  it('calibrate says what it has fitted, also beside its JSON, and an equal time is the same', async (t) => {
    const { at, path } = drawing(t);
    const plan = join(at, 'plan.json');
    await kerfway('plan', path, '--moves', '1', '--seed', '1', '--json', plan);
    const alone = await kerfway('calibrate', `${plan}=8`);
    const piped = await kerfway('calibrate', `${plan}=8`, '--json', '-');
    assert.match(alone.stdout, /^plate\.dxf: 8\.0 s measured; planned [\d.]+ s before \([+-][\d.]+ %\), 8\.0 s after \(the same\)\n/);
    assert.equal(piped.stderr, alone.stdout);
    assert.equal(JSON.parse(piped.stdout).name, 'co2-100w');
  });

  it('calibrate fitted the default machine to a plan that was made for another one', async (t) => {
    const { at, path } = drawing(t);
    const [plan, other] = [join(at, 'plan.json'), join(at, 'other.json')];
    await kerfway('plan', path, '--moves', '1', '--seed', '1', '--machine', 'fibre-3kw-thin', '--json', plan);
    await kerfway('plan', path, '--moves', '1', '--seed', '1', '--machine', 'k40', '--json', other);
    const { stdout, stderr } = await kerfway('calibrate', `${plan}=8`, '--json', '-');
    assert.equal(JSON.parse(stdout).name, 'fibre-3kw-thin');
    assert.match(stderr, /^pierce_time +0\.1 to /m);
    const two = await kerfway('calibrate', `${plan}=8`, `${other}=9`);
    assert.deepEqual([two.code, two.stderr.split('\n')[0]], [2, `kerfway: ${plan} was planned for fibre-3kw-thin and ${other} for k40: say with --machine which one is to be fitted.`]);
    const named = await kerfway('calibrate', `${plan}=8`, '--machine', 'k40');
    assert.deepEqual([named.code, named.stderr], [0, `kerfway: ${plan} was planned for fibre-3kw-thin. k40 is fitted to its time.\n`]);
  });

  it('calibrate named all its plans when one of them could not be used', async (t) => {
    const { at, path } = drawing(t);
    const [plan, other] = [join(at, 'plan.json'), join(at, 'other.json')];
    await kerfway('plan', path, '--moves', '1', '--seed', '1', '--json', plan);
    writeFileSync(other, '{}');
    const { code, stderr } = await kerfway('calibrate', `${plan}=8`, `${other}=9`);
    assert.deepEqual([code, stderr], [1, `kerfway: ${other}: This is not a plan of the kind kerfway.plan/1: it has no text \`schema\`.\n`]);
  });

  it('JSON that Windows PowerShell had stored from standard output was no JSON', async (t) => {
    const { at, path } = drawing(t);
    const [plan, mine] = [join(at, 'plan.json'), join(at, 'mine.json')];
    const stored = (file, text) => writeFileSync(file, `\ufeff${text}`, 'utf16le');
    stored(plan, (await kerfway('plan', path, '--moves', '1', '--seed', '1', '--json', '-')).stdout);
    const { code, stdout, stderr } = await kerfway('calibrate', `${plan}=8`, '--json', '-');
    assert.equal(code, 0, stderr);
    stored(mine, stdout);
    assert.match((await kerfway('plan', path, '--moves', '1', '--machine', mine)).stdout, /; machine co2-100w$/m);
  });

  it('calibrate wrote a machine for seconds that no machine near to this one takes', async (t) => {
    const { at, path } = drawing(t);
    const [plan, fitted] = [join(at, 'plan.json'), join(at, 'fitted.json')];
    await kerfway('plan', path, '--moves', '1', '--seed', '1', '--json', plan);
    const planned = JSON.parse(readFileSync(plan, 'utf8')).summary.total_time;
    for (const seconds of [0.01 * planned, 1000 * planned]) {
      const { code, stdout, stderr } = await kerfway('calibrate', `${plan}=${seconds}`, '--json', fitted);
      assert.deepEqual([code, stdout, existsSync(fitted)], [1, '', false]);
      assert.match(stderr, /^kerfway: .*plan\.json: plate\.dxf took [\d.]+ s, and [\d.]+ s are planned: no acceleration, .* Check the seconds, and the speeds of the machine\.\n$/);
    }
    const piped = await kerfway('calibrate', `${plan}=0.001`, '--json', '-');
    assert.equal(JSON.parse(piped.stdout).error.code, 'out-of-range');
    assert.equal((await kerfway('calibrate', `${plan}=1e300`)).code, 2);
    const { stdout } = await kerfway('calibrate', `${plan}=${0.93 * planned}`);
    assert.match(stdout, /^pierce_time +0\.1 to 0 s, as far as the fit goes$/m);
  });

  it('check of a program that cuts nothing counts no contours and reaches nowhere', async (t) => {
    const { at } = drawing(t);
    const program = join(at, 'empty.nc');
    writeFileSync(program, '');
    const { code, stdout } = await kerfway('check', program);
    assert.equal(code, 1);
    assert.match(stdout, /^Contours {3}none$/m);
    assert.doesNotMatch(stdout, /equally often|on the bed/);
  });

  it('quote counts no sheets where no part fits on one', async (t) => {
    const { stdout } = await kerfway('quote', drawing(t).path, '--moves', '1', '--seed', '1', '--sheet', '30x30');
    assert.match(stdout, /^1 copy {5}[\d.]+ s, 1 part too large for a sheet$/m);
  });

  it('verify of another file says that it is no certificate', async (t) => {
    const { code, stderr } = await kerfway('verify', drawing(t).path);
    assert.deepEqual([code, /plate\.dxf names no drawing: either it is no certificate, or give its drawing after it\./.test(stderr)], [1, true], stderr);
  });

  it('verify without a drawing says where the drawing belongs', async (t) => {
    const { at } = drawing(t);
    const certificate = join(at, 'certificate.json');
    writeFileSync(certificate, '{"schema":"kerfway.certificate/1","drawing":{"name":"other.dxf"}}');
    const { code, stderr } = await kerfway('verify', certificate);
    assert.equal(code, 1);
    assert.match(stderr, /other\.dxf cannot be read: there is no such file\. Give the drawing after the certificate\.$/m);
  });

  it('a job that leaves the bed is refused without a search, if a program is asked for', async (t) => {
    const sheet = fixture('dxf-dev/gtips_reviung__reviung53_2mm_450x300_ver1.1.dxf');
    const begun = performance.now();
    const { code, stderr } = await kerfway('plan', sheet, '--seconds', '40', '--gcode', join(folder(t), 'plate.nc'));
    assert.deepEqual([code, /beyond the bed .*\(--allow-off-bed\)$/m.test(stderr), performance.now() - begun < 20_000], [1, true, true], stderr);
  });

  it('the help has the defaults of each command', async () => {
    const [plan, quote] = (await Promise.all(['plan', 'quote'].map((name) => kerfway('help', name)))).map(({ stdout }) => stdout.replace(/\s+/g, ' '));
    assert.match(plan, /--seconds S how long to search each drawing \(default 10\)/);
    assert.match(quote, /--seconds S how long to search each drawing \(default: moves that grow with the number of contours\)/);
    assert.match(plan, /--seed N the seed of all random choices \(default: a random one\)/);
    assert.match(quote, /--seed N [^-]+1 without --seconds and --moves\)/);
  });
});
