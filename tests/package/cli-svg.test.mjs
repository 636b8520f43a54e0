// SVG on the command line, standard input, tolerances, and what happens while the unit is in doubt.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { closeSync, existsSync, openSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { circle, CLI, dxf, folder, kerfway, line, piped, square, unitless } from './support.mjs';

const QUICK = ['--moves', '50', '--seed', '1'];
const svg = (root, body) => `<svg xmlns="http://www.w3.org/2000/svg" ${root}>${body}</svg>`;
const BODY = '<rect x="10" y="10" width="60" height="40" fill="none" stroke="#f00"/><circle cx="40" cy="30" r="5" fill="none" stroke="#f00"/>';
const MM = svg('width="100mm" height="80mm" viewBox="0 0 100 80"', BODY);
const PIXELS = svg('width="100" height="80"', BODY);

describe('SVG on the command line', () => {
  it('is inspected, planned and quoted as a DXF is, whatever its name', async (t) => {
    const at = folder(t);
    const file = join(at, 'plate.dxf');
    writeFileSync(file, MM);
    const inspected = JSON.parse((await kerfway('inspect', file, '--json', '-')).stdout);
    assert.deepEqual([inspected.contours.length, inspected.parts.length, inspected.layers.map((l) => l.name)], [2, 1, ['#ff0000']]);
    const { code } = await kerfway('plan', file, ...QUICK, '--gcode', join(at, 'a.nc'), '--json', join(at, 'a.json'));
    assert.equal(code, 0);
    const plan = JSON.parse(readFileSync(join(at, 'a.json'), 'utf8'));
    assert.ok(Math.abs(plan.summary.cut_length - (200 + 10 * Math.PI)) < 1e-9);
    assert.match(readFileSync(join(at, 'a.nc'), 'utf8'), /^G[23] /m);
    assert.match((await kerfway('quote', file, ...QUICK)).stdout, /1 part, 1 different/);
  });

  it('takes a resolution for pixels', async (t) => {
    const file = join(folder(t), 'a.svg');
    writeFileSync(file, PIXELS);
    const length = async (...args) => JSON.parse((await kerfway('inspect', file, '--json', '-', ...args)).stdout).totals.cut_length;
    const pixels = 200 + 10 * Math.PI;
    assert.ok(Math.abs((await length()) - (pixels * 25.4) / 96) < 1e-9);
    assert.ok(Math.abs((await length('--dpi', '72')) - (pixels * 25.4) / 72) < 1e-9);
    assert.ok(Math.abs((await length('--units', 'mm')) - pixels) < 1e-9);
    const both = await kerfway('inspect', file, '--dpi', '72', '--units', 'mm');
    assert.deepEqual([both.code, /Choose one of them/.test(both.stderr)], [1, true]);
    assert.match((await kerfway('inspect', file, '--dpi', '72')).stdout, /Units {6}px at 72 dpi \(chosen by you\)/);
  });

  it('names other formats with a way to a drawing', async (t) => {
    const at = folder(t);
    for (const [start, words] of [
      ['%PDF-1.4\n', /a PDF file\. Open it in Inkscape/], ['%PDF-1.5\n%Adobe Illustrator', /an Illustrator file\. In Illustrator, use File, Export As/],
      ['%!PS-Adobe-3.0 EPSF-3.0', /PostScript or EPS file/], ['AC1032\0\0', /DWG file\. In AutoCAD, use Save As/], ['ISO-10303-21;', /STEP file, a solid\. In the CAD program/],
    ]) {
      const file = join(at, 'a.svg');
      writeFileSync(file, start);
      const { code, stderr } = await kerfway('inspect', file);
      assert.equal(code, 1);
      assert.match(stderr, words);
    }
  });
});

