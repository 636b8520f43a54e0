// The certificate of the lower bound: `kerfway plan --certificate`, and `kerfway verify`.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { writeProject } from 'kerfway';
import { circle, dxf, folder, kerfway, line, ROOT } from './support.mjs';

/** A folder with a drawing of twelve holes, and the path of a file in it. */
function workshop(t) {
  const at = folder(t);
  const holes = Array.from({ length: 12 }, (_, k) => circle(20 + 31 * (k % 4), 20 + 29 * Math.floor(k / 4), 4 + ((5 * k) % 7)));
  writeFileSync(join(at, 'plate.dxf'), dxf(...holes));
  return (name) => join(at, name);
}

/** Plans the drawing with a certificate, the same everywhere. */
async function certified(at, name = 'plate.certificate.json', ...more) {
  const planned = await kerfway('plan', at('plate.dxf'), '--moves', '20000', '--seed', '1', '--bound-work', '20', '--certificate', at(name), '--json', at('plate.json'), ...more);
  assert.equal(planned.code, 0, planned.stderr);
  return planned.stdout;
}

it('a certificate is verified in one sentence, and its bound is that of the plan', async (t) => {
  const at = workshop(t);
  const shown = await certified(at);
  const { code, stdout, stderr } = await kerfway('verify', at('plate.certificate.json'), '--json', at('verified.json'));
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^Proven: no plan of plate\.dxf on co2-100w takes less than \d+\.\d{3} s, because each pays \d+\.\d{3} s for piercing and cutting, and travels for at least \d+\.\d{3} s\.\n$/);
  const { seconds } = JSON.parse(readFileSync(at('verified.json'), 'utf8'));
  const { summary } = JSON.parse(readFileSync(at('plate.json'), 'utf8'));
  assert.ok(seconds <= summary.total_time && seconds > 0.95 * summary.total_time, `${seconds} of ${summary.total_time}`);
  assert.ok(summary.lower_bound >= seconds - 1e-9, 'the plan is shown with this bound or a better one');
  assert.match(shown, /^Optimum {4}at least /m);
});

it('says which settings a certificate brings with it, and that its machine only calls itself like a preset', async (t) => {
  const at = workshop(t);
  await certified(at, 'other.json', '--units', 'in', '--place', 'lower-left@5,5', '--layer', '0=cut,passes=3');
  const { stdout } = await kerfway('verify', at('other.json'), '--json', at('verified.json'));
  const holds = /^This holds with (\{.*\}): with other settings a plan may take less\.$/m.exec(stdout);
  const settings = { layers: [{ name: '0', operation: 'cut', passes: 3 }], units: 'in', place: { at: [5, 5], point: 'lower-left' } };
  assert.deepEqual(JSON.parse(holds?.[1] ?? '{}'), settings, stdout);
  const machine = { ...JSON.parse(readFileSync(at('other.json'), 'utf8')).machine, pierce_time: 9 };
  writeFileSync(at('slow.json'), JSON.stringify(machine));
  await certified(at, 'slow.certificate.json', '--machine', at('slow.json'));
  const known = async (...more) => /^Proven: no plan of plate\.dxf on (.*) takes/.exec((await kerfway('verify', at('slow.certificate.json'), ...more)).stdout)?.[1];
  assert.equal(await known(), 'a machine that calls itself co2-100w, not the preset,');
  assert.equal(await known('--machine', at('slow.json')), 'co2-100w');
});

it('the same seed and work give the same certificate, which fits its schema', async (t) => {
  const at = workshop(t);
  await certified(at);
  await certified(at, 'again.json');
  const text = readFileSync(at('plate.certificate.json'), 'utf8');
  assert.equal(readFileSync(at('again.json'), 'utf8'), text);
  const schema = JSON.parse(readFileSync(join(ROOT, 'www', 'sdk', 'certificate.schema.json'), 'utf8'));
  const valid = new Ajv2020({ strict: false }).compile(schema);
  assert.ok(valid(JSON.parse(text)), JSON.stringify(valid.errors));
  // Of few contours walks prove more than flows, and all orders more than walks. The legs of a machine with two axes have mixtures.
  const { mixtures, ...travel } = JSON.parse(text).travel;
  assert.ok(mixtures.length > 0);
  const fields = Object.keys(travel).filter((field) => field !== 'all_orders');
  assert.deepEqual(fields, ['unit', 'knots', 'near', 'company', 'charges', 'cuts', 'bound']);
});

