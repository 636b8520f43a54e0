// `kerfway check`, and the dialect, LightBurn and Ruida outputs of `kerfway plan`.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { createPlanner } from 'kerfway';
import { circle, dxf, fixture, folder, kerfway, square } from './support.mjs';

const PLAN = ['--moves', '0', '--seed', '1', '--quiet'];

/** A folder with a drawing, and the path of a file in it. */
function workshop(t) {
  const at = folder(t);
  writeFileSync(join(at, 'plate.dxf'), dxf(square(10, 10, 40), circle(30, 30, 5)));
  return (name) => join(at, name);
}

it('a program passes its check, and a broken one fails with exit code 1', async (t) => {
  const at = workshop(t);
  assert.equal((await kerfway('plan', at('plate.dxf'), '--gcode', at('plate.nc'), ...PLAN)).code, 0);
  const passed = await kerfway('check', at('plate.nc'));
  assert.equal(passed.code, 0, passed.stderr);
  assert.match(passed.stdout, /^plate\.nc: passes, read as grbl-m4 on co2-100w\nContours   2 contours, each cut once; 1 part, 2 piercings\n/);
  assert.match(passed.stdout, /Beam       off on every rapid\n/);
  assert.match(passed.stdout, /on the bed/);

  writeFileSync(at('broken.nc'), readFileSync(at('plate.nc'), 'utf8').replace('M5 S0\nG0 X0 Y0\n; checksum', 'G0 X0 Y0\n; checksum'));
  const broken = await kerfway('check', at('broken.nc'), '--json', at('broken.json'));
  assert.equal(broken.code, 1);
  assert.match(broken.stderr, /broken\.nc fails: /);
  const report = JSON.parse(readFileSync(at('broken.json'), 'utf8'));
  assert.equal(report.passed, false);
  assert.ok(report.problems.some((p) => p.code === 'beam-on-at-end'), JSON.stringify(report.problems));
  const both = await kerfway('check', at('plate.nc'), at('broken.nc'));
  assert.equal(both.code, 4);
});

/** A second document followed, which said that the file could not be read. */
it('a program that fails has one JSON document on standard output', async (t) => {
  const at = workshop(t);
  assert.equal((await kerfway('plan', at('plate.dxf'), '--gcode', at('plate.nc'), ...PLAN)).code, 0);
  const program = readFileSync(at('plate.nc'), 'utf8');
  writeFileSync(at('changed.nc'), program.replace('\nM5', '\nM6\nM5'));
  const { code, stdout, stderr } = await kerfway('check', at('changed.nc'), '--json', '-');
  assert.equal(code, 1);
  const documents = stdout.trim().split('\n').map((line) => JSON.parse(line));
  assert.deepEqual(documents.map((d) => [d.name, d.passed, d.problems?.map((p) => p.code)]), [['changed.nc', false, ['changed']]]);
  assert.match(stderr, /changed\.nc fails: The program is not as Kerfway wrote it: lines were changed, added or removed since\. Write it again; if that was on purpose, delete the first line and the line with the checksum, and check the program once more\.\n/);
});

it('a program off the bed fails', async (t) => {
  const at = workshop(t);
  writeFileSync(at('far.nc'), 'G21 G90\nM4 S0\nG0 X-50 Y0\nG1 X-40 S500 F600\nG0 X0 Y0 S0\nM5\nM2\n');
  const { code, stderr } = await kerfway('check', at('far.nc'));
  assert.equal(code, 1);
  assert.match(stderr, /far\.nc fails: The head leaves the bed/);
});

it('--dialect takes a shipped name or a file of one\'s own', async (t) => {
  const at = workshop(t);
  const linux = await kerfway('plan', at('plate.dxf'), '--gcode', at('plate.ngc'), '--dialect', 'linuxcnc-m67', ...PLAN);
  assert.equal(linux.code, 0, linux.stderr);
  assert.match(readFileSync(at('plate.ngc'), 'utf8'), /M68 E0 Q850\nG4 P0\.105\n/);
  assert.equal((await kerfway('check', at('plate.ngc'), '--dialect', 'linuxcnc-m67')).code, 0);

  const shipped = JSON.parse(readFileSync(new URL('../../src/machine/dialect/shipped/marlin-inline.json', import.meta.url), 'utf8'));
  writeFileSync(at('mine.json'), JSON.stringify({ ...shipped, name: 'mine', chords: 0.02 }));
  assert.equal((await kerfway('plan', at('plate.dxf'), '--gcode', at('mine.gcode'), '--dialect', at('mine.json'), ...PLAN)).code, 0);
  const mine = readFileSync(at('mine.gcode'), 'utf8');
  assert.doesNotMatch(mine, /^G[23] /m);
  assert.match(mine, /^G4 P105$/m);

  writeFileSync(at('wrong.json'), JSON.stringify({ ...shipped, rapid_dark: true }));
  const wrong = await kerfway('plan', at('plate.dxf'), '--gcode', '-', '--dialect', at('wrong.json'), ...PLAN);
  assert.equal(wrong.code, 1);
  assert.match(wrong.stderr, /wrong\.json: The dialect has no field "rapid_dark"\. Did you mean "rapids_dark"\?/);
  const unknown = await kerfway('plan', at('plate.dxf'), '--gcode', '-', '--dialect', 'marlin', ...PLAN);
  assert.equal(unknown.code, 2);
  assert.match(unknown.stderr, /--dialect marlin: choose one of grbl-m4, .*template, or name a file ending in \.json\./);
});

