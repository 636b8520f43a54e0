// Names on the command line: outputs that are the same file as another output or an input, and names that could control a terminal.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, linkSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { visible, visibleText } from '../../dist/sdk/cli/safe-text.js';
import { circle, CLI, dxf, folder, kerfway, square } from './support.mjs';

const QUICK = ['--moves', '5', '--seed', '1'];
const POSIX = { skip: process.platform === 'win32' && 'links need a right there, and names hold no control characters' };

/** A folder with a drawing, a machine, an instance, a program, and names of all kinds for them. */
function place(t) {
  const at = folder(t);
  writeFileSync(join(at, 'a.dxf'), dxf(square(0, 0, 24)));
  writeFileSync(join(at, 'b.dxf'), dxf(square(0, 0, 20)));
  writeFileSync(join(at, 'a.tsp'), 'NAME: t\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 0 9\n3 9 9\n4 9 0\nEOF\n');
  writeFileSync(join(at, 'mine.json'), '{}');
  writeFileSync(join(at, 'x.nc'), 'old');
  mkdirSync(join(at, 'sub'));
  mkdirSync(join(at, 'out'));
  symlinkSync('x.nc', join(at, 'soft'));
  linkSync(join(at, 'x.nc'), join(at, 'hard'));
  symlinkSync('new.nc', join(at, 'dangling'));
  symlinkSync('.', join(at, 'same'));
  symlinkSync('a.dxf', join(at, 'soft.dxf'));
  linkSync(join(at, 'a.dxf'), join(at, 'hard.dxf'));
  return at;
}

