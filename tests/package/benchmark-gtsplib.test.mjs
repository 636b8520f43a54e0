// The reference checker of the benchmark on files of GTSPLIB that are written in another way, or damaged, and on instances that are none.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { HERE } from '../../benchmark/instances.mjs';
import { checked, instanceOf, NEEDS_PYTHON, outline } from './reference-checker.mjs';
import { folder, kerfway } from './support.mjs';

const INSTANCE = `NAME: square
TYPE: GTSP
DIMENSION: 4
GTSP_SETS: 2
EDGE_WEIGHT_TYPE: EUC_2D
NODE_COORD_SECTION
1 0 0
2 10 0
3 0 10
4 0 100
GTSP_SET_SECTION
1 1 2 -1
2 3 4 -1
EOF
`;

/** What the planner says of the same file. */
const solved = async (instance) => (await kerfway('solve', instance, '--moves', '10', '--seed', '1')).stdout;

/** What check.py says of a tour for an instance in a file: its exit code, and a line. */
function tourChecked(t, text, tour) {
  const at = folder(t);
  const [instance, plan] = [join(at, 'own.gtsp'), join(at, 'plan.json')];
  writeFileSync(instance, text);
  writeFileSync(plan, JSON.stringify({ tour }));
  const { status, stdout, stderr } = spawnSync('python3', [join(HERE, 'check.py'), instance, plan], { encoding: 'utf8' });
  return { status, said: `${stdout}${stderr}`.trim(), instance };
}

describe('the reference checker, with an instance of GTSPLIB of somebody else', NEEDS_PYTHON, () => {
  it('accepted a tour that visits one of two sets, because both are in one line', (t) => {
    const text = INSTANCE.replace('-1\n2 3', '-1 2 3');
    assert.deepEqual([tourChecked(t, text, [1, 3]).said, tourChecked(t, text, [1]).said], ['20.000000', 'WRONG  not-visited: set 1 is not visited']);
  });

  it('dropped the first node of each further line of a set', (t) => {
    const text = INSTANCE.replace('2 3 4 -1', '2 3\n4 -1');
    assert.deepEqual([tourChecked(t, text, [1, 3]).said, tourChecked(t, text, [1, 4]).said], ['20.000000', '200.000000']);
  });

  it('took the places of nodes in the order of their lines, whatever their numbers', async (t) => {
    const text = INSTANCE.replace('4 0 100\n', '').replace('1 0 0', '4 0 100\n1 0 0');
    const { said, instance } = tourChecked(t, text, [1, 3]);
    assert.equal(said, '20.000000');
    assert.match(await solved(instance), /: length 20, 2 stops;/);
  });

  it('reads comments that name a section, tabs, and lines of Windows, as the planner does', async (t) => {
    for (const text of [INSTANCE.replace('TYPE', 'COMMENT: the NODE_COORD_SECTION is below, EOF at the end\nTYPE'), INSTANCE.replaceAll(': ', '\t:\t'), INSTANCE.replaceAll('\n', '\r\n')]) {
      const { said, instance } = tourChecked(t, text, [1, 3]);
      assert.equal(said, '20.000000', text);
      assert.match(await solved(instance), /: length 20, 2 stops;/);
    }
  });

  it('gave values for nodes in two sets or in none, other numbers of nodes, and nodes without a place, and a stack trace for numbers without end', (t) => {
    const damages = {
      'a node in two sets': ['2 3 4', '2 2 3 4'],
      'a node in no set': ['2 3 4 -1', '2 3 -1'],
      'a set without nodes': ['2 3 4 -1', '2 3 4 -1\n3 -1'],
      'a list that does not end': ['2 3 4 -1', '2 3 4'],
      'a dimension that is too small': ['DIMENSION: 4', 'DIMENSION: 3'],
      'a dimension that is too large': ['DIMENSION: 4', 'DIMENSION: 99999999999999999999'],
      'a node whose place is missing': ['4 0 100\n', ''],
      'a node with two places': ['4 0 100', '3 0 100'],
      'a place without end': ['4 0 100', '4 inf 100'],
      'a node without end': ['2 3 4', '2 3 1e999'],
    };
    for (const [what, [from, to]] of Object.entries(damages)) {
      const { status, said } = tourChecked(t, INSTANCE.replace(from, to), [1, 3]);
      assert.equal(status, 2, `${what}: ${said}`);
      assert.match(said, /^check\.py: \S+ is not an instance: [^\n]+$/, what);
    }
  });
});

describe('the reference checker', NEEDS_PYTHON, () => {
  it('showed a stack trace for a place in the list that is no whole number, and called every plan wrong where contours lie inside each other', (t) => {
    const [slot, other] = [outline([0, 0], [10, 0]), outline([0, 5], [10, 5])];
    for (const contours of [[slot, { ...other, inside: 0.5 }], [slot, { ...other, inside: true }], [{ ...slot, inside: 1 }, { ...other, inside: 0 }], [{ ...slot, inside: 0 }], [{ ...slot, closed: 'no' }]]) {
      const { status, text, stderr } = checked(t, instanceOf('CCP', ...contours), { moves: [] });
      assert.deepEqual([status, text], [2, '']);
      assert.match(stderr, /^check\.py: \S+ is not an instance: [^\n]+\n$/);
    }
  });

  it('ended with a stack trace where a name has characters that standard output has not, and left plans unchecked', (t) => {
    const at = folder(t);
    for (const name of ['\u00e4', 'z']) writeFileSync(join(at, `${name}.json`), '{}');
    const { status, stdout, stderr } = spawnSync('python3', [join(HERE, 'check.py'), at], { encoding: 'utf8', env: { ...process.env, PYTHONIOENCODING: 'ascii' } });
    assert.deepEqual([status, stderr], [1, '']);
    assert.deepEqual(stdout.trim().split('\n').map((line) => line.split(/ +/)[0]), ['z', '\\xe4']);
  });

  it('ended with a stack trace where the reader of its lines has gone, and its exit code was no verdict', { skip: process.platform === 'win32' && 'there is no shell' }, (t) => {
    const at = folder(t);
    for (const name of ['a', 'b', 'c']) writeFileSync(join(at, `${name}.json`), '{}');
    const words = ['-c', '{ python3 "$1" "$2"; echo "exit $?" >&2; } | true', 'sh', join(HERE, 'check.py'), at];
    assert.equal(spawnSync('/bin/sh', words, { encoding: 'utf8' }).stderr, 'exit 1\n');
  });
});
