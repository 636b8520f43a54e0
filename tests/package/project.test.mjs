// Project files: written, read, refused, and taken by the command line wherever it takes a drawing.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { promisify } from 'node:util';
import { isProject, plan, readProject, writeProject } from 'kerfway';
import { bytes, circle, dxf, folder, ROOT, square } from './support.mjs';

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10), circle(20, 20, 5));
const CLI = join(ROOT, 'dist', 'sdk', 'cli.js');
const cli = (...args) => promisify(execFile)(process.execPath, [CLI, ...args]);
const text = (value) => new TextEncoder().encode(typeof value === 'string' ? value : JSON.stringify(value));

async function planned() {
  const { path, seed, moves, summary } = await plan(PLATE, { units: 'mm', exclude: [2], moves: 2000, seed: 5, machine: 'length' });
  return {
    name: 'plate.dxf', drawing: PLATE, reading: { units: 'mm', exclude: [2] }, planning: { machine: 'length', seconds: 30 },
    plan: { seed, moves, seconds: 1, total_time: summary.total_time, done: true, curve: { at: [0.1], total: [summary.total_time] }, path },
  };
}

describe('a project', () => {
  it('was a file of NaN MB as a Blob', async () => {
    const written = await writeProject(await planned());
    const read = await readProject(new Blob([written]));
    assert.deepEqual([read.name, [...read.drawing]], ['plate.dxf', [...PLATE]]);
    for (const none of ['text', undefined, {}]) await assert.rejects(readProject(none), (error) => error.code === 'not-bytes');
  });

  it('is read as it was written', async () => {
    const project = await planned();
    const bytes = text(await writeProject(project));
    assert.equal(isProject(bytes), true);
    assert.equal(isProject(PLATE), false);
    assert.equal(isProject(null), false);
    const read = await readProject(bytes);
    assert.deepEqual(Buffer.from(read.drawing), Buffer.from(PLATE));
    assert.deepEqual([read.name, read.reading, read.planning], [project.name, project.reading, project.planning]);
    assert.deepEqual([...read.plan.path.contours], [...project.plan.path.contours]);
    const again = await plan(read.drawing, { ...read.reading, ...read.planning, seconds: undefined, warm: read.plan.path, moves: 0, seed: read.plan.seed });
    assert.equal(again.summary.total_time, project.plan.total_time);
  });

  it('that is damaged is refused in a sentence that says what is wrong', async () => {
    const good = JSON.parse(await writeProject(await planned()));
    const bad = [
      ['{ "schema": "kerfway.project/1", ', /it is not JSON, or only a part of it/],
      [{ ...good, schema: 'kerfway.project/9' }, /it is of the kind kerfway\.project\/9/],
      [{ ...good, schema: { toString: 1 } }, /it is of the kind an object, and this version reads kerfway\.project\/1/],
      [{ ...good, drawing: undefined }, /its name or its drawing is missing/],
      [{ ...good, drawing: '!' }, /its drawing is damaged/],
      [{ ...good, drawing: good.drawing.slice(0, 40) }, /its drawing is damaged/],
      [{ ...good, reading: null }, /what was decided about its drawing is missing/],
      [{ ...good, planning: { secnods: 1 } }, /no option "secnods". Did you mean "seconds"/],
      [{ ...good, plan: {} }, /its plan has no path/],
      [{ ...good, plan: { ...good.plan, moves: 'many' } }, /a number of its plan is missing/],
      [{ ...good, plan: { ...good.plan, path: { contours: 'x' } } }, /warm/],
    ];
    for (const [project, sentence] of bad) {
      await assert.rejects(readProject(text(project)), (error) => error.name === 'KerfwayError' && sentence.test(error.message), String(sentence));
    }
  });

  /** Such projects were written, and then refused when they were opened, or opened with another drawing. */
  it('that could not be read again is not written', async () => {
    const good = await planned();
    const refused = [
      [undefined, 'wrong-type', /it is no object/],
      [{ ...good, name: undefined }, 'wrong-type', /its name or its drawing is missing/],
      [{ ...good, drawing: undefined }, 'not-bytes', /./],
      [{ ...good, drawing: [1, 2, 3] }, 'not-bytes', /./],
      [{ ...good, reading: { foo: 1 } }, 'unknown-field', /foo/],
      [{ ...good, planning: undefined }, 'wrong-type', /what was decided about its drawing is missing/],
      [{ ...good, plan: { ...good.plan, curve: undefined } }, 'wrong-type', /a number of its plan is missing/],
    ];
    for (const [project, code, sentence] of refused) {
      await assert.rejects(writeProject(project), (error) => error.code === code && sentence.test(error.message), String(sentence));
    }
    assert.equal((await readProject(text(await writeProject({ ...good, plan: undefined })))).plan, null);
  });

  it('whose drawing fills the memory when it is unpacked is refused', async () => {
    const bomb = await writeProject({ ...(await planned()), drawing: new Uint8Array(257 * 2 ** 20) });
    assert.ok(bomb.length < 2 ** 20);
    await assert.rejects(readProject(text(bomb)), /up to 256 MB can be read/);
  });
});