describe('an output that is another file of the same run is wrong usage, and nothing is written', POSIX, () => {
  const outputs = [
    ['x.nc', 'x.nc'], ['x.nc', './x.nc'], ['x.nc', 'sub/../x.nc'], ['x.nc', 'same/x.nc'], ['x.nc', 'soft'], ['soft', 'x.nc'], ['x.nc', 'hard'],
    ['y.nc', './y.nc'], ['y.nc', 'same/y.nc'], ['new.nc', 'dangling'], ['later/y', 'later/../later/y'],
  ];
  const inputs = [
    ['plan', 'a.dxf', ...QUICK, '--dxf', 'a.dxf'], ['plan', 'a.dxf', ...QUICK, '--dxf', 'sub/../a.dxf'], ['plan', 'a.dxf', ...QUICK, '--svg', 'soft.dxf'],
    ['plan', 'a.dxf', ...QUICK, '--gcode', 'hard.dxf'], ['plan', 'soft.dxf', ...QUICK, '--gcode', 'a.dxf'], ['plan', 'a.dxf', ...QUICK, '--dxf', '.'],
    ['quote', 'a.dxf', ...QUICK, '--json', 'same/a.dxf'], ['inspect', 'a.dxf', '--json', 'hard.dxf'], ['solve', 'a.tsp', ...QUICK, '--json', 'same/a.tsp'],
    ['plan', 'a.dxf', 'b.dxf', ...QUICK, '--dxf', './'],
  ];
  const run = (at, args) => spawnSync(process.execPath, [CLI, ...args], { cwd: at, encoding: 'utf8' });
  const refused = (at, args, sentence) => {
    const files = () => readdirSync(at, { recursive: true }).filter((f) => !f.startsWith('same')).sort();
    const contents = () => files().map((f) => [f, existsSync(join(at, f)) && /\.|soft|hard/.test(f) ? readFileSync(join(at, f), 'latin1') : null]);
    const before = contents();
    const { status, stdout, stderr } = run(at, args);
    assert.deepEqual([status, stdout], [2, ''], `${args.join(' ')}: ${stderr}`);
    assert.match(stderr, sentence);
    assert.deepEqual(contents(), before, args.join(' '));
  };

  for (const [gcode, svg] of outputs) {
    it(`--gcode ${gcode} --svg ${svg}`, (t) => {
      refused(place(t), ['plan', 'a.dxf', ...QUICK, '--gcode', gcode, '--svg', svg], /^kerfway: --(svg|gcode) \S+ is the same file as --(svg|gcode) \S+\. Name another file or folder\.\nRun/);
    });
  }

  for (const args of inputs) {
    it(args.filter((a) => !QUICK.includes(a)).join(' '), (t) => refused(place(t), args, /is the same file as \S+, which is read\. Name another/));
  }

  it('of an output named twice, and of two choices for one layer or contour, the first one was left out without a word', (t) => {
    const at = place(t);
    const wrong = {
      '--gcode a.nc --gcode b.nc': /^kerfway: --gcode a\.nc and --gcode b\.nc: give one of them\.$/m,
      '--layer 0=cut,speed=5 --layer 0=cut,power=0.5': /^kerfway: --layer 0=cut,speed=5 and --layer 0=cut,power=0\.5: write all that is chosen for 0 in one of them\.$/m,
      '--lead-of 0=arc --lead-of 0=line': /write all that is chosen for 0 in one of them/,
      '--method pso --set rounds=1 --set rounds=2': /write all that is chosen for rounds in one of them/,
    };
    for (const [options, sentence] of Object.entries(wrong)) refused(at, ['plan', 'a.dxf', ...QUICK, ...options.split(' ')], sentence);
    const twice = ['--quiet', '--quiet', '--machine', 'length', '--machine', 'k40', '--svg', '/dev/null', '--svg', '/dev/null', '--layer', '0=cut', '--layer', '0=cut', '--joints-of', '0=1', '--lead-of', '0=arc'];
    assert.equal(run(at, ['plan', 'a.dxf', ...QUICK, ...twice]).status, 0);
  });

  it('a file whose name begins with a dash was an unknown option, without a word on how it is written', (t) => {
    const at = place(t);
    writeFileSync(join(at, '-a.dxf'), dxf(circle(0, 0, 5)));
    refused(at, ['plan', '-a.dxf', ...QUICK], /^kerfway: kerfway plan has no option -a\. The file of this name is written \.\/-a\.dxf\.$/m);
    assert.equal(run(at, ['plan', './-a.dxf', ...QUICK]).status, 0);
  });

  it('a file named -h showed the help, although it followed --', (t) => {
    const at = place(t);
    for (const name of ['-h', '--help']) {
      writeFileSync(join(at, name), dxf(circle(0, 0, 5)));
      assert.match(run(at, ['inspect', '--', name]).stdout, new RegExp(`^${name}, 10\\.0 x 10\\.0 mm\\n`));
      assert.match(run(at, ['inspect', name, '--', name]).stdout, /^kerfway inspect: describe the drawing/);
    }
  });

  it('a machine file counts as an input', (t) => {
    const at = place(t);
    const { machine } = JSON.parse(run(at, ['plan', 'a.dxf', ...QUICK, '--json', '-']).stdout);
    writeFileSync(join(at, 'mine.json'), JSON.stringify(machine));
    refused(at, ['plan', 'a.dxf', ...QUICK, '--machine', 'mine.json', '--json', 'sub/../mine.json'], /--json sub\/\.\.\/mine\.json is the same file as mine\.json, which is read/);
  });

  it('a machine file with the name of a preset in it made plans for a machine without a name', (t) => {
    const at = place(t);
    for (const text of ['"k40"', '{"profile": "k40"}']) {
      writeFileSync(join(at, 'mine.json'), text);
      const { status, stderr } = run(at, ['plan', 'a.dxf', ...QUICK, '--machine', './mine.json']);
      assert.deepEqual([status, stderr], [1, 'kerfway: ./mine.json: The option "machine" is "k40". Give a machine profile.\n']);
    }
  });

  it('verify, quote and calibrate did not count their drawing, limits and machine as inputs, and overwrote them', (t) => {
    const at = place(t);
    writeFileSync(join(at, 'a.dxf'), dxf(square(0, 0, 24), circle(40, 12, 5), circle(60, 12, 7)));
    const planned = run(at, ['plan', 'a.dxf', ...QUICK, '--certificate', 'a.cert.json', '--json', 'plan.json']);
    assert.equal(planned.status, 0, planned.stderr);
    const { machine } = JSON.parse(readFileSync(join(at, 'plan.json'), 'utf8'));
    writeFileSync(join(at, 'mine.json'), JSON.stringify(machine));
    writeFileSync(join(at, 'limits.json'), '{"smallest_hole": 3}');
    for (const [args, read] of [
      [['verify', 'a.cert.json', 'a.dxf', '--json', 'hard.dxf'], 'a.dxf'],
      [['verify', 'a.cert.json', '--json', 'soft.dxf'], 'a.dxf'],
      [['verify', 'a.cert.json', 'a.dxf', '--machine', './mine.json', '--json', 'mine.json'], './mine.json'],
      [['quote', 'a.dxf', ...QUICK, '--limits', 'limits.json', '--json', 'sub/../limits.json'], 'limits.json'],
      [['quote', 'a.dxf', ...QUICK, '--limits', 'limits.json', '--machine', 'mine.json', '--json', './mine.json'], 'mine.json'],
      [['calibrate', 'plan.json=120', '--machine', 'mine.json', '--json', 'mine.json'], 'mine.json'],
    ]) {
      refused(at, args, new RegExp(`is the same file as ${read}, which is read\\. Name another`));
    }
  });

  it('two drawings with the same output name', (t) => {
    const at = place(t);
    writeFileSync(join(at, 'sub', 'a.dxf'), dxf(circle(0, 0, 5)));
    refused(at, ['plan', 'a.dxf', 'sub/a.dxf', ...QUICK, '--gcode', 'out/'], /--gcode out\/a\.nc for sub\/a\.dxf is the same file as --gcode out\/a\.nc for a\.dxf/);
  });

  it('standard output under two names', (t) => {
    const { status, stderr } = spawnSync('/bin/sh', ['-c', '"$@" --json - --gcode /dev/stdout | cat', 'sh', process.execPath, CLI, 'plan', join(place(t), 'a.dxf'), ...QUICK], { encoding: 'utf8' });
    assert.equal(status, 0, 'that of cat');
    assert.match(stderr, /--gcode \/dev\/stdout is the same file as --json -/);
  });

  it('different files are written, and /dev/null may be named twice', (t) => {
    const at = place(t);
    assert.equal(run(at, ['plan', 'a.dxf', ...QUICK, '--gcode', 'x.nc', '--svg', 'x.svg', '--json', '/dev/null', '--dxf', '/dev/null']).status, 0);
    assert.match(readFileSync(join(at, 'x.svg'), 'utf8'), /<svg/);
  });
});

