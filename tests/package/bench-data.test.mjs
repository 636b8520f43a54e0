// The instances of the benches: those that may be copied are in the repository, and the others are listed.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, sep } from 'node:path';
import { describe, it } from 'node:test';
import { Instances } from '../../benches/common/data.mjs';
import { ROOT } from './support.mjs';

const manifest = JSON.parse(readFileSync(join(ROOT, 'benches', 'data', 'manifest.json'), 'utf8'));
const MISSING = 'pcgtsp/ESC07.pcglns';

/** What `report` prints. */
function reported(instances) {
  const { log } = console;
  const lines = [];
  console.log = (line) => lines.push(line);
  try {
    instances.report();
  } finally {
    console.log = log;
  }
  return lines.join('\n');
}

describe('benches/data', () => {
  it('has every stored file with its checksum, source and licence', () => {
    const instances = new Instances();
    for (const { path, source, licence } of manifest.files) {
      assert.ok(source && licence, path);
      assert.ok(readFileSync(instances.file(path)).length > 0, path);
    }
  });

  it('has no instance that the manifest does not name', () => {
    const stored = readdirSync(join(ROOT, 'benches', 'data'), { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile() && !['README.md', 'manifest.json', 'large.jsonl'].includes(entry.name))
      .map((entry) => join(entry.parentPath, entry.name));
    const named = manifest.files.map(({ stored }) => join(ROOT, stored));
    assert.deepEqual(stored.filter((file) => !named.includes(file)), []);
  });

  it('reports what was not run, and why', () => {
    const instances = new Instances();
    assert.equal(instances.find(MISSING), null);
    assert.match(reported(instances), /^not run: 1 instance \(pcgtsp\/ESC07\.pcglns\).*states no licence.*--data/);
    assert.equal(reported(instances), '');
  });

  it('refuses a file of --data with another checksum', () => {
    const folder = mkdtempSync(join(tmpdir(), 'kerfway-data-'));
    try {
      mkdirSync(join(folder, 'pcgtsp'));
      writeFileSync(join(folder, MISSING), 'NAME: another\n');
      assert.throws(() => new Instances(folder).find(MISSING), /its checksum differs/);
    } finally {
      rmSync(folder, { recursive: true });
    }
    assert.throws(() => new Instances(folder), /there is no such folder/);
  });

  it('is all that benches read, with nothing outside the repository', () => {
    const scripts = readdirSync(join(ROOT, 'benches'), { recursive: true }).filter((f) => f.endsWith('.mjs') && !f.includes('target'));
    for (const file of scripts) assert.doesNotMatch(readFileSync(join(ROOT, 'benches', file), 'utf8'), /'shared'|\.\.\/shared/, file);
  });
});

for (const bench of ['papers', 'dewil']) {
  it(`the bench ${bench} begins on a clone that has nothing but npm packages`, () => {
    const clone = mkdtempSync(join(tmpdir(), 'kerfway-clone-'));
    try {
      const code = (from) => !from.includes(join('benches', 'data')) && !from.includes(`${sep}target`);
      for (const part of ['benches', 'scripts', 'package.json', 'package-lock.json', 'Cargo.toml', 'Cargo.lock', 'www/policy.json']) cpSync(join(ROOT, part), join(clone, part), { recursive: true, filter: code });
      symlinkSync(join(ROOT, 'node_modules'), join(clone, 'node_modules'));
      const { stderr } = spawnSync(process.execPath, ['benches/run.mjs', bench, '--table', 'none'], { cwd: clone, encoding: 'utf8' });
      assert.match(stderr, /There is no table none/);
    } finally {
      rmSync(clone, { recursive: true });
    }
  });
}