describe('kerfway with a project', () => {
  it('writes the program of its plan, searches on with a budget, and lets options overrule it', async (t) => {
    const at = folder(t);
    const file = join(at, 'plate.kerfway');
    const project = await planned();
    writeFileSync(file, await writeProject(project));
    const document = async (...args) => JSON.parse((await cli('plan', file, '--json', '-', '--quiet', ...args)).stdout);
    const kept = await document();
    assert.equal(kept.summary.total_time, project.plan.total_time);
    assert.deepEqual([kept.machine.name, kept.budget.moves, kept.seed, kept.summary.contours], ['length', 0, 5, 2]);
    const longer = await document('--moves', '500');
    assert.ok(longer.summary.total_time <= project.plan.total_time);
    assert.equal(longer.budget.moves, 500);
    assert.equal((await document('--machine', 'co2-100w', '--moves', '100')).machine.name, 'co2-100w');
    assert.match((await cli('inspect', file)).stdout, /plate\.dxf/);
    const quote = JSON.parse((await cli('quote', file, '--json', '-', '--quiet')).stdout);
    assert.deepEqual([quote.input.name, quote.machine.name], ['plate.dxf', 'length']);
    assert.ok(readFileSync(file).length > 0);
  });

  it('says what is wrong with a damaged one', async (t) => {
    const file = join(folder(t), 'bad.kerfway');
    writeFileSync(file, '{"schema":"kerfway.project/1"}');
    await assert.rejects(cli('plan', file), (error) => error.code === 1 && /bad\.kerfway: This project file cannot be used: its name or its drawing is missing/.test(error.stderr));
  });

  /** Its plan was kept, although it did not fit the machine any more, and nothing said how to start without it. */
  it('was refused with options that change its machine, and plans with them from the beginning', async (t) => {
    const file = join(folder(t), 'plate.kerfway');
    const project = await planned();
    writeFileSync(file, await writeProject({ ...project, planning: { machine: 'co2-100w' } }));
    const searched = async (...args) => JSON.parse((await cli('plan', file, '--json', '-', '--quiet', ...args)).stdout).budget;
    for (const changed of [['--lead', 'arc'], ['--joints', '2'], ['--moving-pierce', '1'], ['--no-return'], ['--method', 'greedy'], ['--method', 'sga', '--set', 'crossover=0.5']]) {
      const { moves, from_path: isFromPlan } = await searched('--moves', '10', ...changed);
      assert.deepEqual([moves, isFromPlan], [10, undefined], changed.join(' '));
    }
    assert.equal((await searched('--moves', '10')).from_path, true);
    // Another dialect changes no path.
    assert.deepEqual(await searched('--dialect', 'linuxcnc-m67'), await searched());
    writeFileSync(file, await writeProject({ ...project, planning: { machine: 'co2-100w', method: 'sga' } }));
    assert.equal((await searched('--moves', '10', '--set', 'crossover=0.5')).from_path, undefined);
  });

  it('whose machine is the name of a preset was planned on a machine without a name, and refused with options that change it', async (t) => {
    const at = folder(t);
    const saved = async (planning) => {
      const file = join(at, 'plate.kerfway');
      writeFileSync(file, await writeProject({ ...(await planned()), planning }));
      return file;
    };
    const file = await saved({ machine: 'k40' });
    assert.match((await cli('plan', file)).stdout, /; machine k40\n/);
    assert.match((await cli('plan', file, '--moves', '10', '--kerf-width', '0.2')).stdout, /; machine k40\n/);
    await assert.rejects(cli('plan', await saved({ machine: 'k41' })), (error) => error.code === 1 && /plate\.kerfway: its machine k41 is none of the presets, which are co2-100w, /.test(error.stderr));
  });

  it('was refused with options that its machine allows and the first preset does not', async (t) => {
    const at = folder(t);
    const project = await planned();
    const { machine } = JSON.parse((await plan(PLATE, { units: 'mm', moves: 10, seed: 1, outputs: ['json'] })).outputs.json);
    const [file, other] = ['plate.kerfway', 'other.kerfway'].map((name) => join(at, name));
    writeFileSync(file, await writeProject({ ...project, planning: { machine: { ...machine, levers: { chains: { reach: 5 } } } } }));
    writeFileSync(other, await writeProject({ ...project, planning: { machine } }));
    const out = join(at, 'out');
    const words = ['--moves', '10', '--chain-clearance', '1', '--json'];
    await cli('plan', file, ...words, out);
    assert.deepEqual(JSON.parse(readFileSync(out, 'utf8')).machine.levers.chains.clearance, 1);
    const refusal = /--chain-clearance: the machine does not join contours\./;
    await assert.rejects(cli('plan', other, ...words, out), (error) => error.code === 2 && refusal.test(error.stderr));
    await assert.rejects(cli('plan', other, file, ...words, `${at}/both/`), (error) => error.code === 4 && refusal.test(error.stderr) && /other\.kerfway: --chain/.test(error.stderr));
    assert.deepEqual(JSON.parse(readFileSync(join(at, 'both', 'plate.json'), 'utf8')).machine.levers.chains.clearance, 1);
  });

  it('was refused with another unit than it was read in, and kept its border and its own lists of contours against the options', async (t) => {
    const file = join(folder(t), 'plate.kerfway');
    const read = async (drawing, reading, ...args) => {
      writeFileSync(file, await writeProject({ name: 'plate', drawing, reading, planning: {}, plan: null }));
      return JSON.parse((await cli('inspect', file, '--json', '-', ...args)).stdout);
    };
    const svg = text('<svg xmlns="http://www.w3.org/2000/svg"><rect x="1" y="1" width="50" height="50"/></svg>');
    assert.equal((await read(svg, { dpi: 72 }, '--units', 'mm')).units.unit, 'mm');
    assert.deepEqual((await read(svg, { units: 'mm' }, '--dpi', '96')).units.dpi, 96);
    const sheet = bytes('sheets/sheet_100.dxf');
    const contours = async (reading, ...args) => (await read(sheet, reading, ...args)).totals.closed;
    assert.deepEqual([await contours({ keepBorder: true }), await contours({ keepBorder: true }, '--ignore-border')], [101, 100]);
    assert.deepEqual([await contours({ ignoreOutline: true }), await contours({ ignoreOutline: true }, '--keep-border')], [100, 101]);
    const operation = async (reading, ...args) => (await read(PLATE, { units: 'mm', ...reading }, ...args)).contours.map((c) => c.operation);
    assert.deepEqual(await operation({ exclude: [1] }, '--mark', '1'), await operation({}, '--mark', '1'));
    assert.deepEqual(await operation({ mark: [1, 2] }, '--exclude', '1'), await operation({ mark: [2] }, '--exclude', '1'));
  });

  it('was refused with another method because of its parameters, and on another machine because of its material', async (t) => {
    const at = folder(t);
    const project = { ...(await planned()), plan: null };
    const file = join(at, 'plate.kerfway');
    writeFileSync(file, await writeProject({ ...project, planning: { method: 'sga', parameters: { crossover: 0.5 } } }));
    assert.match((await cli('plan', file, '--moves', '10', '--method', 'tour-tree')).stdout, /^Search {5}tour-tree, /m);
    writeFileSync(file, await writeProject({ ...project, planning: { machine: 'k40', material: 'acrylic' } }));
    await assert.rejects(cli('plan', file, '--moves', '10'), /has no setting for the material "acrylic"/);
    const { stdout, stderr } = await cli('plan', file, '--moves', '10', '--machine', 'co2-100w');
    assert.match(stdout, /; machine co2-100w\n/);
    assert.match(stderr, /plate\.kerfway: the machine co2-100w has no setting for the project's material acrylic\. Its own speed and power are used\.\n/);
  });
});