it('where the path is proven optimal, the certificate proves all of it', async (t) => {
  const at = workshop(t);
  await certified(at, 'optimal.json', '--machine', 'length', '--bound-work', '4000');
  const { summary } = JSON.parse(readFileSync(at('plate.json'), 'utf8'));
  assert.ok(summary.gap <= 1e-6, `a gap of ${summary.gap}`);
  assert.equal(JSON.parse(readFileSync(at('optimal.json'), 'utf8')).travel.all_orders, true);
  const { code, stderr } = await kerfway('verify', at('optimal.json'), at('plate.dxf'), '--json', at('verified.json'));
  assert.equal(code, 0, stderr);
  const { seconds } = JSON.parse(readFileSync(at('verified.json'), 'utf8'));
  assert.ok(seconds <= summary.total_time && seconds >= summary.total_time * (1 - 1e-6), `${seconds} of ${summary.total_time}`);
});

it('a path of a few holes is proven optimal where the axes of a machine take different times, too', async (t) => {
  const at = workshop(t);
  const holes = [[268.569, 171.652, 4.452], [42.067, 153.68, 9.888], [194.13, 69.302, 8.848], [177.768, 112.993, 5.267], [131.974, 82.965, 9.784], [135.662, 62.919, 4.287]];
  const sides = [line(0, 0, 300, 0), line(300, 0, 300, 200), line(300, 200, 0, 200), line(0, 200, 0, 0)];
  writeFileSync(at('plate.dxf'), dxf(...sides, ...holes.map((hole) => circle(...hole))));
  const shown = await certified(at, 'optimal.json', '--machine', 'fibre-3kw-thin', '--moves', '400000', '--bound-work', '400');
  assert.match(shown, /^Optimum {4}this path is proven optimal$/m);
});

it('a certificate by shares of an earlier version is verified', async (t) => {
  const at = workshop(t);
  const circles = Array.from({ length: 12 }, (_, k) => [25 + 30 * (k % 4), 20 + 31 * Math.floor(k / 4), 4 + ((3 * (k % 4) + 5 * Math.floor(k / 4)) % 7)]);
  const entities = circles.map(([x, y, r]) => `0\nCIRCLE\n8\n0\n10\n${x}\n20\n${y}\n40\n${r}\n`).join('');
  writeFileSync(at('grid.dxf'), `0\nSECTION\n2\nENTITIES\n${entities}0\nENDSEC\n0\nEOF\n`);
  const { code, stdout, stderr } = await kerfway('verify', join(ROOT, 'tests', 'fixtures', 'certificates', 'shares.json'), at('grid.dxf'), '--machine', 'length');
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^Proven: no plan of grid\.dxf on length takes less than 822\.265 s/);
});

it('a certificate whose check would take too long is refused in a sentence', async (t) => {
  const at = workshop(t);
  await certified(at);
  const file = JSON.parse(readFileSync(at('plate.certificate.json'), 'utf8'));
  const { travel } = file;
  travel.knots = travel.knots.map((knots) => (knots.length === 0 ? [] : Array.from({ length: 1000 }, (_, k) => (k * 20) / 1000)));
  const sealed = (sha256) => JSON.stringify({ ...file, sha256 });
  writeFileSync(at('slow.json'), sealed(createHash('sha256').update(sealed('')).digest('hex')));
  const { code, stderr } = await kerfway('verify', at('slow.json'), at('plate.dxf'));
  assert.equal(code, 1);
  assert.match(stderr, /slow\.json proves nothing: The certificate has more legs between knots than are checked\.\n$/);
});

it('work on the bound does not change the plan', async (t) => {
  const at = workshop(t);
  const plan = async (...more) => {
    const { code, stdout } = await kerfway('plan', at('plate.dxf'), '--moves', '20000', '--seed', '1', '--json', '-', ...more);
    assert.equal(code, 0);
    const { lower_bound, gap, ...summary } = JSON.parse(stdout).summary;
    return { bound: lower_bound, rest: { ...JSON.parse(stdout), summary } };
  };
  const [alone, beside] = [await plan(), await plan('--bound-work', '20')];
  assert.deepEqual(beside.rest, alone.rest);
  assert.ok(beside.bound >= alone.bound && beside.bound > 0);
});