const RAW = '\x1b[2J\x1b]0;owned\x07\u009b31m\u202egnp\u2066\x7f';
const CONTROLS = /[\u0000-\u0009\u000b-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/;

describe('names cannot control the terminal', POSIX, () => {
  it('control characters and direction marks are made visible, and other characters stay', () => {
    assert.equal(visible('a\x1b[31mb\r\n\t\x7f\u0085\u202e.dxf'), 'a\\u001b[31mb\\u000d\\u000a\\u0009\\u007f\\u0085\\u202e.dxf');
    for (const plain of ['Größe 3 mm².dxf', 'C:\\a b', '日本.dxf', 'ملف.dxf', '😀']) assert.equal(visible(plain), plain);
    assert.equal(visibleText('{"a":"\u009b"}\n'), '{"a":"\\u009b"}\n');
    assert.deepEqual(JSON.parse(visibleText('{"a":"\u009b\u202e"}\n')), { a: '\u009b\u202e' });
  });

  it('every command prints names of files, layers and texts of drawings visibly', async (t) => {
    const at = folder(t);
    const evil = join(at, `a${RAW}.dxf`);
    writeFileSync(evil, dxf(square(0, 0, 10, `layer${RAW}`), circle(50, 50, 4, `other${RAW}`), [[0, `TEXT${RAW}`], [8, `x${RAW}`], [1, RAW]]));
    const copy = join(at, 'copy.dxf');
    writeFileSync(copy, readFileSync(evil));
    const broken = join(at, `broken${RAW}\n.dxf`);
    writeFileSync(broken, 'AC1032\0\0');
    const tsp = join(at, `${RAW}.tsp`);
    writeFileSync(tsp, `NAME: ${RAW}\nTYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 0 9\n3 9 9\nEOF\n`);
    for (const args of [
      ['plan', evil, ...QUICK], ['quote', evil, ...QUICK], ['inspect', evil], ['solve', tsp, ...QUICK],
      ['plan', evil, copy, broken, ...QUICK], ['quote', evil, broken, ...QUICK], ['inspect', evil, copy, broken], ['inspect', evil, copy, '--json', `${at}/o/`],
      ['solve', broken, ...QUICK], ['plan', copy, ...QUICK, '--json', join(at, 'gone', RAW)], ['plan', copy, ...QUICK, '--machine', `./${RAW}`],
      ['plan', copy, '--units', RAW], [RAW], ['plan', copy, '--dxf', evil, '--svg', evil],
    ]) {
      const { stdout, stderr } = await kerfway(...args);
      assert.equal(CONTROLS.exec(stdout + stderr), null, `${args[0]}: ${JSON.stringify(stdout + stderr)}`);
      assert.match(stdout + stderr, /\\u001b/, `${args.map(visible).join(' ')}`);
    }
  });

  it('JSON is made visible on a terminal too, and is unchanged in a file', { skip: spawnSync('script', ['--version']).status !== 0 && 'there is no script(1)' }, async (t) => {
    const at = folder(t);
    const file = join(at, 'a.dxf');
    writeFileSync(file, dxf(square(0, 0, 24, 'layer\u009b31m\u202e')));
    const command = [process.execPath, CLI, 'inspect', file, '--json', '-'].join(' ');
    const { stdout } = spawnSync('script', ['-qec', command, '/dev/null'], { encoding: 'utf8' });
    assert.match(stdout, /layer\\u009b31m\\u202e/);
    assert.equal(JSON.parse(stdout).layers[0].name, JSON.parse((await kerfway('inspect', file, '--json', '-')).stdout).layers[0].name);
    assert.equal(CONTROLS.exec(stdout.replaceAll('\r', '')), null);
  });
});

describe('--watch', () => {
  it('reports once that a program is stale when a drawing is broken or gone, and resumes', async (t) => {
    const at = folder(t);
    const drawing = join(at, 'a.dxf');
    writeFileSync(drawing, dxf(square(0, 0, 24)));
    const child = spawn(process.execPath, [CLI, 'plan', join(at, '*.dxf'), ...QUICK, '--json', `${at}/out/`, '--watch'], { stdio: ['ignore', 'ignore', 'pipe'] });
    t.after(() => child.kill('SIGKILL'));
    let said = '';
    child.stderr.on('data', (d) => (said += d));
    const until = async (what) => {
      for (let k = 0; k < 600 && !what(); k++) await wait(50);
      assert.ok(what(), `${what} ${said}`);
    };
    const out = join(at, 'out', 'a.json');
    const contours = () => (existsSync(out) ? JSON.parse(readFileSync(out, 'utf8')).contours.length : 0);
    await until(() => contours() === 1);

    writeFileSync(drawing, 'AC1032\0\0');
    await until(() => said.includes('stale'));
    assert.match(said, /^kerfway: \S+a\.dxf: This is a DWG[^\n]*\nkerfway: \S+a\.dxf was not planned\. \S+out\/a\.json on the disk is from an earlier drawing, and stale\.\n$/);
    assert.equal(contours(), 1);

    said = '';
    rmSync(drawing);
    await until(() => said.includes('gone'));
    await wait(1000);
    assert.match(said, /^kerfway: \S+a\.dxf is gone\. \S+out\/a\.json on the disk is from an earlier drawing, and stale\. It is planned again when it comes back\.\n$/);

    said = '';
    writeFileSync(drawing, dxf(square(0, 0, 10), circle(50, 50, 5)));
    await until(() => contours() === 2);
    // Removed and restored unchanged.
    renameSync(drawing, join(at, 'away'));
    await until(() => said.includes('gone'));
    rmSync(out);
    renameSync(join(at, 'away'), drawing);
    await until(() => contours() === 2);
    assert.equal(said.match(/gone/g).length, 1);
  });
});
