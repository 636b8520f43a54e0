// The command line: outputs, options, exit codes and sentences.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, it } from 'node:test';
import { circle, dxf, fixture, folder, KEYBOARD, kerfway, ran, ROOT, square } from './support.mjs';

const ONE_PROCESS = join(ROOT, 'tests', 'package', 'one-process.mjs');
const PLAN = ['plan', fixture(KEYBOARD), '--moves', '2000', '--seed', '7', '--allow-off-bed'];

/** A file in a folder of its own. */
function file(t, name, content) {
  const path = join(folder(t), name);
  writeFileSync(path, content);
  return path;
}

describe('kerfway plan', () => {
  it('writes every requested output', async (t) => {
    const at = folder(t);
    const out = (kind) => join(at, `plan.${kind}`);
    const kinds = ['json', 'gcode', 'svg', 'dxf', 'png'];
    const { code, stdout } = await kerfway(...PLAN, ...kinds.flatMap((k) => [`--${k}`, out(k)]));
    assert.equal(code, 0);
    assert.match(stdout, /contours \(\d+ open\)/);
    assert.match(stdout, /seed 7/);
    const starts = { json: '{"schema":"kerfway.plan/1"', gcode: '; Kerfway', svg: '<svg', png: '\x89PNG' };
    for (const [kind, start] of Object.entries(starts)) {
      assert.ok(readFileSync(out(kind), 'latin1').startsWith(start), kind);
    }
    assert.match(readFileSync(out('dxf'), 'utf8'), /EOF\s*$/);
  });

  it('writes to standard output for -, and the summary to standard error', async () => {
    const { code, stdout, stderr } = await kerfway(...PLAN, '--json', '-');
    assert.equal(code, 0);
    const plan = JSON.parse(stdout);
    assert.deepEqual([plan.seed, plan.budget.moves], [7, 2000]);
    assert.match(stderr, /Job .*: cut/);
  });

  it('gives the same bytes for the same seed and moves', async () => {
    const [a, b] = await Promise.all([kerfway(...PLAN, '--json', '-'), kerfway(...PLAN, '--json', '-')]);
    assert.equal(a.stdout, b.stdout);
  });

  it('plans for a preset, a machine file, and without the return home', async (t) => {
    const { stdout } = await kerfway(...PLAN, '--machine', 'length', '--no-return', '--json', '-');
    const { machine, moves } = JSON.parse(stdout);
    assert.deepEqual([machine.name, machine.return_home], ['length', false]);
    assert.equal(moves.at(-1).kind, 'cut');

    const profile = { ...machine, name: 'mine', pierce_time: 2.5 };
    // The profile alone, and as the page exports it.
    for (const content of [profile, { schema: 'kerfway.machine/1', profile }]) {
      const own = file(t, 'mine.json', JSON.stringify(content));
      const second = JSON.parse((await kerfway(...PLAN, '--machine', own, '--json', '-')).stdout);
      assert.equal(second.machine.name, 'mine');
      assert.ok(Math.abs(second.summary.pierce_time - 2.5 * second.summary.pierces) < 1e-9);
    }
  });

  it('marks, cuts or ignores a layer, also one with = in its name', async (t) => {
    const drawing = file(t, 'layers.dxf', dxf(square(0, 0, 50), circle(20, 20, 5, 'a=b'), circle(80, 20, 5, 'text')));
    const layers = ['--layer', 'a=b=mark', '--layer', 'text=ignore'];
    const plan = JSON.parse((await kerfway('plan', drawing, '--moves', '9', ...layers, '--json', '-')).stdout);
    assert.deepEqual(plan.contours.map((c) => [c.layer, c.operation]), [['0', 'cut'], ['a=b', 'mark']]);
    assert.equal(plan.summary.pierces, 1);
  });

  it('uses the given units', async (t) => {
    const drawing = file(t, 'inch.dxf', dxf(square(0, 0, 10)));
    const plan = JSON.parse((await kerfway('plan', drawing, '--units', 'in', '--moves', '9', '--json', '-')).stdout);
    assert.deepEqual([plan.input.units, plan.input.units_source], ['in', 'given']);
    assert.ok(Math.abs(plan.summary.cut_length - 4 * 254) < 1e-9);
  });
});

