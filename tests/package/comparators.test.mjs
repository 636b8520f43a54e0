// Programs of others in the benchmark: what they write is read, and one that is not installed is skipped by name.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { HERE } from '../../benchmark/instances.mjs';

const python = spawnSync('python3', ['-c', 'import sys; print(sys.executable)'], { encoding: 'utf8' });
const NEEDS_PYTHON = { skip: python.status !== 0 && 'there is no Python' };
const FIXTURES = fileURLToPath(new URL('../fixtures/benchmark/', import.meta.url));

/** A folder with one program in it, a shell script, and the environment in which it is the only one that is found beside Python. */
function installed(t, name, script) {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  t.after(() => rmSync(folder, { recursive: true }));
  if (name) {
    writeFileSync(join(folder, name), `#!/bin/sh\n${script}\n`);
    chmodSync(join(folder, name), 0o755);
  }
  return { folder, env: { ...process.env, PATH: [folder, dirname(python.stdout.trim()), '/usr/bin', '/bin'].join(delimiter) } };
}

function run(t, { env }, args, input) {
  const { stdout, stderr, status } = spawnSync(python.stdout.trim(), args, { encoding: 'utf8', env, input });
  return { stdout, stderr, status };
}

/** What a few lines of Python print that see the modules of the benchmark. */
const calls = (lines) => ['-c', `import sys, json; sys.path.insert(0, ${JSON.stringify(HERE)})\n${lines}`];

const CONTOURS = [
  { closed: true, inside: null, start: [10, 60], path: [{ line: [30, 60] }, { line: [30, 80] }, { line: [10, 80] }, { line: [10, 60] }] },
  { closed: true, inside: null, start: [70, 70], path: [{ arc: [70, 70], center: [65, 70], ccw: false }] },
  { closed: false, inside: null, start: [40, 20], path: [{ line: [20, 20] }, { arc: [10, 10], center: [20, 10], ccw: true }] },
];
const INSTANCE = { track: 'CCP', home: [0, 0], closed: true, cost: { unit: 'mm', pierce: 0 }, contours: CONTOURS };

describe('programs of others in the benchmark', NEEDS_PYTHON, () => {
  it('svg2gcode: a program of version 0.0.19 becomes a plan, with an open contour cut from its end', (t) => {
    // The shell script answers as svg2gcode does, and prints the program that it wrote for this drawing.
    const answers = `case "$1" in --version) echo svg2gcode 0.0.19;; --help) echo --optimize-path-order;; *) cat ${FIXTURES}svg2gcode.nc;; esac`;
    const found = run(t, installed(t, 'svg2gcode', answers), calls(`
import check, compare
instance = json.load(sys.stdin)
moves = compare.by_svg2gcode(instance)
print(json.dumps([moves[0]["to"], moves[2]["path"], check.check(instance, {"moves": moves})]))`), JSON.stringify(INSTANCE));
    assert.equal(found.status, 0, found.stderr);
    const [first, path, value] = JSON.parse(found.stdout);
    assert.deepEqual(first, [10, 10]);
    assert.deepEqual(path, [{ arc: [20, 20], center: [20, 10], ccw: false }, { line: [40, 20] }]);
    // From home to the open contour, to the square, to the disc, home.
    const air = [[0, 0, 10, 10], [40, 20, 10, 60], [10, 60, 70, 70], [70, 70, 0, 0]].map(([a, b, c, d]) => Math.hypot(c - a, d - b));
    assert.ok(Math.abs(value - air.reduce((x, y) => x + y)) < 1e-9, value);
  });

  it('svg2gcode: a program that leaves a contour out, or cuts another, is no plan', (t) => {
    const program = readFileSync(join(FIXTURES, 'svg2gcode.nc'), 'utf8');
    const whole = calls(`
import check, svg2gcode
contours, program = json.load(sys.stdin)
svg2gcode.visits([check.Contour(c) for c in contours], program)`);
    const said = (text) => run(t, installed(t), whole, JSON.stringify([CONTOURS, text])).stderr;
    assert.equal(said(program), '');
    assert.match(said(program.slice(0, program.lastIndexOf('G0'))), /does not cut 1 contours/);
    assert.match(said(program.replaceAll('X0 Y70', 'X0 Y69')), /which is no contour that is still uncut/);
  });

  it('GLNS: it is started as its README says, and its tour file is read', (t) => {
    // The shell script stands for Julia: it notes how it was started, and writes the sample where it was told to.
    const julia = installed(t, 'julia', `printf '%s\\n' "$@" >> "$(dirname "$0")/said"; [ "$3" = -- ] && cp ${FIXTURES}glns-tour.txt "$5"; exit 0`);
    const found = run(t, julia, calls(`
import check, glns
tour = glns.tour("/data/31pr152.gtsp", 7.5) if glns.is_installed() else None
print(check.check(check.instance_of("31pr152")[0], {"tour": tour}))`));
    assert.equal(found.status, 0, found.stderr);
    assert.equal(Number(found.stdout), 51576);
    const said = readFileSync(join(julia.folder, 'said'), 'utf8').split('\n');
    assert.match(said[1], /find_package\("GLNS"\)/);
    assert.match(said[3], /^import GLNS; GLNS\.solver\(ARGS\[1\]; output=ARGS\[2\], max_time=parse\(Int, ARGS\[3\]\), trials=100000, verbose=0\)$/);
    assert.deepEqual([said[5], said[7]], ['/data/31pr152.gtsp', '7']);
  });

  it('GLNS: a file without a tour is refused', (t) => {
    const { stderr } = run(t, installed(t), calls(`import glns; glns.read_tour("Tour Cost : 5")`));
    assert.match(stderr, /the tour file of GLNS has no line Tour/);
  });

  it('a plan that is wrong ended the comparison with a stack trace', (t) => {
    const julia = installed(t, 'julia', `[ "$3" = -- ] && sed 's/\\[5, 12/[5, 5/' ${FIXTURES}glns-tour.txt > "$5"; exit 0`);
    const found = run(t, julia, [join(HERE, 'compare.py'), join(julia.folder, 'out'), '--only', 'pr152', '--by', 'glns', '--seconds', '1']);
    assert.deepEqual([found.status, found.stderr], [0, '']);
    assert.match(found.stdout, /^31pr152 +glns +WRONG {2}visited-twice: set \d+ is visited more than once\n$/);
  });

  it('a program that is not installed is skipped by name, with how to get it', (t) => {
    const bare = installed(t);
    const by = (name) => run(t, bare, [join(HERE, 'compare.py'), join(bare.folder, 'out'), '--only', 'hull-5-20-1-ecp', '--by', name]).stdout;
    assert.equal(by('svg2gcode'), 'svg2gcode: skipped, because it is not installed; to get it: cargo install svg2gcode-cli, 0.0.19 or later for its search\n');
    assert.match(by('glns'), /^glns: skipped, because it is not installed; to get it: install Julia from julialang\.org, then: julia -e .*\n$/);
    assert.match(by('nearest'), /^hull-5-20-1-ecp +nearest +\d+\.\d{3} +\+\d+\.\d{3} % above the best known\n/);
  });
});
