// The command line with several drawings, with patterns, and with --watch.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { filesOf } from '../../dist/sdk/cli/glob.js';
import { progressLine } from '../../dist/sdk/cli/progress.js';
import { circle, CLI, dxf, folder, kerfway, square } from './support.mjs';

const QUICK = ['--moves', '50', '--seed', '1'];
const BROKEN = Buffer.from('AC1032\0\0\0\0', 'latin1');

/** A folder with drawings of 1, 2, ... squares: a.dxf, b.dxf, ..., and with other files by name. */
function drawings(t, names, others = {}) {
  const at = folder(t);
  names.forEach((name, k) => write(join(at, name), dxf(...Array.from({ length: k + 1 }, (_, i) => square(40 * i, 0, 24)))));
  for (const [name, content] of Object.entries(others)) write(join(at, name), content);
  return at;
}

function write(path, content) {
  mkdirSync(join(path, '..'), { recursive: true });
  writeFileSync(path, content);
}

describe('several drawings', () => {
  it('each has its outputs in the folder under its own name, and a row in the table', async (t) => {
    const at = drawings(t, ['a.dxf', 'deep/b.dxf', 'deep/er/c.DXF']);
    const { code, stdout, stderr } = await kerfway('plan', join(at, 'a.dxf'), join(at, '**/*.[dD][xX][fF]'), ...QUICK, '--gcode', `${at}/out/`, '--json', `${at}/out/`);
    assert.deepEqual([code, stderr], [0, '']);
    assert.deepEqual(readdirSync(join(at, 'out')).sort(), ['a.json', 'a.nc', 'b.json', 'b.nc', 'c.json', 'c.nc']);
    const contours = ['a', 'b', 'c'].map((n) => JSON.parse(readFileSync(join(at, 'out', `${n}.json`), 'utf8')).contours.length);
    assert.deepEqual(contours, [1, 2, 3]);
    const [head, ...rows] = stdout.trimEnd().split('\n');
    assert.match(head, /^File +Contours +To cut +Job/);
    assert.deepEqual(rows.map((r) => /(\w+)\.dxf +(\d)/i.exec(r).slice(1)), [['a', '1'], ['b', '2'], ['c', '3']]);
  });

  it('quantities, sheets, limits and savings were asked for in vain', async (t) => {
    const at = drawings(t, ['a.dxf', 'b.dxf'], { 'limits.json': '{"smallest_part": [30, 10]}' });
    const [a, b] = ['a.dxf', 'b.dxf'].map((name) => join(at, name));
    const order = ['--units', 'mm', ...QUICK, '--quantity', '7', '--quantity', '700', '--sheet', '300x150', '--limits', join(at, 'limits.json')];
    const [one, both] = [await kerfway('quote', a, ...order, '--json', `${at}/one/`), await kerfway('quote', a, b, ...order, '--json', `${at}/both/`)];
    const under = both.stdout.split('\n').filter((line) => line.startsWith('  ')).map((line) => line.trim());
    assert.match(both.stdout, /^File .*\n\S+a\.dxf .*\n {2}Limit .*\n {2}7 copies .*\n {2}700 copies .*\n\S+b\.dxf .*\n {2}Limit .*\n {2}Limit .*\n {2}7 copies .*\n {2}700 copies .*\n$/);
    assert.deepEqual(under.slice(0, 3), one.stdout.split('\n').filter((line) => /^Limit|copies/.test(line)), 'as of a single file');
    // 9 squares of 24 mm with gaps of 5 lie beside each other in 280 mm, 4 above each other in 130.
    assert.match(under[2], /^700 copies .*, about 20 sheets$/);
    assert.match(under.at(-1), /^700 copies .*, about 39 sheets$/);
    assert.equal(readFileSync(join(at, 'both', 'a.json'), 'utf8'), readFileSync(join(at, 'one', 'a.json'), 'utf8'));
    const saved = await kerfway('plan', a, b, ...QUICK, '--moving-pierce', '1', '--savings', '--json', '-');
    assert.deepEqual(saved.stderr.split('\n').filter((line) => line.startsWith('  ')).map((line) => /^ {2}Levers {5}moving-pierce (saves|costs) /.test(line)), [true, true], saved.stderr);
    for (const line of saved.stdout.trimEnd().split('\n')) assert.deepEqual(JSON.parse(line).savings.map(({ lever }) => lever), ['moving-pierce']);
  });

  it('an unusable file is reported in a sentence, the others are processed, and the exit code is 4', async (t) => {
    const at = drawings(t, ['a.dxf', 'c.dxf'], { 'b.dxf': BROKEN });
    for (const command of ['plan', 'quote']) {
      const out = join(at, command);
      const { code, stdout, stderr } = await kerfway(command, join(at, '*.dxf'), join(at, 'gone.dxf'), ...QUICK, '--json', `${out}/`);
      assert.equal(code, 4);
      assert.match(stderr, /^kerfway: \S+b\.dxf: This is a DWG.*\nkerfway: \S+gone\.dxf cannot be read: there is no such file\.\n$/);
      assert.deepEqual(readdirSync(out).sort(), ['a.json', 'c.json']);
      assert.equal(stdout.trimEnd().split('\n').length, 3);
    }
  });

  it('a drawing that is read and cannot be planned is reported in a sentence, and the others go on', async (t) => {
    const at = drawings(t, ['a.dxf', 'b.dxf']);
    const { code, stderr } = await kerfway('plan', join(at, 'a.dxf'), join(at, 'b.dxf'), ...QUICK, '--set', 'particles=9');
    assert.equal(code, 5);
    assert.match(stderr, /^kerfway: \S+a\.dxf: Only methods from papers have parameters\.\nkerfway: \S+b\.dxf: Only methods from papers have parameters\.\n$/);
  });

  it('the exit code is 1 for one unusable file, 5 if all of several failed, and 3 if no output can be written', async (t) => {
    const at = drawings(t, ['a.dxf', 'c.dxf'], { 'b.dxf': BROKEN });
    assert.equal((await kerfway('inspect', join(at, 'b.dxf'))).code, 1);
    assert.equal((await kerfway('inspect', join(at, 'b.dxf'), join(at, 'gone.dxf'))).code, 5);
    assert.equal((await kerfway('inspect', join(at, 'a.dxf'), '--json', join(at, 'gone', 'a.json'))).code, 3);
  });

  it('--json - says for each file what happened, with the code of its error', async (t) => {
    const at = drawings(t, ['a.dxf', 'c.dxf'], { 'b.dxf': BROKEN });
    const { code, stdout } = await kerfway('inspect', join(at, 'a.dxf'), join(at, 'b.dxf'), join(at, 'gone.dxf'), join(at, 'c.dxf'), '--json', '-');
    assert.equal(code, 4);
    const said = stdout.trimEnd().split('\n').map((line) => JSON.parse(line));
    assert.deepEqual(said.map((s) => [s.schema, s.error?.code]), [
      ['kerfway.inspect/1', undefined], ['kerfway.error/1', 'not-a-drawing'], ['kerfway.error/1', 'unreadable-file'], ['kerfway.inspect/1', undefined],
    ]);
    assert.deepEqual([said[1].file, Object.keys(said[1].error)], [join(at, 'b.dxf'), ['code', 'message', 'params', 'retryable']]);
    const one = await kerfway('plan', join(at, 'gone.dxf'), '--json', '-');
    assert.deepEqual([one.code, JSON.parse(one.stdout).error.code], [1, 'unreadable-file']);
  });

  it('a pattern whose range runs backwards was a stack trace', async (t) => {
    const { code, stderr } = await kerfway('inspect', join(folder(t), 'plate[3-1].dxf'));
    assert.equal(code, 1);
    assert.match(stderr, /^kerfway: No file matches the pattern \S+plate\[3-1\]\.dxf\.\n$/);
  });

  it('the batch ended when the reader of standard error had gone', { skip: process.platform === 'win32' && 'pipes end otherwise there' }, async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'b.dxf'), dxf(square(0, 0, 10)));
    const child = spawn(process.execPath, [CLI, 'inspect', join(at, 'a.dxf'), join(at, 'b.dxf'), '--json', `${at}/`], { stdio: ['ignore', 'ignore', 'pipe'] });
    child.stderr.destroy();
    const [code] = await once(child, 'exit');
    assert.equal(code, 4);
    assert.equal(JSON.parse(readFileSync(join(at, 'b.json'), 'utf8')).totals.closed, 1);
  });

  it('a pattern that matches nothing is reported as a pattern', async (t) => {
    const at = drawings(t, ['a.dxf']);
    const { code, stderr } = await kerfway('inspect', join(at, '*.dwg'));
    assert.deepEqual([code, stderr], [1, `kerfway: No file matches the pattern ${join(at, '*.dwg')}.\n`]);
  });

  it('--quiet prints warnings and errors only', async (t) => {
    const at = drawings(t, ['a.dxf', 'c.dxf'], { 'b.dxf': BROKEN });
    for (const [command, budget] of [['plan', QUICK], ['quote', QUICK], ['inspect', []]]) {
      const { code, stdout, stderr } = await kerfway(command, join(at, '*.dxf'), ...budget, '--quiet');
      assert.deepEqual([code, stdout], [4, ''], command);
      assert.match(stderr, /^kerfway: \S+b\.dxf: This is a DWG[^\n]*\n$/);
    }
  });

  it('what is said of a drawing named only its file, which several folders may have', async (t) => {
    const at = drawings(t, ['x/a.dxf', 'y/a.dxf']);
    const { stderr } = await kerfway('plan', join(at, '*/a.dxf'), ...QUICK, '--layer', 'none=mark');
    const warned = stderr.split('\n').filter((line) => line.includes('has no layer "none"')).map((line) => line.split(': ')[1]);
    assert.deepEqual(warned, [join(at, 'x/a.dxf'), join(at, 'y/a.dxf')]);
  });

  it('the JSON of several drawings goes to standard output, one document per line', async (t) => {
    const at = drawings(t, ['a.dxf', 'b.dxf']);
    const schemas = { plan: 'kerfway.plan/1', quote: 'kerfway.quote/2', inspect: 'kerfway.inspect/1' };
    for (const [command, schema] of Object.entries(schemas)) {
      const budget = command === 'inspect' ? [] : QUICK;
      const { code, stdout, stderr } = await kerfway(command, join(at, '*.dxf'), ...budget, '--json', '-');
      assert.equal(code, 0);
      assert.deepEqual(stdout.trimEnd().split('\n').map((l) => JSON.parse(l).schema), [schema, schema]);
      assert.match(stderr, /^File .*\n.*a\.dxf .*\n.*b\.dxf .*\n$/);
    }
  });

  it('no output replaces a drawing or the output of another drawing', async (t) => {
    const at = drawings(t, ['a.dxf', 'b.dxf', 'deep/a.dxf']);
    const before = readFileSync(join(at, 'a.dxf'));
    const own = await kerfway('plan', join(at, 'a.dxf'), join(at, 'b.dxf'), ...QUICK, '--dxf', `${at}/`);
    assert.equal(own.code, 2);
    assert.match(own.stderr, /--dxf \S+a\.dxf for \S+a\.dxf is the same file as \S+a\.dxf, which is read\. Name another file or folder\.\n/);
    assert.deepEqual(readFileSync(join(at, 'a.dxf')), before);
    const twice = await kerfway('plan', join(at, '**/a.dxf'), ...QUICK, '--svg', `${at}/out/`);
    assert.equal(twice.code, 2);
    assert.match(twice.stderr, /^kerfway: --svg \S+a\.svg for \S+deep\/a\.dxf is the same file as --svg \S+a\.svg for \S+\/a\.dxf\./);
    assert.deepEqual(readdirSync(at).sort(), ['a.dxf', 'b.dxf', 'deep']);
  });

  it('patterns name existing files, sorted, without duplicates, and hidden files only explicitly', (t) => {
    const at = drawings(t, ['b.dxf', 'a.dxf', '.h.dxf', 'x/y/c.dxf', 'x/a1.dxf', 'x/a(2).dxf']);
    const named = (...words) => filesOf(words.map((w) => join(at, w))).map((f) => f.slice(at.length + 1));
    assert.deepEqual(named('*.dxf'), ['a.dxf', 'b.dxf']);
    assert.deepEqual(named('.*.dxf'), ['.h.dxf']);
    assert.deepEqual(named('b.dxf', '?.dxf'), ['b.dxf', 'a.dxf']);
    assert.deepEqual(named('x/a[!(]*'), ['x/a1.dxf']);
    assert.deepEqual(named('*/a(?).dxf'), ['x/a(2).dxf']);
    assert.deepEqual(named('**/*.dxf'), ['a.dxf', 'b.dxf', 'x/a(2).dxf', 'x/a1.dxf', 'x/y/c.dxf']);
    assert.deepEqual(named('x/**'), ['x/a(2).dxf', 'x/a1.dxf', 'x/y/c.dxf']);
    assert.deepEqual(named('*.svg'), ['*.svg']);
  });
});