describe('kerfway inspect', () => {
  it('reports units with their reason, layers, contours, parts, length, entities and findings', async (t) => {
    const drawing = file(t, 'plate.dxf', dxf(square(0, 0, 300), circle(50, 50, 10), [[0, 'TEXT'], [8, 'no'], [1, 'A4']]));
    const { code, stdout } = await kerfway('inspect', drawing, '--units', 'mm');
    assert.equal(code, 0);
    for (const words of [
      /^plate\.dxf.*300\.0 x 300\.0 mm/,
      /^Units +mm \(chosen by you\): ./m,
      /^Contours +2: 2 closed, 0 open$/m,
      /^Parts +1$/m,
      /^Length +1\.263 m to cut$/m,
      /^Entities +4 LINE, 1 CIRCLE, 1 TEXT \(not cut\)$/m,
      /^ {2}0: cut, 2 contours/m,
      /warning unsupported-entity.*layer no/,
    ]) {
      assert.match(stdout, words);
    }
  });

  it('writes its report as JSON', async () => {
    const { stdout } = await kerfway('inspect', fixture(KEYBOARD), '--json', '-');
    const report = JSON.parse(stdout);
    assert.equal(report.schema, 'kerfway.inspect/1');
    assert.equal(report.totals.closed + report.totals.open, report.contours.length);
    const cut = report.contours.filter((c) => c.operation === 'cut').reduce((sum, c) => sum + c.length, 0);
    assert.equal(report.totals.cut_length, cut);
    assert.equal(report.geometry, undefined);
  });
});

describe('kerfway methods', () => {
  it('lists the methods, one per line, and the parameters of those from papers', async () => {
    const { code, stdout } = await kerfway('methods');
    assert.equal(code, 0);
    const [methods, parameters] = stdout.trimEnd().split('\n\n').map((block) => block.split('\n'));
    for (const line of methods) assert.match(line, /^[a-z0-9-]+ {2,}\S.*\. \S.*\./);
    const [title, ...lines] = parameters;
    assert.match(title, /--set:$/);
    for (const line of lines) assert.match(line, /^[a-z0-9-]+ {2,}([a-z][a-z0-9_]*=\S+ ?)+$/);
    assert.deepEqual(lines.filter((line) => !methods.some((m) => m.split(' ')[0] === line.split(' ')[0])), []);
  });
});

const COMMANDS = ['plan', 'inspect', 'quote', 'check', 'serve', 'work', 'methods', 'solve', 'completion'];

