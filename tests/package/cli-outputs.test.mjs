// Outputs are replaced completely or not at all: the disk fails, or a signal arrives, during every output of every command.

import assert from 'node:assert/strict';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import {
  chmodSync, chownSync, closeSync, existsSync, lstatSync, mkdirSync, mkdtempSync, openSync, readdirSync, readFileSync, readlinkSync, rmdirSync, rmSync, statSync, symlinkSync, writeFileSync, writeSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { pathToFileURL } from 'node:url';
import { COMMANDS } from '../../dist/sdk/cli/commands.js';
import { CLI, dxf, folder, ROOT, square } from './support.mjs';

const POSIX = process.platform !== 'win32';
const ROOT_USER = POSIX && process.getuid() === 0;
/** A user without permissions. */
const NOBODY = 65_534;

const OLD = 'the old program, whole\n';
/** Contours of many sizes, so that every output is longer than a page of memory. */
const contours = (count) => dxf(...Array.from({ length: count }, (_, k) => square(30 * (k % 16), 30 * Math.floor(k / 16), 10 + k / 20)));
const DRAWING = contours(120);
const CITIES = Array.from({ length: 1500 }, (_, k) => `${k + 1} ${(k * 7919) % 1009} ${(k * 104_729) % 997}`);
const INSTANCE = `NAME: t\nTYPE: TSP\nDIMENSION: ${CITIES.length}\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n${CITIES.join('\n')}\nEOF\n`;
const QUICK = ['--moves', '5', '--seed', '1'];
/** What a command reads, if not a drawing. */
const INPUTS = { solve: 'a.tsp' };
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

/** Runs the command line, if needed through other programs; resolves to its exit code or signal and its messages. */
function run(args, { before = [], env = {}, preload = [], ...options } = {}) {
  const [program, ...words] = [...before, process.execPath, ...preload, CLI, ...args];
  return new Promise((resolve) => {
    const child = spawn(program, words, { stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, ...env }, ...options });
    const out = { stdout: '', stderr: '' };
    child.stdout?.on('data', (d) => (out.stdout += d));
    child.stderr.on('data', (d) => (out.stderr += d));
    child.on('close', (code, signal) => resolve({ ...out, code, signal }));
  });
}

/** A folder with the inputs. */
function inputs(t) {
  const at = folder(t);
  chmodSync(at, 0o755);
  writeFileSync(join(at, 'a.dxf'), DRAWING);
  writeFileSync(join(at, 'a.tsp'), INSTANCE);
  return at;
}

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

const refused = ({ code, stderr }, why) => {
  assert.equal(code, 3, stderr);
  assert.match(stderr, new RegExp(`^kerfway: \\S+ cannot be written: ${why}\\. No file was changed\\. [A-Z][^\\n]*\\.\\n$`));
};

const faulty = (fault, more = {}) => ({
  preload: ['--import', pathToFileURL(join(ROOT, 'tests', 'package', 'faulty-disk.mjs')).href],
  env: { FAULT: fault, ...more },
});

/** A separate disk of this many pages, or the reason why it cannot be made. */
function disk(t, pages) {
  const at = mkdtempSync(join(tmpdir(), 'kerfway-'));
  const options = `size=${pages * 4096}`;
  const mounted = ROOT_USER && process.platform === 'linux' && spawnSync('mount', ['-t', 'tmpfs', '-o', options, 'tmpfs', at]).status === 0;
  t.after(() => {
    if (mounted) execFileSync('umount', ['--lazy', at]);
    rmdirSync(at);
  });
  return mounted ? at : null;
}

