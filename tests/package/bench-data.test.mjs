// The instances of the benches: those that may be copied are in the repository, and the others are listed.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, sep } from 'node:path';
import { describe, it } from 'node:test';
import { Instances } from '../../benches/common/data.mjs';
import { clusters, generalisedFrom, generalisedRandom } from '../../benches/solve/clusters.mjs';
import { parts } from '../../benches/solve/tsplib.mjs';
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

  it('has the sets of GTSPLIB that the clustering of its authors makes', () => {
    const instances = new Instances();
    // Those of asymmetric costs were made in another way.
    const symmetric = instances.list('gtsplib', '.gtsp').filter((path) => !/ftv|rbg/.test(path));
    assert.equal(symmetric.length, 24);
    for (const path of symmetric) {
      const instance = parts(readFileSync(instances.file(path), 'latin1'));
      const stored = instance.sections.get('GTSP_SET_SECTION').filter(Boolean).map((row) => row.split(/\s+/).slice(1, -1).map((node) => node - 1));
      const sorted = (sets) => sets.map((set) => set.toSorted((a, b) => a - b).join(' ')).sort();
      assert.deepEqual(sorted(clusters(instance)), sorted(stored), path);
    }
  });

  it('makes an instance of GTSPLIB from a file of TSPLIB', () => {
    const folder = mkdtempSync(join(tmpdir(), 'kerfway-tsplib-'));
    try {
      // Nodes on a line, in three heaps of five.
      const places = [0, 100, 200].flatMap((x) => [0, 1, 2, 3, 4].map((dx) => x + dx));
      const nodes = places.map((x, k) => `${k + 1} ${x} 0`);
      writeFileSync(join(folder, 'heaps15.tsp'), ['NAME : heaps15', 'TYPE : TSP', 'DIMENSION : 15', 'EDGE_WEIGHT_TYPE : EUC_2D', 'NODE_COORD_SECTION', ...nodes, 'EOF', ''].join('\n'));
      assert.deepEqual(generalisedFrom(folder, { least: 4 }), []);
      const [{ sets, file: make }] = generalisedFrom(folder, { least: 3 });
      assert.equal(sets, 3);
      const file = make();
      assert.match(file, /3heaps15\.gtsp$/);
      const made = parts(readFileSync(file, 'latin1'));
      assert.deepEqual(made.sections.get('GTSP_SET_SECTION').filter(Boolean), ['1 11 12 13 14 15 -1', '2 1 2 3 4 5 -1', '3 6 7 8 9 10 -1']);
      const solved = spawnSync(process.execPath, [join(ROOT, 'dist', 'sdk', 'cli.js'), 'solve', file, '--moves', '1000'], { encoding: 'utf8' });
      assert.equal(solved.status, 0, solved.stderr);
      assert.match(solved.stdout, /\b392\b/);
      rmSync(file);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });

  it('makes the eight of DIMACS with 200 sets and more', () => {
    const made = generalisedRandom({ least: 200 });
    assert.deepEqual(made.map(({ name }) => name), ['200E1k.0', '200C1k.0', '633E3k.0', '633C3k.0', '2000E10k.0', '2000C10k.0', '6325E31k.0', '6325C31k.0']);
    const { header, sections } = parts(readFileSync(made[1].file(), 'latin1'));
    assert.deepEqual([header.get('DIMENSION'), header.get('GTSP_SETS')], ['1000', '200']);
    assert.equal(sections.get('GTSP_SET_SECTION').filter(Boolean).flatMap((row) => row.split(' ').slice(1, -1)).length, 1000);
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