describe('kerfway', () => {
  it('prints its version with the hashes of the wasm files that plan, and its options', async () => {
    const { version } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
    const hashOf = (name) => createHash('sha256').update(readFileSync(join(ROOT, 'dist', 'sdk', 'pkg', name))).digest('hex');
    const hashes = ['kerfway_bg.wasm', 'kerfway_research_bg.wasm'].map((name) => `${name} sha256 ${hashOf(name)}`);
    assert.equal((await kerfway('--version')).stdout, [version, ...hashes, ''].join('\n'));
    const { code, stdout } = await kerfway('--help');
    assert.equal(code, 0);
    for (const command of COMMANDS) assert.match(stdout, new RegExp(`^kerfway ${command}`, 'm'));
  });

  it('prints the options of each command, with examples that it accepts', async () => {
    const { code, stdout } = await kerfway('help', 'plan');
    assert.deepEqual([code, stdout], [0, (await kerfway('plan', 'x.dxf', '--help')).stdout]);
    assert.match(stdout, /--no-return/);
    assert.match((await kerfway('inspect', '-h')).stdout, /Usage: kerfway inspect FILE/);
    for (const command of COMMANDS) {
      const help = (await kerfway('help', command)).stdout;
      const examples = help.slice(help.indexOf('Examples:')).split('\n').filter((l) => /^ {2}[^#]*kerfway /.test(l));
      assert.ok(examples.length > 0, command);
      const known = [...help.matchAll(/^ {2}--([a-z-]+)/gm)].map((m) => m[1]);
      for (const [, option] of examples.join('\n').matchAll(/ --([a-z-]+)/g)) assert.ok(known.includes(option), `${command} --${option}`);
    }
  });

  const wrong = [
    [[], /Name a command/],
    [['plan', 'a.dxf', '--colour', 'red'], /kerfway plan has no option --colour\.\nRun kerfway help plan for its options\.$/m],
    [['plan', 'a.dxf', '--json', '-', '--svg', '-'], /--json and --svg cannot both/],
    [['plan', fixture(KEYBOARD), '--method', 'luck'], /--method luck: choose one of/],
    [['draw'], /no command draw/],
    [['plan'], /Name a DXF or SVG file/],
    [['help', 'draw'], /no command draw/],
    [['plan', 'a.dxf', 'b.dxf', '--gcode', 'x.nc'], /--gcode x\.nc is one file, and there are 2 drawings: name a folder/],
    [['plan', 'a.dxf', 'b.dxf', '--svg', '-'], /--svg - is for one drawing, and there are 2/],
    [['solve', 'a.tsp', 'b.tsp'], /b\.tsp is one too many/],
    [['completion'], /Name a shell/],
    [['completion', 'csh'], /completion csh: choose one of bash, zsh, fish/],
    [['plan', 'a.dxf', '--secnds', '5'], /no option --secnds\. Did you mean --seconds\?$/m],
    [['plan', 'a.dxf', '--seconds', '-1'], /--seconds needs a value\. A negative one is written --seconds=-1\.$/m],
    [['plan', 'a.dxf', '--seconds'], /--seconds needs a value\.$/m],
    [['plan', 'a.dxf', '--gcode', ''], /--gcode needs a value\.$/m],
    [['plan', ''], /The name of a file is empty\.$/m],
    [['plan', 'a.dxf', '--lead', 'arc', '--lead-radius', '0'], /--lead-radius 0: give a number from 0\.01 to 1000 mm: a lead/],
    [['plan', 'a.dxf', '--lead-angle', '500'], /--lead-angle 500: give a number from 0\.573 to 180 degrees: /],
    [['plan', 'a.dxf', '--lead', 'arc', '--lead-center-below=-5'], /--lead-center-below -5: give a number from 0/],
    [['plan', 'a.dxf', '--joint-spacing=-5'], /--joint-spacing -5: give a number from 1 to 1000000 mm: /],
    [['plan', 'a.dxf', '--skeleton', '200,5'], /--skeleton 200,5: give a number from 10 to 100000 mm: smaller/],
    [['plan', 'a.dxf', '--heat', '5,1e9'], /--heat 5,1e9: give a number from 0 to 600 s: /],
    [['plan', 'a.dxf', '--shift-parts', '1e9'], /--shift-parts 1e9: give a number from 0 to 100 mm: /],
    [['plan', 'a.dxf', '--place', 'center@1e9,5'], /--place center@1e9,5: give a number from -1000000 to 1000000 mm: /],
    [['plan', 'a.dxf', '--workers', '0'], /--workers 0: give a whole number from 1 to 64: /],
    [['plan', 'a.dxf', '--bound=-1'], /--bound -1: give a number from 0 to 604800 s: /],
    [['plan', 'a.dxf', '--layer', 'X=mark', '--layer', 'Y=cut,min-power=9'], /--layer Y=cut,min-power=9: min-power is 9\. Give a number from 0 to 1: /],
    [['plan', 'a.dxf', '--keep-border', '--ignore-border'], /--keep-border and --ignore-border: /],
    [['plan', 'a.dxf', '--first', '2', '--first', '1', '--last', '1'], /--first 1 and --last 1: a contour cannot be both\. Give one of them\./],
    [['plan', 'a.dxf', '--exclude', '3', '--mark', '3'], /--exclude 3 and --mark 3: /],
    [['quote', 'a.dxf', '--thickness', '1e9'], /--thickness 1e9: give a number from 0\.001 to 1000 mm: /],
    [['quote', 'a.dxf', '--quantity', '4', '--quantity', '0'], /--quantity 0: give a whole number from 1 to 1000000: /],
    [['plan', 'a.dxf', '--seconds=-1'], /--seconds -1: give a number of seconds/],
    [['plan', 'a.dxf', '--moves', '1.5'], /--moves 1\.5: give a whole number/],
    [['plan', 'a.dxf', '--seed', 'x'], /--seed x: give a whole number/],
    [['plan', 'a.dxf', '--layer', 'cut'], /--layer cut: write NAME=cut/],
    [['--version', 'x'], /^kerfway: x is one too many\.$/m],
    [['help', 'plan', 'x'], /^kerfway: x is one too many\.$/m],
    [['plan', '-ü.dxf'], /^kerfway: kerfway plan has no option -ü\.$/m],
    [['plan', 'a.dxf', '--layer', 'X=cut,speed=1,speed=2'], /--layer X=cut,speed=1,speed=2: speed is given twice\.$/m],
    [['plan', 'a.dxf', '--layer', 'X=burn'], /--layer X: burn: choose one of cut, mark, ignore/],
    [['plan', 'a.dxf', '--units', 'miles'], /--units miles: choose one of mm/],
    [['plan', fixture(KEYBOARD), '--machine', 'plasma'], /--machine plasma: choose one of co2-100w/],
    [['plan', 'a.dxf', '--no-return=1'], /--no-return takes no value/],
    [['inspect', 'a.dxf', '--seed', '1'], /no option --seed/],
    [['methods', 'all'], /methods takes no arguments/],
    [['solve'], /Name a \.tsp, \.gtsp or \.pcglns file/],
    [['solve', 'a.tsp', '--machine', 'x'], /no option --machine/],
  ];
  // These have a process each, and the others one together, which takes 0.3 s less for each of them.
  const alone = 4;
  let together;
  before(async () => (together = JSON.parse((await ran([ONE_PROCESS, ...wrong.slice(alone).map(([args]) => JSON.stringify(args))])).stdout)));
  for (const [k, [args, sentence]] of wrong.entries()) {
    const words = args.map((a) => a.replace(ROOT, '')).join(' ');
    it(`wrong usage has exit code 2 and a reason: ${words}`, async () => {
      const { code, stdout, stderr } = k < alone ? await kerfway(...args) : together[k - alone];
      assert.equal(code, 2);
      // A program that reads JSON from standard output gets the reason there, too.
      const json = args.some((word, k) => word === '--json' && args[k + 1] === '-');
      if (json) assert.equal(JSON.parse(stdout).error.code, 'wrong-usage');
      else assert.equal(stdout, '');
      assert.match(stderr, sentence);
      assert.equal(stderr.trim().split('\n').length, 2);
    });
  }

  it('a failure is a document for a program that reads JSON, whatever has failed', async (t) => {
    const machine = file(t, 'machine.json', '{"name":"mine"}');
    for (const [args, exit, code] of [
      [['plan', fixture(KEYBOARD), '--machine', machine], 1, 'missing-field'],
      [['plan', fixture(KEYBOARD), '--machine', 'none.json'], 1, 'unreadable-file'],
      [['verify', 'none.json'], 1, 'unreadable-file'],
      [['solve', 'none.tsp'], 1, 'unreadable-file'],
      [['calibrate', 'none.json=5'], 1, 'unreadable-file'],
      [['calibrate', 'none.json'], 2, 'wrong-usage'],
    ]) {
      const run = await kerfway(...args, '--json', '-');
      const { schema, error } = JSON.parse(run.stdout);
      assert.deepEqual([run.code, schema, error.code], [exit, 'kerfway.error/1', code], args.join(' '));
    }
  });

  const unusable = [
    ['nothing', '', /empty/i],
    ['a DWG file', 'AC1032\0\0\0\0', /DWG.*Save As and choose DXF/],
    ['a PNG file', '\x89PNG\r\n\x1a\n', /PNG/],
    ['text', 'Dear Sir or Madam,\nplease cut this.\n', /DXF/],
  ];
  for (const [what, content, sentence] of unusable) {
    it(`unusable input has exit code 1 and one sentence: ${what}`, async (t) => {
      const { code, stdout, stderr } = await kerfway('plan', file(t, 'input.dxf', Buffer.from(content, 'latin1')));
      assert.deepEqual([code, stdout], [1, '']);
      assert.match(stderr, sentence);
      assert.match(stderr, /^kerfway: .*input\.dxf: [^\n]*\n$/);
    });
  }

  it('reports why a file cannot be read or written', async (t) => {
    const at = folder(t);
    mkdirSync(join(at, 'sub'));
    for (const [args, sentence, exit] of [
      [['plan', join(at, 'none.dxf')], /none\.dxf cannot be read: there is no such file\./, 1],
      [['inspect', join(at, 'sub')], /sub cannot be read: that is a folder, not a file\./, 1],
      [[...PLAN, '--svg', join(at, 'gone', 'x.svg')], /x\.svg cannot be written: there is no such folder\. No file was changed\. Name another place\./, 3],
      [[...PLAN, '--machine', fixture(KEYBOARD)], /is not JSON: a machine profile/, 1],
    ]) {
      const { code, stderr } = await kerfway(...args);
      assert.equal(code, exit);
      assert.match(stderr, sentence);
    }
  });
});