it('a better path of the proof becomes the plan of a search by time, but not that of another method', async (t) => {
  const at = workshop(t);
  const plan = async (...more) => {
    const { code, stdout, stderr } = await kerfway('plan', at('plate.dxf'), '--seed', '1', '--json', '-', ...more);
    assert.equal(code, 0, stderr);
    return JSON.parse(stdout);
  };
  // The search has hardly begun.
  const short = ['--seconds', '0.001'];
  const [alone, proven, other] = [await plan(...short), await plan(...short, '--bound-work', '2000'), await plan(...short, '--bound-work', '2000', '--method', 'greedy')];
  assert.ok(proven.summary.total_time < other.summary.total_time && proven.summary.gap <= 1e-6, JSON.stringify(proven.summary));
  assert.ok(proven.summary.total_time <= alone.summary.total_time);
  assert.deepEqual([other.budget.from_path, other.method], [undefined, 'greedy']);
});

it('another drawing, another machine, a changed number and what is no certificate are refused', async (t) => {
  const at = workshop(t);
  await certified(at);
  writeFileSync(at('other.dxf'), dxf(circle(10, 10, 5), circle(40, 10, 5)));
  const refused = async (why, ...args) => {
    const { code, stdout, stderr } = await kerfway('verify', ...args);
    assert.deepEqual([code, stdout], [1, ''], stderr);
    assert.match(stderr, why);
  };
  const file = at('plate.certificate.json');
  await refused(/plate\.certificate\.json proves nothing: The certificate is for another drawing: plate\.dxf with the SHA-256 [0-9a-f]{64}\.\n$/, file, at('other.dxf'));
  await refused(/The certificate is for the machine co2-100w, not for length\.\n$/, file, '--machine', 'length');
  const changed = readFileSync(file, 'utf8').replace(/"bound":(\d+)/, (_, bound) => `"bound":${Number(bound) + 1}`);
  writeFileSync(at('changed.json'), changed);
  await refused(/The certificate was changed after it was written: its own hash does not fit it\.\n$/, at('changed.json'), at('plate.dxf'));
  await refused(/This is a document of the kind kerfway\.plan\/1, not kerfway\.certificate\/1\.\n$/, at('plate.json'), at('plate.dxf'));
  await refused(/missing\.json cannot be read: there is no such file/, at('missing.json'));
  assert.equal((await kerfway('verify', file, '--machine', 'co2-100w')).code, 0);
  assert.equal((await kerfway('verify', file, at('plate.dxf'), at('other.dxf'))).code, 2);
});

it('a job without certificates says why', async (t) => {
  const at = workshop(t);
  writeFileSync(at('one.dxf'), dxf(circle(10, 10, 5)));
  const { code, stderr } = await kerfway('plan', at('one.dxf'), '--moves', '0', '--certificate', at('one.json'));
  assert.equal(code, 1);
  assert.match(stderr, /There is no certificate: Certificates are not written for fewer than two contours\./);
  assert.equal((await kerfway('plan', at('plate.dxf'), '--bound', '-1')).code, 2);
});

it('a certificate whose drawing has a damaged name ended in an error of the engine', async (t) => {
  const at = workshop(t);
  for (const name of ['\\q', 'a\nb']) {
    writeFileSync(at('a.json'), `{"schema":"kerfway.certificate/1","drawing":{"name":"${name}"}}`);
    const { code, stderr } = await kerfway('verify', at('a.json'));
    assert.deepEqual([code, stderr], [1, `kerfway: ${at('a.json')} names no drawing: either it is no certificate, or give its drawing after it.\n`]);
  }
});

it('a certificate of a project was said to be for another drawing when it was verified with that project', async (t) => {
  const at = workshop(t);
  const project = await writeProject({ name: 'plate.dxf', drawing: readFileSync(at('plate.dxf')), reading: {}, planning: {}, plan: null });
  mkdirSync(at('saved'));
  writeFileSync(at('saved/plate.kerfway'), project);
  const planned = await kerfway('plan', at('saved/plate.kerfway'), '--moves', '1000', '--seed', '1', '--bound-work', '5', '--certificate', at('saved/plate.json'));
  assert.equal(planned.code, 0, planned.stderr);
  for (const drawing of [at('saved/plate.kerfway'), at('plate.dxf')]) {
    const { code, stdout, stderr } = await kerfway('verify', at('saved/plate.json'), drawing);
    assert.equal(code, 0, stderr);
    assert.match(stdout, /^Proven: no plan of plate\.dxf on co2-100w takes less than /);
  }
});