/** Fills a disk; returns a function that empties it again. */
function fill(at) {
  const filler = join(at, 'filler');
  const file = openSync(filler, 'w');
  for (const size of [4096, 1]) {
    try {
      for (;;) writeSync(file, Buffer.alloc(size));
    } catch (error) {
      assert.equal(error.code, 'ENOSPC');
    }
  }
  closeSync(file);
  return () => rmSync(filler);
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
      const limited = ['/bin/sh', '-c', 'ulimit -f 1; exec "$@"', 'sh'];
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

describe('an output replaces a file and keeps its properties', () => {
  const gcode = async (t, to) => {
    const { code, stderr } = await run(['plan', join(inputs(t), 'a.dxf'), ...QUICK, '--gcode', to]);
    return { code, stderr };
  };

  it('keeps its permissions, and a new file gets the usual ones', { skip: !POSIX && 'there are no modes' }, async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'old.nc'), OLD);
    chmodSync(join(at, 'old.nc'), 0o604);
    for (const name of ['old.nc', 'new.nc']) assert.equal((await gcode(t, join(at, name))).code, 0);
    writeFileSync(join(at, 'plain'), '');
    const mode = (name) => statSync(join(at, name)).mode & 0o777;
    assert.deepEqual([mode('old.nc'), mode('new.nc')], [0o604, mode('plain')]);
  });

  it('keeps its owner', { skip: !ROOT_USER && 'only root can give files away' }, async (t) => {
    const file = join(folder(t), 'a.nc');
    writeFileSync(file, OLD);
    chownSync(file, NOBODY, NOBODY);
    assert.equal((await gcode(t, file)).code, 0);
    assert.deepEqual([statSync(file).uid, statSync(file).gid], [NOBODY, NOBODY]);
  });

  it('is refused if the file is read-only', { skip: !ROOT_USER && 'only root can run it as another user' }, async (t) => {
    const at = folder(t);
    const file = join(at, 'a.nc');
    chmodSync(at, 0o777);
    writeFileSync(file, OLD);
    chmodSync(file, 0o444);
    const result = await run(['plan', join(inputs(t), 'a.dxf'), ...QUICK, '--gcode', file], { uid: NOBODY, gid: NOBODY });
    refused(result, 'the system does not allow it');
    assert.equal(readFileSync(file, 'utf8'), OLD);
  });

  it('keeps links, also chains of links and dangling ones', { skip: !POSIX && 'links need a right there' }, async (t) => {
    const at = folder(t);
    mkdirSync(join(at, 'real'));
    writeFileSync(join(at, 'real', 'old.nc'), OLD);
    symlinkSync('real/old.nc', join(at, 'first'));
    symlinkSync('first', join(at, 'second'));
    symlinkSync('real/new.nc', join(at, 'dangling'));
    for (const [link, file] of [['second', 'old.nc'], ['dangling', 'new.nc']]) {
      assert.deepEqual(await gcode(t, join(at, link)), { code: 0, stderr: '' });
      assert.match(readFileSync(join(at, 'real', file), 'utf8'), /M5/);
    }
    assert.deepEqual([readlinkSync(join(at, 'first')), readlinkSync(join(at, 'second'))], ['real/old.nc', 'first']);
    assert.deepEqual(readdirSync(join(at, 'real')).sort(), ['new.nc', 'old.nc']);
    symlinkSync('circle', join(at, 'circle'));
    assert.match((await gcode(t, join(at, 'circle'))).stderr, /circle cannot be written: its links lead in a circle\. No file was changed/);
  });

  it('writes directly to pipes and to the path of standard output', { skip: process.platform !== 'linux' && 'Linux only' }, async (t) => {
    const from = inputs(t);
    const pipe = join(from, 'pipe');
    execFileSync('mkfifo', [pipe]);
    const read = run([], { before: ['/bin/sh', '-c', 'cat "$0"', pipe] });
    assert.equal((await gcode(t, pipe)).code, 0);
    assert.match((await read).stdout, /M5/);
    assert.ok(lstatSync(pipe).isFIFO());
    // Under Node's own pipes, which are sockets, the system opens no /dev/stdout.
    const piped = ['/bin/sh', '-c', '"$@" | cat', 'sh'];
    const { code, stdout } = await run(['plan', join(from, 'a.dxf'), ...QUICK, '--gcode', '/dev/stdout', '--svg', '/dev/null'], { before: piped });
    assert.equal(code, 0);
    assert.match(stdout, /M5/);
    assert.ok(statSync('/dev/null').isCharacterDevice());
    // If standard output is a file, it is not replaced, because the caller has it open.
    const caught = openSync(join(from, 'caught'), 'w');
    assert.equal((await run(['plan', join(from, 'a.dxf'), ...QUICK, '--gcode', '/dev/stdout'], { stdio: ['ignore', caught, 'pipe'] })).code, 0);
    closeSync(caught);
    assert.deepEqual(readdirSync(dirname(pipe)).sort(), ['a.dxf', 'a.tsp', 'caught', 'pipe']);
  });
});

describe('--watch', () => {
  it('keeps the old program on a full disk, reports it, and writes when there is room', async (t) => {
    const at = disk(t, 64);
    if (at === null) return t.skip('a small disk can be mounted by root on Linux only');
    const from = inputs(t);
    const [drawing, program] = [join(from, 'a.dxf'), join(at, 'a.nc')];
    const child = spawn(process.execPath, [CLI, 'plan', drawing, ...QUICK, '--gcode', program, '--watch'], { stdio: ['ignore', 'ignore', 'pipe'] });
    t.after(() => child.kill('SIGKILL'));
    let said = '';
    child.stderr.on('data', (d) => (said += d));
    const until = async (what) => {
      for (let k = 0; k < 600 && !what(); k++) await wait(50);
      assert.ok(what(), `${what} ${said}`);
    };
    await until(() => existsSync(program));
    const old = readFileSync(program, 'utf8');
    const empty = fill(at);
    writeFileSync(drawing, contours(100));
    await until(() => said.includes('stale'));
    assert.match(said, /a\.nc cannot be written: the disk is full\. No file was changed\..*\n.*a\.dxf was not planned\. \S+a\.nc on the disk is from an earlier drawing, and stale\./);
    assert.equal(readFileSync(program, 'utf8'), old);
    assert.deepEqual(readdirSync(at).sort(), ['a.nc', 'filler']);
    empty();
    writeFileSync(drawing, contours(90));
    await until(() => readFileSync(program, 'utf8') !== old);
    assert.match(readFileSync(program, 'utf8'), /M5/);
  });
});
