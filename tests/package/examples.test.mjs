// The examples for Node, run as a reader would run them: copied next to an installed package.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { bytes, circle, dxf, fixture, install, KEYBOARD, pack, ROOT, square } from './support.mjs';

let at;
before(() => {
  at = mkdtempSync(join(tmpdir(), 'kerfway-examples-'));
  install(at, pack(at).filename);
});
after(() => rmSync(at, { recursive: true, force: true }));

describe('node-batch', () => {
  it('plans a folder, writes a program for each drawing, and reports unusable ones', () => {
    cpSync(join(ROOT, 'examples', 'node-batch', 'batch.mjs'), join(at, 'batch.mjs'));
    mkdirSync(join(at, 'drawings'));
    cpSync(fixture(KEYBOARD), join(at, 'drawings', 'keyboard.dxf'));
    for (let k = 0; k < 6; k++) writeFileSync(join(at, 'drawings', `plate-${k}.DXF`), dxf(square(0, 0, 50 + k), circle(25, 25, 5)));
    writeFileSync(join(at, 'drawings', 'empty.dxf'), '');
    writeFileSync(join(at, 'drawings', 'readme.txt'), 'no drawing');
    const { status, stdout, stderr } = spawnSync(process.execPath, ['batch.mjs', 'drawings', 'programs', '0.3'], { cwd: at, encoding: 'utf8' });
    assert.deepEqual([status, stderr], [1, '']);
    assert.deepEqual(readdirSync(join(at, 'programs')), ['keyboard.nc', ...[0, 1, 2, 3, 4, 5].map((k) => `plate-${k}.nc`)]);
    assert.match(readFileSync(join(at, 'programs', 'plate-5.nc'), 'utf8'), /^; Kerfway/);
    assert.match(stdout, /'empty\.dxf'.*empty/);
    assert.doesNotMatch(stdout, /readme/);
    const { length } = readFileSync(join(at, 'programs', 'keyboard.nc'));
    assert.ok(length > bytes(KEYBOARD).length / 20);
  });

  it('prints its usage', () => {
    const { status, stderr } = spawnSync(process.execPath, ['batch.mjs'], { cwd: at, encoding: 'utf8' });
    assert.equal(status, 2);
    assert.match(stderr, /node batch\.mjs drawings programs/);
  });
});