describe('--watch', () => {
  it('runs again when a file changes, is replaced, appears or is repaired', async (t) => {
    const at = drawings(t, ['a.dxf'], { 'b.dxf': BROKEN });
    const child = spawn(process.execPath, [CLI, 'plan', join(at, '*.dxf'), ...QUICK, '--json', `${at}/out/`, '--watch'], { stdio: ['ignore', 'pipe', 'pipe'] });
    t.after(() => child.kill('SIGKILL'));
    const told = { out: '', err: '' };
    child.stdout.on('data', (d) => (told.out += d));
    child.stderr.on('data', (d) => (told.err += d));
    const contours = (name) => {
      const path = join(at, 'out', name);
      return existsSync(path) ? JSON.parse(readFileSync(path, 'utf8')).contours.length : 0;
    };
    const until = async (what) => {
      for (let k = 0; k < 400 && !what(); k++) await wait(50);
      assert.ok(what(), `${what} ${told.out} ${told.err}`);
    };

    await until(() => contours('a.json') === 1 && told.err.includes('b.dxf'));
    write(join(at, 'a.dxf'), dxf(square(0, 0, 10), circle(50, 50, 5)));
    await until(() => contours('a.json') === 2);
    write(join(at, 'new'), dxf(square(0, 0, 10), circle(50, 50, 5), circle(90, 50, 5)));
    renameSync(join(at, 'new'), join(at, 'a.dxf'));
    await until(() => contours('a.json') === 3);
    write(join(at, 'b.dxf'), dxf(square(0, 0, 24)));
    write(join(at, 'c.dxf'), dxf(square(0, 0, 24)));
    await until(() => contours('b.json') === 1 && contours('c.json') === 1);
    assert.equal(told.out.match(/a\.dxf/g).length, 3);
    assert.equal(told.err.match(/b\.dxf/g).length, 1);
    child.kill('SIGINT');
    assert.deepEqual(await once(child, 'exit'), [null, 'SIGINT']);
  });
});

