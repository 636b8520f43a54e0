// A plan may be a little beside its instance. The reference checker of the benchmark reads it as the exact plan beside it, so that nothing is
// gained by that, and nothing sound is refused.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { HERE, listed } from '../../benchmark/instances.mjs';
import { air, along, checked, instanceOf, NEEDS_PYTHON, outline, pierce } from './reference-checker.mjs';

const value = (t, instance, moves) => checked(t, instance, { moves }).text;
const slot = outline([5, 0], [10, 0]);
/** Closed; its last side comes from where the head starts. */
const wedge = outline([10, 0], [20, 0], [20, 10], [5, 0], [10, 0]);
const square = outline([20, 0], [30, 0], [30, 10], [20, 10], [20, 0]);

describe('the reference checker, of plans a hair beside their instances', NEEDS_PYTHON, () => {
  for (const [track, end] of [['CCP', 9.9981], ['ICP', 9.9981], ['ECP', 9.9991]]) {
    it(`gives nothing for a contour of ${track} that is left a hair before it is closed`, (t) => {
      const instance = { ...instanceOf(track, wedge), closed: true };
      const moves = [air(10, 0), pierce, along([20, 0], [20, 10], [5, 0], [end, 0]), air(0, 0)];
      assert.equal(value(t, instance, moves), '25.000000');
    });
  }

  it('gives nothing for two cuts with a hair between them', (t) => {
    const moves = (gap) => [air(5, 0), pierce, along([7, 0]), air(8, 0), air(7 + gap, 0), along([10, 0])];
    for (const gap of [0, 0.0019, -0.0019]) assert.equal(value(t, instanceOf('ICP', slot), moves(gap)), '12.000000');
  });

  it('charges the way between two contours that are a hair apart', (t) => {
    const instance = instanceOf('CCP', outline([0, 0], [10, 0]), outline([10.0018, 0], [20, 0]));
    assert.equal(value(t, instance, [pierce, along([10.0009, 0]), pierce, along([20, 0])]), '10.001800');
  });

  it('rejects a straight cut across a bump that is shorter than the distance of its samples', (t) => {
    const bump = { arc: [5.47, 0], center: [5.245, -1.397], ccw: false };
    const instance = instanceOf('CCP', { start: [0, 0], closed: false, inside: null, path: [{ line: [5.02, 0] }, bump, { line: [10, 0] }] });
    assert.match(value(t, instance, [pierce, along([10, 0])]), /^WRONG {2}off-contour: move 1 /);
    assert.equal(value(t, instance, [pierce, { kind: 'cut', path: instance.contours[0].path }]), '5.000000');
  });

  it('accepts a cut that ends nowhere more than 0.002 mm from its contour, also beyond the end of an open one', (t) => {
    assert.equal(value(t, instanceOf('CCP', slot), [air(5, 0), pierce, along([10.0015, 0])]), '10.000000');
    assert.match(value(t, instanceOf('CCP', slot), [air(5, 0), pierce, along([10.0025, 0])]), /^WRONG {2}off-contour/);
  });

  it('accepts a start that is 0.0009 mm beside a corner, along the side that the cut leaves from', (t) => {
    const corner = outline([340, 473.1], [136.9, 617.4], [162, 231.1], [327.9, 301.1], [340, 473.1]);
    const moves = [air(162, 231.1009), pierce, along([327.9, 301.1], [340, 473.1], [136.9, 617.4], [162, 231.1])];
    assert.ok(Math.abs(Number(value(t, instanceOf('ECP', corner), moves)) - Math.hypot(162, 231.1) - 5) < 1e-5);
  });

  it('goes on without a piercing at the end of a cut, on whichever of two contours that lie on each other it is', (t) => {
    const halves = [along([27, 0]), along([30, 0], [30, 10], [25, 10]), along([20, 10], [20, 0]), along([30, 0], [30, 10], [20, 10], [20, 0])];
    const moves = [air(20, 0), pierce, halves[0], air(20, 0), pierce, halves[1], halves[2], air(27, 0), halves[3]];
    assert.equal(value(t, instanceOf('ICP', square, square), moves), '44.000000');
  });

  it('finds the contour whose corner it is, where two circles lie on each other', (t) => {
    const circle = (start) => ({ start, closed: true, inside: null, path: [{ arc: start, center: [40, 0], ccw: true }] });
    const instance = instanceOf('ECP', circle([44, 0]), circle([40, 4]));
    const cut = (x, y) => [air(x, y), pierce, { kind: 'cut', path: circle([x, y]).path }];
    assert.equal(Number(value(t, instance, [...cut(40, 4), ...cut(44, 0)])).toFixed(4), (10 + Math.hypot(40, 4) + Math.hypot(4, 4)).toFixed(4));
  });

  it('says of an outer contour that is never cut that it is not cut', (t) => {
    const inner = { ...outline([22, 2], [24, 2], [24, 4], [22, 2]), inside: 1 };
    const moves = [air(22, 2), pierce, along([24, 2], [24, 4], [22, 2])];
    assert.match(value(t, instanceOf('CCP', inner, square), moves), /^WRONG {2}not-cut: contour 1 /);
  });

  it('rejects a line of a million kilometres at once', (t) => {
    const moves = [air(5, 0), pierce, along([1e9, 0])];
    assert.match(value(t, instanceOf('CCP', slot), moves), /^WRONG {2}off-contour: move 2 /);
  });

  it('names what is wrong with lists that are nested deeper than Python can print', () => {
    // Each depth up to the one that Python cannot read; what is wrong is told by names, so that any other exception ends the program.
    const { stdout, stderr } = spawnSync('python3', ['-c', `
import json, check
instance = json.loads(${JSON.stringify(JSON.stringify(instanceOf('CCP', slot)))})
for depth in range(100, 100_000):
    try:
        plan = json.loads('{"moves": [{"kind": "air", "to": ' + "[" * depth + "]" * depth + "}]}")
    except RecursionError:
        break
    try:
        check.check(instance, plan)
    except check.Wrong as wrong:
        said = str(wrong)
print(said)`], { cwd: HERE, encoding: 'utf8' });
    assert.match(stdout, /^not-a-plan: move 0 /, stderr);
  });

  it('refuses, with exit code 2, an instance that is none', (t) => {
    const none = [outline([0, 0]), { ...slot, closed: true }, { ...slot, inside: 1 }, outline([0, 0], [0.001, 0])];
    for (const contour of none) {
      const { stderr, status } = checked(t, instanceOf('CCP', contour), { moves: [] });
      assert.equal(status, 2, JSON.stringify(contour));
      assert.match(stderr, /^check\.py: [^\n]+ is not an instance: [^\n]+\.\n$/);
    }
  });

  it('checks the other plans of a folder where the file of one instance is missing', (t) => {
    // As in the folder of the site, which has no files of GTSPLIB.
    const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
    t.after(() => rmSync(folder, { recursive: true }));
    for (const part of ['check.py', 'rules.py', 'instances.json']) cpSync(join(HERE, part), join(folder, part));
    for (const name of ['31pr152', 'sheet-100-ccp']) {
      for (const part of ['best', 'instances']) {
        const file = join(part, `${name}.json.gz`);
        if (existsSync(join(HERE, file))) cpSync(join(HERE, file), join(folder, file));
      }
    }
    const { stdout, status } = spawnSync('python3', ['check.py', 'best'], { cwd: folder, encoding: 'utf8' });
    assert.equal(status, 2);
    const [missing, sheet] = stdout.trim().split('\n');
    assert.match(missing, /^31pr152 +not checked: .* cannot be read: /);
    assert.match(sheet, /^sheet-100-ccp +2734\.897 /);
  });

  it('takes a file of GTSPLIB as an instance', () => {
    const { file, best } = listed().instances.find((entry) => entry.name === '31pr152');
    const { stdout } = spawnSync('python3', ['check.py', file, best.plan], { cwd: HERE, encoding: 'utf8' });
    assert.equal(Number(stdout), best.value);
    assert.equal(spawnSync('python3', ['check.py', join('..', 'README.md'), best.plan], { cwd: HERE }).status, 2);
  });
});