it('LightBurn projects and Ruida files are written', async (t) => {
  const at = workshop(t);
  const { code, stderr } = await kerfway('plan', at('plate.dxf'), '--lbrn2', at('plate.lbrn2'), '--rd', at('plate.rd'), ...PLAN);
  assert.equal(code, 0, stderr);
  assert.match(readFileSync(at('plate.lbrn2'), 'utf8'), /<LightBurnProject/);
  // The scrambled D8 10: absolute coordinates from the machine's zero.
  assert.deepEqual([...readFileSync(at('plate.rd')).subarray(0, 2)], [0xd2, 0x99]);
});

it('nothing is written for a dialect that cannot do what the plan asks', async (t) => {
  const at = workshop(t);
  const { code, stderr } = await kerfway('plan', at('plate.dxf'), '--gcode', at('plate.nc'), '--dialect', 'marlin-fan', '--joints', '2', '--joint-kind', 'flying', ...PLAN);
  assert.equal(code, 1);
  assert.match(stderr, /\(dialect "marlin-fan"\) switches the beam only at rest, so it cannot leave flying joints/);
  assert.equal(existsSync(at('plate.nc')), false);
});

it('a head that is lifted for air moves stays down over micro-joints, and the program passes the check that it is written with', async (t) => {
  const at = workshop(t);
  const lifted = ['--lift', '10', '--z-speed', '10', '--joints', '2', '--gcode', at('lifted.nc'), ...PLAN];
  const { code, stderr } = await kerfway('plan', fixture('plate/one-kerf-apart.dxf'), ...lifted);
  assert.equal(code, 0, stderr);
  assert.match(readFileSync(at('lifted.nc'), 'utf8'), /^G0 X\S+ Y\S+ Z10$/m);
});

it('marks are timed with their own acceleration', async (t) => {
  const at = workshop(t);
  const planner = await createPlanner();
  t.after(() => planner.close());
  const machine = planner.machines.find((m) => m.name === 'co2-100w');
  writeFileSync(at('slow.json'), JSON.stringify({ ...machine, mark: { ...machine.mark, accel: 100 } }));
  writeFileSync(at('marks.dxf'), dxf(...Array.from({ length: 40 }, (_, k) => square(10 + 8 * k, 10, 5, 'MARK'))));
  const { code, stderr } = await kerfway('plan', at('marks.dxf'), '--layer', 'MARK=mark', '--machine', at('slow.json'), '--gcode', at('marks.nc'), ...PLAN);
  assert.equal(code, 0, stderr);
});

it('what follows the end of a program, and a head that is moved up or down with the beam on, fail', async (t) => {
  const at = workshop(t);
  assert.equal((await kerfway('plan', at('plate.dxf'), '--gcode', at('plate.ngc'), '--dialect', 'linuxcnc-m67', ...PLAN)).code, 0);
  const lines = readFileSync(at('plate.ngc'), 'utf8').split('\n');
  const first = lines.findIndex((line) => /^G[123] X/.test(line));
  for (const [name, more, wanted] of [
    ['ended.ngc', 'M2', new RegExp(`Line ${first + 3} comes after the end of the program in line ${first + 2}`)],
    ['deep.ngc', 'G1 Z-20', /to another height with the beam on/],
  ]) {
    writeFileSync(at(name), [...lines.slice(0, first + 1), more, ...lines.slice(first + 1)].join('\n'));
    const { code, stderr } = await kerfway('check', at(name), '--dialect', 'linuxcnc-m67');
    assert.equal(code, 1);
    assert.match(stderr, wanted);
  }
});

it('where rapids have a feed, the head is lifted with the speed of its axis', async (t) => {
  const at = workshop(t);
  const { code, stderr } = await kerfway('plan', at('plate.dxf'), '--dialect', 'marlin-fan', '--lift', '5', '--lift-at-rest', '--z-speed', '10', '--gcode', at('plate.gcode'), ...PLAN);
  assert.equal(code, 0, stderr);
  let feed = null;
  const feeds = { z: new Set(), xy: new Set() };
  for (const line of readFileSync(at('plate.gcode'), 'utf8').split('\n').filter((line) => /^G[0123] /.test(line))) {
    feed = / F(\S+)/.exec(line)?.[1] ?? feed;
    if (/^G0 Z/.test(line)) feeds.z.add(feed);
    else if (line.startsWith('G0 ')) feeds.xy.add(feed);
  }
  assert.deepEqual({ z: [...feeds.z], xy: [...feeds.xy] }, { z: ['600'], xy: ['24000'] });
});
