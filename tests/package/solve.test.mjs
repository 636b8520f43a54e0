// The command `kerfway solve` on benchmark instances.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { folder, kerfway } from './support.mjs';

/** Towns in two rows, 10 apart: the shortest tour goes along one row and back along the other. */
const TOWNS = `NAME: row
TYPE: TSP
DIMENSION: 5
EDGE_WEIGHT_TYPE: EUC_2D
NODE_COORD_SECTION
1 0 0
2 40 0
3 10 0
4 30 0
5 20 0
EOF
`;

/** Three sets from 1 on; 3 has to come before 2, and the way against the clock costs ten times as much. */
const ORDERED = `NAME : own
TYPE : PCGLNS
DIMENSION : 4
GTSP_SETS : 3
EDGE_WEIGHT_TYPE : EXPLICIT
EDGE_WEIGHT_FORMAT : FULL_MATRIX
EDGE_WEIGHT_SECTION
0 1 5 20
10 0 1 9
30 10 0 1
1 30 10 0
GTSP_SET_SECTION
1 1 -1
2 2 -1
3 3 4 -1
GTSP_SET_ORDERING
3 2 -1
START_GROUP_SECTION
1
EOF
`;

function instance(t, name, text) {
  const path = join(folder(t), name);
  writeFileSync(path, text);
  return path;
}

async function solved(path, ...options) {
  const { code, stdout } = await kerfway('solve', path, '--json', '-', ...options);
  assert.equal(code, 0);
  return JSON.parse(stdout);
}

describe('kerfway solve', () => {
  it('finds the shortest tour and proves it optimal', async (t) => {
    const found = await solved(instance(t, 'row.tsp', TOWNS), '--moves', '500000', '--seed', '1');
    assert.equal(found.length, 80);
    assert.equal(found.lower_bound, 80);
    assert.deepEqual([...found.tour].sort(), [1, 2, 3, 4, 5]);
    assert.equal(found.name, 'row');
    assert.ok(found.moves <= 500_000 && found.seconds > 0);
  });

  it('respects the order of sets, and starts with the first', async (t) => {
    const found = await solved(instance(t, 'own.pcglns', ORDERED), '--moves', '100000', '--seed', '1');
    // 1 -> 3 -> 2 -> 1: 5 + 10 + 10; by node 4 it would be 20 + 30 + 10.
    assert.deepEqual([found.length, found.tour], [25, [1, 3, 2]]);
  });

  it('gives the same tour and its length for the same seed and moves', async (t) => {
    const path = instance(t, 'row.tsp', TOWNS);
    const [a, b] = await Promise.all([solved(path, '--moves', '9000', '--seed', '4'), solved(path, '--moves', '9000', '--seed', '4')]);
    assert.deepEqual(a.tour, b.tour);
    assert.match((await kerfway('solve', path, '--moves', '1000')).stdout, /row\.tsp: length 80, 5 stops/);
  });

  it('reported 1 stops', async (t) => {
    const one = instance(t, 'one.tsp', 'NAME: one\nTYPE: TSP\nDIMENSION: 1\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\nEOF\n');
    assert.match((await kerfway('solve', one, '--moves', '1')).stdout, /^one\.tsp: length 0, 1 stop; /);
  });

  it('refuses a faulty file with one sentence that names the place', async (t) => {
    const { code, stdout, stderr } = await kerfway('solve', instance(t, 'bad.tsp', TOWNS.replace('4 30 0', '4 x 0')));
    assert.deepEqual([code, stdout], [1, '']);
    assert.match(stderr, /^kerfway: .*bad\.tsp: Line 9: "x" is no number\.\n$/);
  });
});
