// Files that are too large are refused before they are read, and streams are read only up to the limit.

import assert from 'node:assert/strict';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { mkdirSync, openSync, closeSync, ftruncateSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { createPool, inspect, plan, tooLarge } from '../../dist/sdk/node.js';
import { MAX_BYTES } from '../../dist/sdk/size.js';
import { CLI, folder } from './support.mjs';

const SENTENCE = 'The file has 400 MB; up to 256 MB can be read. Delete what is not to be cut, or split the drawing.';
const LARGE = 400 * 2 ** 20;

/** Memory that the command line takes by itself, with a margin, kB; twice the limit is what reading up to it takes. */
const READ_NOTHING = 200_000;
const READ_TO_LIMIT = 700_000;

/** A sparse file, which takes no room on the disk. */
function sparse(at, name, size) {
  const path = join(at, name);
  const file = openSync(path, 'w');
  ftruncateSync(file, size);
  closeSync(file);
  return path;
}

/** The command line, and the most memory it had, in kB. */
function measured(args, options = {}) {
  const ending = "process.on('exit', () => require('node:fs').writeSync(3, String(process.resourceUsage().maxRSS)));";
  const child = spawnSync(process.execPath, ['--import', `data:text/javascript,import { createRequire } from 'node:module'; const require = createRequire('/'); ${encodeURIComponent(ending)}`, CLI, ...args], {
    encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe', 'pipe'], ...options,
  });
  return { ...child, memory: Number(child.output[3]) };
}

describe('a file of 400 MB', () => {
  it('the sentence names the limit, and the limit itself is allowed', () => {
    assert.deepEqual([tooLarge(0), tooLarge(MAX_BYTES)], [null, null]);
    assert.match(tooLarge(MAX_BYTES + 1), /^The file has 257 MB; up to 256 MB can be read\./);
    assert.equal(tooLarge(LARGE), SENTENCE);
  });

  for (const command of ['plan', 'quote', 'inspect', 'solve']) {
    it(`kerfway ${command} refuses it before it is read`, (t) => {
      const file = sparse(folder(t), 'large.dxf', LARGE);
      const { status, stderr, memory } = measured([command, file]);
      assert.deepEqual([status, stderr], [1, `kerfway: ${file}: ${SENTENCE}\n`]);
      assert.ok(memory > 0 && memory < READ_NOTHING, `${memory} kB`);
    });
  }

  it('is refused as a machine file too', (t) => {
    const at = folder(t);
    const { status, stderr, memory } = measured(['plan', 'x.dxf', '--machine', sparse(at, 'large.json', LARGE)]);
    assert.equal(status, 1);
    assert.match(stderr, /large\.json: The file has 400 MB/);
    assert.ok(memory < READ_NOTHING, `${memory} kB`);
  });

  it('a pipe is read only up to the limit', { skip: process.platform === 'win32' && 'there are no named pipes' }, (t) => {
    const pipe = join(folder(t), 'pipe.dxf');
    execFileSync('mkfifo', [pipe]);
    // The stream never ends, so the test would hang if it were not refused.
    const zeros = spawn('/bin/sh', ['-c', 'exec cat /dev/zero > "$0"', pipe], { stdio: 'ignore' });
    t.after(() => zeros.kill('SIGKILL'));
    const { status, stderr, memory } = measured(['inspect', pipe], { timeout: 60_000 });
    assert.deepEqual([status, stderr], [1, `kerfway: ${pipe}: The file has more than 256 MB; up to 256 MB can be read. Delete what is not to be cut, or split the drawing.\n`]);
    assert.ok(memory < READ_TO_LIMIT, `${memory} kB`);
  });

  it('a folder is not a file', (t) => {
    const at = join(folder(t), 'sub');
    mkdirSync(at);
    assert.match(measured(['inspect', at]).stderr, /sub cannot be read: that is a folder, not a file\./);
  });

  it('the package refuses its bytes before it copies them', async () => {
    const bytes = new Uint8Array(LARGE);
    const before = process.memoryUsage().arrayBuffers;
    const refused = (work) => assert.rejects(work, { message: SENTENCE });
    await refused(inspect(bytes));
    await refused(inspect(bytes.buffer));
    await refused(inspect(() => bytes));
    await refused(plan(bytes, { moves: 1 }));
    const pool = createPool({ size: 1 });
    await refused(pool.inspect(bytes));
    pool.close();
    // A planner reads its wasm file, a few megabytes; a copy of the bytes would be hundreds.
    assert.ok(process.memoryUsage().arrayBuffers - before < LARGE / 20);
    assert.ok(process.resourceUsage().maxRSS < LARGE / 1024, `${process.resourceUsage().maxRSS} kB`);
  });
});
