// The bench of GTSPLIB's large instances: the best tours of GLKH and the program LKH beside, lengths that are added up again, and the table.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { mulberry32 } from '../../benchmark/generate.mjs';
import { checked, instancesIn, lineOf, markdown, published, read } from '../../benches/solve/large.mjs';
import { costs, lengthOf, parts, setsOf } from '../../benches/solve/tsplib.mjs';
import { folder, ROOT } from './support.mjs';

/** Two nodes a set, on a line. */
const LINE = ['NAME: 3line6', 'TYPE: GTSP', 'DIMENSION: 6', 'EDGE_WEIGHT_TYPE: EUC_2D', 'GTSP_SETS: 3', 'NODE_COORD_SECTION', ...[0, 1, 10, 11, 20, 21].map((x, k) => `${k + 1} ${x} 0`), 'GTSP_SET_SECTION', '1 1 2 -1', '2 3 4 -1', '3 5 6 -1', 'EOF', ''].join('\n');

/** A GTSP of few sets with asymmetric costs. */
function drawn(seed) {
  const next = mulberry32(seed);
  const sets = [];
  let nodes = 0;
  while (sets.length < 3 + (seed % 2)) sets.push(Array.from({ length: 1 + (next() % 3) }, () => ++nodes));
  const matrix = Array.from({ length: nodes }, () => Array.from({ length: nodes }, () => 1 + (next() % 100)));
  return ['NAME: drawn', 'TYPE: AGTSP', `DIMENSION: ${nodes}`, `GTSP_SETS: ${sets.length}`, 'EDGE_WEIGHT_TYPE: EXPLICIT', 'EDGE_WEIGHT_FORMAT: FULL_MATRIX', 'EDGE_WEIGHT_SECTION', ...matrix.map((row) => row.join(' ')), 'GTSP_SET_SECTION', ...sets.map((set, k) => [k + 1, ...set, -1].join(' ')), 'EOF', ''].join('\n');
}

/** The length of the best tour, by trying all. */
function optimum(instance) {
  const extend = (tour, left) => (left.length === 0 ? [lengthOf(instance, tour)] : left.flatMap((set, k) => set.flatMap((node) => extend([...tour, node], left.toSpliced(k, 1)))));
  const [first, ...others] = setsOf(instance);
  return Math.min(...first.flatMap((node) => extend([node], others)));
}

const python = process.env.KERFWAY_PYTHON ?? 'python3';
const NEEDS_NUMPY = { skip: spawnSync(python, ['-c', 'import numpy']).status !== 0 && 'Python has no numpy' };

