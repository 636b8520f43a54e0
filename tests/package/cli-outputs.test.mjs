// Outputs are replaced completely or not at all: the disk fails, or a signal arrives, during every output of every command.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, chownSync, closeSync, existsSync, mkdirSync, openSync, readdirSync, readFileSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { COMMANDS } from '../../dist/sdk/cli/commands.js';
import { contours, disk, faulty, fill, inputs, NOBODY, OLD, POSIX, QUICK, refused, ROOT_USER, run } from './outputs-support.mjs';
import { CLI, dxf, folder, square } from './support.mjs';

/** What a command reads, if not a drawing. */
const INPUTS = { solve: 'a.tsp', check: 'a.ngc', calibrate: 'plan.json=1500', verify: 'a.certificate.json' };
const ENDINGS = { gcode: 'a.nc', dxf: 'b.dxf' };
const fileOf = (kind) => ENDINGS[kind] ?? `a.${kind}`;

/** The outputs of each command, from the command line's own table, so that a new one is tested without being named here. */
const OUTPUTS = Object.entries(COMMANDS).map(([command, { options }]) => {
  const all = Object.entries(Object.assign({}, ...Object.values(options)));
  return { command, quick: all.some(([name]) => name === 'moves') ? QUICK : [], kinds: all.filter(([, { value }]) => value === 'OUT').map(([name]) => name) };
});

/** Every command that writes: its arguments for an input folder and an output folder, and the files it writes. */
const WRITERS = Object.fromEntries(OUTPUTS.flatMap(({ command, quick, kinds }) => {
  const words = (from) => [command, join(from, INPUTS[command] ?? 'a.dxf'), ...quick];
  const writer = (some) => (from, to) => [[...words(from), ...some.flatMap((kind) => [`--${kind}`, join(to, fileOf(kind))])], some.map(fileOf)];
  const single = kinds.map((kind) => [`${command} --${kind}`, writer([kind])]);
  if (kinds.length < 2) return single;
  const intoFolder = (from, to) => [[...words(from), '--gcode', `${to}/`, '--json', `${to}/`], ['a.nc', 'a.json']];
  return [...single, [`${command}, all outputs`, writer(kinds)], [`${command}, into a folder`, intoFolder]];
}));

/** Runs a command over old outputs, and checks that they are unchanged and that no other file is left. */
async function survives(t, writer, to, { strays = [], prepare = () => {}, ...options }) {
  const [args, files] = WRITERS[writer](inputs(t), to);
  for (const file of files) writeFileSync(join(to, file), OLD, { mode: 0o640 });
  const undo = prepare(files);
  const before = readdirSync(to).sort();
  const result = await run(args, options);
  undo?.();
  for (const file of files) assert.ok(readFileSync(join(to, file), 'utf8') === OLD, `${writer}: ${file} is not as it was. ${result.stderr}`);
  const more = readdirSync(to).filter((file) => !before.includes(file));
  assert.deepEqual(more.filter((file) => !strays.some((s) => s.test(file))), [], writer);
  return result;
}

/** Each command once; the kinds of output of a plan are written by the same call. */
const ONCE = Object.keys(WRITERS).filter((writer) => !writer.startsWith('plan --'));

it('every command that writes is tested, with every output', () => {
  for (const writer of ['plan --gcode', 'plan --json', 'plan --svg', 'plan --dxf', 'plan --png', 'plan, all outputs', 'plan, into a folder', 'quote --json', 'inspect --json', 'solve --json']) {
    assert.ok(writer in WRITERS, writer);
  }
});

for (const writer of Object.keys(WRITERS)) {
  const each = ONCE.includes(writer) ? it : () => {};
  describe(`${writer}: a failure leaves the old files whole`, () => {
    each('a full disk', async (t) => {
      const at = disk(t, 64);
      if (at === null) return t.skip('a small disk can be mounted by root on Linux only');
      const result = await survives(t, writer, at, { prepare: () => void fill(at) });
      refused(result, 'the disk is full');
      assert.match(result.stderr, /Make room on the disk/);
    });

    it('a limit of file sizes', { skip: !POSIX && 'there is no ulimit' }, async (t) => {
      const limited = ['/bin/sh', '-c', 'ulimit -f 0; exec "$@"', 'sh'];
      refused(await survives(t, writer, folder(t), { before: limited }), 'the file would be larger than the system allows');
    });

    each('a folder that may not be written to', { skip: !ROOT_USER && 'only root can run it as another user' }, async (t) => {
      const at = folder(t);
      const prepare = (files) => {
        for (const file of files) chownSync(join(at, file), NOBODY, NOBODY);
        chmodSync(at, 0o555);
      };
      refused(await survives(t, writer, at, { prepare, uid: NOBODY, gid: NOBODY }), 'the system does not allow it');
    });

    it('a disk that fails in the middle', async (t) => {
      refused(await survives(t, writer, folder(t), faulty('EIO')), 'the system says EIO');
    });

    for (const signal of ['SIGINT', 'SIGTERM', 'SIGKILL']) {
      each(`${signal} in the middle`, { skip: !POSIX && 'there are no signals' }, async (t) => {
        const strays = signal === 'SIGKILL' ? [/^\.kerfway-[0-9a-f]{16}\.tmp$/] : [];
        assert.equal((await survives(t, writer, folder(t), { ...faulty(signal), strays })).signal, signal);
      });
    }
  });
}