describe('standard input', () => {
  it('is read by plan, inspect and quote', async (t) => {
    const at = folder(t);
    for (const drawing of [MM, dxf(square(0, 0, 50), circle(25, 25, 5))]) {
      assert.match((await piped(drawing, 'inspect', '-')).stdout, /^standard input.*\n/);
      assert.match((await piped(drawing, 'quote', '-', ...QUICK)).stdout, /standard input: 1 part/);
      assert.equal((await piped(drawing, 'plan', '-', ...QUICK, '--gcode', `${at}/out/`)).code, 0);
      assert.match(readFileSync(join(at, 'out', 'standard-input.nc'), 'utf8'), /Kerfway .*standard input/);
      assert.match((await piped(drawing, 'plan', '-', ...QUICK, '--json', '-')).stdout, /"kerfway.plan\/1"/);
    }
  });

  it('is refused where it cannot be read', async () => {
    const { code, stderr } = await piped('nonsense', 'inspect', '-');
    assert.deepEqual([code, /^kerfway: Standard input: This is neither a DXF nor an SVG/.test(stderr)], [1, true]);
    assert.deepEqual((await piped(MM, 'plan', '-', '--watch')).code, 2);
  });

  /** The command line with an open file as its standard input. */
  const reading = (path, flags, ...args) => {
    const input = openSync(path, flags);
    const { status, stderr } = spawnSync(process.execPath, [CLI, ...args], { encoding: 'utf8', stdio: [input, 'pipe', 'pipe'] });
    closeSync(input);
    return [status, stderr];
  };

  it('that is a folder was an empty file', (t) => {
    for (const command of ['plan', 'inspect', 'quote', 'check', 'solve']) {
      assert.deepEqual(reading(folder(t), 'r', command, '-'), [1, 'kerfway: Standard input cannot be read: that is a folder, not a file.\n'], command);
    }
  });

  it('that cannot be read was a crash', (t) => {
    assert.deepEqual(reading(join(folder(t), 'output'), 'w', 'inspect', '-'), [1, 'kerfway: Standard input cannot be read: it is not open for that.\n']);
  });

  it('that is read twice was an empty drawing the second time', async (t) => {
    const limits = join(folder(t), 'limits.json');
    writeFileSync(limits, '{"smallest_hole":3}');
    const twice = [['quote', '-', '--limits', '-'], ['verify', '-', '-']];
    for (const words of twice) {
      const { code, stderr } = await piped('{"smallest_hole":3}', ...words);
      assert.deepEqual([code, stderr], [1, 'kerfway: Standard input was read already: name one of the files that are read from it.\n'], words.join(' '));
    }
    assert.equal((await piped(MM, 'quote', '-', '--limits', limits, ...QUICK)).code, 0);
    assert.match((await piped('[', 'quote', 'a.dxf', '--limits', '-')).stderr, /^kerfway: Standard input is not JSON: limits are /);
  });

  it('was called - by check, solve and verify', async () => {
    const check = await piped('M5\n', 'check', '-');
    assert.match(check.stdout, /^standard input: fails/);
    assert.equal(check.stderr, 'kerfway: Standard input fails: The program cuts nothing.\n');
    assert.equal((await piped('nonsense', 'solve', '-')).stderr, 'kerfway: Standard input: The file has no TYPE.\n');
    assert.match((await piped('nonsense', 'verify', '-')).stderr, /^kerfway: Standard input names no drawing/);
  });
});

describe('tolerances', () => {
  const gap = dxf(line(0, 0, 50, 0), line(50.2, 0, 50.2, 50), line(50, 50, 0, 50), line(0, 50, 0, 0.2));

  it('are those of the API', async () => {
    const closed = async (...args) => JSON.parse((await piped(gap, 'inspect', '-', '--json', '-', ...args)).stdout).totals.closed;
    assert.deepEqual([await closed(), await closed('--join-tolerance', '0.3')], [0, 1]);
    const plan = JSON.parse((await piped(gap, 'plan', '-', ...QUICK, '--json', '-', '--join-tolerance', '0.3', '--curve-tolerance', '0.02', '--copy-tolerance', '0.05')).stdout);
    assert.deepEqual([plan.options.join_tolerance, plan.options.tolerance, plan.options.copy_tolerance], [0.3, 0.02, 0.05]);
  });

  it('are refused out of range, by the names of the command line', async () => {
    for (const [option, value, words] of [['--join-tolerance', '9', /--join-tolerance 9: give a number/], ['--curve-tolerance', '0', /--curve-tolerance 0: give a number/], ['--copy-tolerance', 'x', /--copy-tolerance x: give a number/]]) {
      const { code, stderr } = await piped(gap, 'inspect', '-', option, value);
      assert.equal(code, 2);
      assert.match(stderr, words);
    }
  });
});

describe('a unit in doubt', () => {
  const DOUBTFUL = unitless(square(0, 0, 100));

  it('stops a program, until the unit is given or the guess accepted', async (t) => {
    const at = folder(t);
    for (const [k, drawing] of [DOUBTFUL, PIXELS].entries()) {
      const out = join(at, `${k}.nc`);
      const refused = await piped(drawing, 'plan', '-', ...QUICK, '--gcode', out, '--json', join(at, 'a.json'));
      assert.equal(refused.code, 1);
      assert.match(refused.stderr, /Nothing is written while the unit is in doubt: state it by --units or --dpi, or accept this guess by --accept-guess\./);
      assert.deepEqual([existsSync(out), existsSync(join(at, 'a.json'))], [false, false]);
      for (const args of [['--units', 'mm'], ['--accept-guess']]) {
        assert.equal((await piped(drawing, 'plan', '-', ...QUICK, '--gcode', out, ...args)).code, 0, args[0]);
      }
    }
  });

  it('is repeated by plan and quote', async () => {
    const planned = await piped(DOUBTFUL, 'plan', '-', ...QUICK);
    assert.match(planned.stdout, /Units {6}mm, in doubt: The file names no units/);
    assert.match(planned.stderr, /standard input: The file names no units/);
    const quoted = await piped(DOUBTFUL, 'quote', '-', ...QUICK);
    assert.match(quoted.stdout, /Units {6}mm, in doubt: The file names no units/);
    assert.match(quoted.stdout, /Confidence low\n.*The unit is in doubt\./);
    const plan = JSON.parse((await piped(DOUBTFUL, 'plan', '-', ...QUICK, '--json', '-')).stdout);
    assert.match(plan.input.units_doubt, /^The file names no units/);
    const given = JSON.parse((await piped(DOUBTFUL, 'plan', '-', ...QUICK, '--json', '-', '--units', 'mm')).stdout);
    assert.equal('units_doubt' in given.input, false);
  });
});
