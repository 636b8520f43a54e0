// The command line when the reader of its standard output has gone: `| head`.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { circle, CLI, dxf, folder } from './support.mjs';

const QUICK = ['--moves', '10', '--seed', '1'];

/** A folder with three drawings. */
function drawings(t) {
  const at = folder(t);
  for (const name of ['a', 'b', 'c']) writeFileSync(join(at, `${name}.dxf`), dxf(circle(50, 50, 10)));
  return ['a', 'b', 'c'].map((name) => join(at, `${name}.dxf`));
}

/** The exit code of a command whose reader has gone before it writes, and what it says on standard error. */
function unread(...args) {
  const { stderr } = spawnSync('/bin/sh', ['-c', '{ "$@"; echo "exit $?" >&2; } | true', 'sh', process.execPath, CLI, ...args], { encoding: 'utf8' });
  return { code: Number(/^exit (\d+)$/m.exec(stderr)?.[1]), stderr };
}

describe('a reader of standard output that has gone', { skip: process.platform === 'win32' && 'there is no shell' }, () => {
  it('ended the command after the first of several drawings with exit code 0, although a program was to be written for each', (t) => {
    const [files, out] = [drawings(t), folder(t)];
    assert.equal(unread('plan', ...files, ...QUICK, '--gcode', `${out}/`).code, 0);
    assert.deepEqual(readdirSync(out).sort(), ['a.nc', 'b.nc', 'c.nc']);
    assert.equal(unread('plan', join(out, 'none.dxf'), ...files, ...QUICK, '--gcode', `${out}/`).code, 4);
  });

  it('made a program that fails its check pass', (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'empty.nc'), '');
    const { code, stderr } = unread('check', join(at, 'empty.nc'));
    assert.equal(code, 1);
    assert.match(stderr, /empty\.nc fails: The program cuts nothing\./);
  });

  it('ended a service as soon as it listened', async (t) => {
    // A group of processes of its own, which is ended as a whole.
    const shell = spawn('/bin/sh', ['-c', '"$@" | true', 'sh', process.execPath, CLI, 'serve', '--port', '0'], { stdio: ['ignore', 'ignore', 'pipe'], detached: true });
    t.after(() => process.kill(-shell.pid, 'SIGKILL'));
    let said = '';
    shell.stderr.on('data', (data) => (said += data));
    const url = await new Promise((resolve) => {
      const timer = setInterval(() => {
        const [, found] = /"url":"([^"]+)"/.exec(said) ?? [];
        if (found === undefined) return;
        clearInterval(timer);
        resolve(found);
      }, 50);
    });
    await new Promise((resume) => setTimeout(resume, 500));
    assert.equal((await fetch(`${url}/healthz`)).status, 200);
  });

  it('was waited for: drawings whose JSON nobody reads were planned all the same', (t) => {
    const { code, stderr } = unread('plan', ...drawings(t), ...QUICK, '--json', '-');
    assert.equal(code, 0);
    assert.doesNotMatch(stderr, /c\.dxf/);
  });

  it('made the exit code 0, although a drawing had failed before', (t) => {
    const files = drawings(t);
    assert.equal(unread('inspect', `${files[0]}.none`, ...files).code, 4);
  });
});
