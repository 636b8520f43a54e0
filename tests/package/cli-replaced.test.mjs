// An output that replaces a file keeps its properties and links, also under --watch, which reports a program that is stale.

import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { chmodSync, chownSync, closeSync, existsSync, lstatSync, mkdirSync, openSync, readdirSync, readFileSync, readlinkSync, statSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { contours, disk, fill, inputs, NOBODY, OLD, POSIX, QUICK, refused, ROOT_USER, run } from './outputs-support.mjs';
import { CLI, folder } from './support.mjs';

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
    assert.deepEqual(readdirSync(dirname(pipe)).sort(), ['a.certificate.json', 'a.dxf', 'a.ngc', 'a.tsp', 'caught', 'pipe', 'plan.json']);
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