describe('outputs of one drawing', () => {
  const ALL = 'plan, all outputs';

  it('stay as they were when the last cannot be written or renamed', async (t) => {
    refused(await survives(t, ALL, folder(t), faulty('ENOSPC', { FAULT_AT: '5' })), 'the disk is full');
    refused(await survives(t, ALL, folder(t), faulty('EPERM', { FAULT_AT: '5', FAULT_CALL: 'renameSync' })), 'the system does not allow it');
    refused(await survives(t, ALL, folder(t), faulty('EIO', { FAULT_AT: '5', FAULT_CALL: 'fsyncSync' })), 'the system says EIO');
  });

  it('stay as they were, and those of another drawing are written', async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    writeFileSync(join(from, 'b.dxf'), contours(60));
    for (const name of ['a.nc', 'b.nc']) writeFileSync(join(to, name), OLD);
    const { code, stderr } = await run(['plan', join(from, 'a.dxf'), join(from, 'b.dxf'), ...QUICK, '--gcode', `${to}/`], faulty('EIO'));
    assert.equal(code, 4, stderr);
    assert.match(stderr, /a\.nc cannot be written: the system says EIO\. No file was changed\./);
    assert.equal(readFileSync(join(to, 'a.nc'), 'utf8'), OLD);
    assert.match(readFileSync(join(to, 'b.nc'), 'utf8'), /M5/);
    assert.deepEqual(readdirSync(to).sort(), ['a.nc', 'b.nc']);
  });

  it('leave no new file behind', async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    const [args] = WRITERS[ALL](from, to);
    refused(await run(args, faulty('EPERM', { FAULT_AT: '5', FAULT_CALL: 'renameSync' })), 'the system does not allow it');
    assert.deepEqual(readdirSync(to), []);
  });

  it('were all lost without a word, if one of them cannot be made', async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    writeFileSync(join(from, 'a.dxf'), dxf(square(0, 0, 40, 'CUT')));
    const plan = ['plan', join(from, 'a.dxf'), ...QUICK, '--layer', 'CUT=cut,passes=2,z-step=0.5', '--z-speed', '10', '--rd', join(to, 'a.rd')];
    const reason = /^kerfway: \S+a\.dxf: Ruida files of Kerfway do not lower the head: .*LightBurn project\.(.*)\n$/;
    const rest = ' Nothing was written: leave out --rd to have the other outputs.';
    for (const [more, said] of [[[], ''], [['--gcode', join(to, 'a.nc'), '--svg', join(to, 'a.svg')], rest]]) {
      const { code, stderr } = await run([...plan, ...more]);
      assert.deepEqual([code, reason.exec(stderr)?.[1], readdirSync(to)], [1, said, []], stderr);
    }
  });

  it('stay as they were when standard output cannot be written', { skip: !existsSync('/dev/full') && 'there is no /dev/full' }, async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    writeFileSync(join(to, 'a.nc'), OLD);
    const full = openSync('/dev/full', 'w');
    const plan = ['plan', join(from, 'a.dxf'), ...QUICK];
    const result = await run([...plan, '--gcode', join(to, 'a.nc'), '--json', '-'], { stdio: ['ignore', full, 'pipe'] });
    assert.equal(result.stderr, 'kerfway: Standard output cannot be written: the disk is full. No file was changed. Make room on the disk, or name another place.\n');
    assert.deepEqual([result.code, readFileSync(join(to, 'a.nc'), 'utf8'), readdirSync(to)], [3, OLD, ['a.nc']]);
    for (const args of [['methods'], ['--help'], plan]) {
      const { code, stderr } = await run(args, { stdio: ['ignore', full, 'pipe'] });
      assert.deepEqual([code, stderr], [3, 'kerfway: Standard output cannot be written: the disk is full. Make room on the disk, or name another place.\n'], args[0]);
    }
    closeSync(full);
  });

  it('are those of one of two commands that write the same files at once, and whole', async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    const plan = (seed) => run(['plan', join(from, 'a.dxf'), ...QUICK, '--seed', seed, '--json', join(to, 'a.json'), '--quiet']);
    for (const ran of await Promise.all(['1', '2', '3'].map(plan))) assert.equal(ran.code, 0, ran.stderr);
    assert.ok([1, 2, 3].includes(JSON.parse(readFileSync(join(to, 'a.json'), 'utf8')).seed));
    assert.deepEqual(readdirSync(to), ['a.json']);
  });

  /** Waits two seconds before the second file is renamed. */
  const SLOW = `data:text/javascript,${encodeURIComponent(`import fs from 'node:fs'; import { syncBuiltinESMExports } from 'node:module';
    const { renameSync } = fs; let calls = 0;
    fs.renameSync = (...args) => { if (++calls === 2) Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 2000); renameSync(...args); };
    syncBuiltinESMExports();`)}`;

  it('of two commands that wrote several same files at once were mixed', async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    const [json, program] = [join(to, 'a.json'), join(to, 'a.nc')];
    const plan = (machine, options) => run(['plan', join(from, 'a.dxf'), ...QUICK, '--machine', machine, '--json', json, '--gcode', program, '--quiet'], options);
    const slow = plan('co2-100w', { preload: ['--import', SLOW] });
    while (!existsSync(json)) await wait(10);
    for (const ran of await Promise.all([slow, plan('co2-linuxcnc')])) assert.equal(ran.code, 0, ran.stderr);
    assert.equal(JSON.parse(readFileSync(json, 'utf8')).machine.name, 'co2-linuxcnc');
    assert.match(readFileSync(program, 'utf8'), /machine co2-linuxcnc/m);
    assert.deepEqual(readdirSync(to).sort(), ['a.json', 'a.nc']);
  });

  it('are written although a program that was killed has left its lock', async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    const lock = join(to, '.kerfway-lock.tmp');
    writeFileSync(lock, '');
    utimesSync(lock, new Date(2020, 1, 1), new Date(2020, 1, 1));
    assert.equal((await run(['plan', join(from, 'a.dxf'), ...QUICK, '--json', join(to, 'a.json'), '--gcode', join(to, 'a.nc')])).code, 0);
    assert.deepEqual(readdirSync(to).sort(), ['a.json', 'a.nc']);
  });

  it('are written although a lock that was left behind cannot be removed', async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    // A folder stands for a file of another person in a folder of all: it cannot be made anew, nor removed as a file.
    const lock = join(to, '.kerfway-lock.tmp');
    mkdirSync(lock);
    utimesSync(lock, new Date(2020, 1, 1), new Date(2020, 1, 1));
    assert.equal((await run(['plan', join(from, 'a.dxf'), ...QUICK, '--json', join(to, 'a.json'), '--gcode', join(to, 'a.nc')])).code, 0);
    assert.deepEqual(readdirSync(to).sort(), ['.kerfway-lock.tmp', 'a.json', 'a.nc']);
  });

  it('that cannot be written were refused after the whole search, which was lost', async (t) => {
    const from = inputs(t);
    const drawing = join(from, 'a.dxf');
    for (const [out, sentence] of [
      [join(from, 'gone', 'x.nc'), /x\.nc cannot be written: there is no such folder\. No file was changed\. Name another place\.$/m],
      [join(drawing, 'x.nc'), /x\.nc cannot be written: there is no such folder\./],
      [`${join(drawing, 'sub')}/`, /sub\/ cannot be made: the system does not allow this folder\./],
    ]) {
      const begun = performance.now();
      const { code, stderr } = await run(['plan', drawing, '--seconds', '60', '--gcode', out]);
      assert.equal(code, 3, stderr);
      assert.match(stderr, sentence);
      assert.ok(performance.now() - begun < 30_000, 'no search is waited for');
    }
    // A folder that is made for one output may hold another one.
    const made = join(from, 'new');
    const { code, stderr } = await run(['plan', drawing, ...QUICK, '--gcode', `${join(made, 'programs')}/`, '--json', join(made, 'plan.json'), '--svg', join(made, 'programs', 'b.svg')]);
    assert.equal(code, 0, stderr);
    assert.deepEqual([readdirSync(made).sort(), readdirSync(join(made, 'programs')).sort()], [['plan.json', 'programs'], ['a.nc', 'b.svg']]);
  });

  it('are written even if the reader of standard output stops', { skip: !POSIX && 'there is no shell' }, async (t) => {
    const [from, to] = [inputs(t), folder(t)];
    const program = join(to, 'a.nc');
    const args = ['plan', join(from, 'a.dxf'), ...QUICK, '--json', '-', '--gcode', program];
    const { status, stdout } = spawnSync('/bin/sh', ['-c', '{ "$@"; echo "exit $?" >&2; } | head -c 1', 'sh', process.execPath, CLI, ...args], { encoding: 'utf8' });
    assert.deepEqual([status, stdout], [0, '{']);
    assert.match(readFileSync(program, 'utf8'), /M5/);
    assert.deepEqual(readdirSync(to), ['a.nc']);
  });
});