describe('the bench of large instances', () => {
  it('reads the instances with 200 sets and more, and sets that go on in the next line', (t) => {
    const place = folder(t);
    const nodes = Array.from({ length: 400 }, (_, k) => `${k + 1} ${k} 0`);
    const sets = Array.from({ length: 200 }, (_, k) => `${k + 1} ${2 * k + 1}\n ${2 * k + 2} -1`);
    writeFileSync(join(place, '200line400.gtsp'), ['NAME : 200line400', 'TYPE : GTSP', 'DIMENSION : 400', 'EDGE_WEIGHT_TYPE : EUC_2D', 'GTSP_SETS : 200', 'NODE_COORD_SECTION', ...nodes, 'GTSP_SET_SECTION :', ...sets, 'EOF', ''].join('\n'));
    writeFileSync(join(place, '3line6.gtsp'), LINE);
    const [instance, ...others] = instancesIn(place);
    assert.deepEqual([instance.name, instance.nodes, instance.sets, others], ['200line400', 400, 200, []]);
    assert.deepEqual(instancesIn(place, 'other'), []);
    const read = setsOf(parts(readFileSync(instance.path, 'latin1')));
    assert.deepEqual([read.length, read[0], read[199]], [200, [1, 2], [399, 400]]);
    const solved = spawnSync(process.execPath, [join(ROOT, 'dist', 'sdk', 'cli.js'), 'solve', instance.path, '--moves', '300000', '--seed', '1', '--json', '-'], { encoding: 'utf8' });
    assert.equal(solved.status, 0, solved.stderr);
    // From the last node of the first set to the first of the last, and back.
    assert.equal(JSON.parse(solved.stdout).length, 2 * 397);
  });

  it('takes the best tour of GLKH, if its length is that of its name', (t) => {
    const place = folder(t);
    const instance = { name: '3line6', nodes: 6, sets: 3, path: join(place, '3line6.gtsp') };
    writeFileSync(instance.path, LINE);
    const tour = ['NAME : line6.38.tour', 'TYPE : TOUR', 'DIMENSION : 3', 'TOUR_SECTION', '2', '3', '5', '-1', 'EOF', ''].join('\n');
    writeFileSync(join(place, '3line6.38.tour'), tour);
    writeFileSync(join(place, '3line6.more.30.tour'), tour);
    assert.deepEqual(published(instance, place), { by: 'GLKH', instance: '3line6', nodes: 6, sets: 3, value: 38, checked: 'coordinates' });
    renameSync(join(place, '3line6.38.tour'), join(place, '3line6.37.tour'));
    assert.throws(() => published(instance, place), /the tour is 38 long and not 37/);
    assert.throws(() => published({ ...instance, name: '3line7' }, place), /no tour of 3line7/);
  });

  it('adds the length of a tour up from the coordinates, and refuses what is no tour', () => {
    const instance = parts(LINE);
    assert.equal(lengthOf(instance, [2, 3, 5]), 9 + 10 + 19);
    assert.throws(() => lengthOf(instance, [2, 3, 4, 5]), /visits the set of node 4 twice/);
    assert.throws(() => lengthOf(instance, [2, 3]), /visits 2 of 3 sets/);
    assert.throws(() => lengthOf(instance, [2, 3, 7]), /a node 7, which the instance has not/);
  });

  it('refuses a run whose length is not that of its tour', (t) => {
    const path = join(folder(t), '3line6.gtsp');
    writeFileSync(path, LINE);
    assert.equal(checked(path, [2, 3, 5], 38), 38);
    assert.throws(() => checked(path, [2, 3, 5], 37), /the tour is 38 long and not 37/);
    const run = { seed: 2, trace: [[0, 50], [9, 40], [30, 38]], value: 38, memory: 1e6, tour: [2, 3, 5] };
    const line = lineOf({ by: 'kerfway', instance: '3line6', nodes: 6, sets: 3, path }, run, { seconds: 60, clock: 'wall' });
    assert.deepEqual([line.first, line.after, line.checked], [50, { 10: 40, 60: 38 }, 'coordinates']);
  });

  it('has LKH solve what is equivalent: the optimum of the transformed instance is that of the instance', NEEDS_NUMPY, (t) => {
    const place = folder(t);
    const [program, file, cost] = ['lkh', 'drawn.gtsp', 'cost'].map((name) => join(place, name));
    writeFileSync(program, `#!/bin/sh\nexec "${process.execPath}" "${join(ROOT, 'tests', 'package', 'exact-atsp.mjs')}" "$@"\n`);
    chmodSync(program, 0o755);
    for (let seed = 1; seed <= 8; seed++) {
      writeFileSync(file, drawn(seed));
      const instance = parts(drawn(seed));
      const { stdout, stderr, status } = spawnSync(python, [join(ROOT, 'benches', 'solve', 'lkh.py'), program, file, '--seconds', '1'], { encoding: 'utf8', env: { ...process.env, EXACT_COSTS: cost } });
      assert.equal(status, 0, stderr);
      const { tour, value } = JSON.parse(stdout);
      const best = optimum(instance);
      assert.equal(value, best, `seed ${seed}`);
      assert.equal(lengthOf(instance, tour), best, `seed ${seed}`);
      // Every set costs a way into it, which is twice the greatest cost and one.
      const { count, cost: between } = costs(instance);
      const nodes = Array.from({ length: count }, (_, k) => k);
      const way = 2 * Math.max(...nodes.flatMap((a) => nodes.filter((b) => b !== a).map((b) => between(a, b)))) + 1;
      assert.equal(Number(readFileSync(cost, 'utf8')), best + way * setsOf(instance).length, `seed ${seed}`);
    }
  });

  it('says so when LKH finds no tour', NEEDS_NUMPY, (t) => {
    const place = folder(t);
    const [program, file] = ['lkh', 'line.gtsp'].map((name) => join(place, name));
    writeFileSync(program, '#!/bin/sh\necho no memory >&2\nexit 1\n');
    chmodSync(program, 0o755);
    writeFileSync(file, LINE);
    assert.match(spawnSync(python, [join(ROOT, 'benches', 'solve', 'lkh.py'), program, file], { encoding: 'utf8' }).stderr, /found no tour: no memory/);
  });

  it('makes a table of medians, of the longest run of each seed', () => {
    const line = (seed, limit, after) => JSON.stringify({ by: 'kerfway', instance: '3line6', sets: 3, seed, limit, first: 50, after, value: Math.min(...Object.values(after)), memory: 2e6, checked: 'coordinates' });
    const lkh = JSON.stringify({ by: 'LKH', instance: '3line6', sets: 3, seed: 1, limit: 60, seconds: 71.4, value: 44, checked: 'coordinates' });
    const glkh = JSON.stringify({ by: 'GLKH', instance: '3line6', sets: 3, value: 40, checked: 'coordinates' });
    const lines = read([line(1, 60, { 10: 45, 60: 44 }), line(2, 60, { 10: 43, 60: 41 }), line(3, 60, { 10: 42, 60: 39 }), line(1, 600, { 10: 45, 60: 40, 600: 38 }), lkh, glkh, ''].join('\n'));
    assert.equal(markdown(lines).split('\n').at(-1), '| 3line6 | 3 | 1, 2, 3 | 50 | 43 | 40 | 38 | 38 | 40 | -5.000 % | 44 (10.000 %, 71 s) | 2 MB |');
  });

  it('made the table in benches/data/README.md of the runs in large.jsonl', () => {
    const data = (name) => readFileSync(join(ROOT, 'benches', 'data', name), 'utf8');
    assert.ok(data('README.md').includes(`\n${markdown(read(data('large.jsonl')))}\n`));
  });
});