describe('the progress line', () => {
  const progress = { seconds: 4, moves: 2_000_000, rate: 500_000, summary: { total_time: 83.2, gap: 0.0312 } };
  const alone = { index: 0, of: 1 };

  it('shows job time, gap and seconds left of the budget that ends first', () => {
    const left = (budget) => /(\d+) s left/.exec(progressLine(progress, budget, 'a.dxf', alone))?.[1];
    assert.equal(progressLine(progress, { seconds: 8 }, 'a.dxf', alone), '[########........]  job 83.2 s  gap 3.2 %  4 s left  500 k moves/s');
    assert.deepEqual([{}, { moves: 3_000_000 }, { moves: 3_000_000, workers: 2 }, { seconds: 5, moves: 9e9 }, { seconds: 1 }].map(left), ['6', '2', '8', '1', '0']);
  });

  it('shows no gap of 0.00 %: one that is left is rounded up, and where none is, the path is optimal', () => {
    const shown = (gap) => progressLine({ ...progress, summary: { total_time: 83.2, gap } }, { moves: 9 }, 'a.dxf', alone).split('  ')[2];
    assert.deepEqual([2e-6, 0.00304, 1e-7, 0].map(shown), ['gap 0.01 %', 'gap 0.31 %', 'proven optimal', 'proven optimal']);
  });

  it('shows which of several files it is, and omits unknown values', () => {
    const early = { ...progress, rate: 0, summary: { total_time: 83.2, gap: null } };
    assert.equal(progressLine(early, { moves: 9 }, 'b.dxf', { index: 1, of: 3 }), '2/3 b.dxf  [................]  job 83.2 s  0 k moves/s');
  });
});
