// Ctrl+C or SIGTERM while a command searches: the first one ends the search, and what it has found is written.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { copyFileSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { mulberry32 } from '../../benchmark/generate.mjs';
import { CLI, fixture, folder, KEYBOARD } from './support.mjs';

/** Says on standard error when the program begins to wait for Ctrl+C. */
const TELLS = `data:text/javascript,${encodeURIComponent("process.on('newListener', (event) => event === 'SIGINT' && process.stderr.write('[waits for Ctrl+C]'));")}`;

/** Runs the command line, and sends Ctrl+C a moment after it has begun to wait for it `times` times. */
const interrupted = (times, ...args) => signalled('SIGINT', times, ...args);

/** Runs the command line, and sends a signal a moment after it has begun to wait for Ctrl+C `times` times. */
async function signalled(name, times, ...args) {
  const child = spawn(process.execPath, ['--import', TELLS, CLI, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
  const out = { stdout: '', stderr: '' };
  const waits = () => out.stderr.split('[waits for Ctrl+C]').length - 1;
  child.stdout.on('data', (data) => (out.stdout += data));
  child.stderr.on('data', (data) => (out.stderr += data));
  const exited = once(child, 'exit');
  while (waits() < times && child.exitCode === null) await wait(5);
  await wait(100);
  child.kill(name);
  const [code, signal] = await Promise.race([exited, wait(30_000, ['still running', null], { ref: false })]);
  child.kill('SIGKILL');
  return { ...out, code, signal };
}

const plan = (...args) => ['plan', fixture(KEYBOARD), '--seed', '1', '--machine', 'fibre-3kw-thin', ...args];

describe('Ctrl+C', () => {
  it('ends the search of a plan, whose outputs are written', async (t) => {
    const at = folder(t);
    const [json, svg] = [join(at, 'a.json'), join(at, 'a.svg')];
    const { code, stdout, stderr } = await interrupted(1, ...plan('--seconds', '600', '--json', json, '--svg', svg));
    assert.equal(code, 0, stderr);
    const { summary, contours } = JSON.parse(readFileSync(json, 'utf8'));
    assert.deepEqual([summary.contours, contours.length], [60, 60]);
    assert.match(readFileSync(svg, 'utf8'), /<\/svg>\s*$/);
    const seconds = Number(/^Search .* moves in ([\d.]+) (?:s|ms)/m.exec(stdout)?.[1]);
    assert.ok(seconds < 1000 && !/moves in 600/.test(stdout), stdout);
  });

  it('while levers were compared, lost the plan', async (t) => {
    const json = join(folder(t), 'a.json');
    const { code, stdout, stderr } = await interrupted(2, ...plan('--seconds', '3', '--moving-pierce', '1', '--savings', '--json', json));
    assert.equal(code, 0, stderr);
    assert.match(stdout, /^Levers {5}not compared, because of Ctrl\+C$/m);
    const { summary, savings } = JSON.parse(readFileSync(json, 'utf8'));
    assert.deepEqual([summary.contours, savings], [60, []]);
  });

  it('lost the tour of a benchmark instance', async (t) => {
    const at = folder(t);
    const draw = mulberry32(5);
    const towns = Array.from({ length: 300 }, (_, k) => `${k + 1} ${draw() % 10_000} ${draw() % 10_000}`);
    writeFileSync(join(at, 'towns.tsp'), ['NAME: towns', 'TYPE: TSP', `DIMENSION: ${towns.length}`, 'EDGE_WEIGHT_TYPE: EUC_2D', 'NODE_COORD_SECTION', ...towns, 'EOF', ''].join('\n'));
    const json = join(at, 'towns.json');
    const { code, stdout, stderr } = await interrupted(1, 'solve', join(at, 'towns.tsp'), '--seconds', '600', '--seed', '1', '--json', json);
    assert.equal(code, 0, stderr);
    assert.ok(existsSync(json), stdout);
    const { tour, length, moves, seconds } = JSON.parse(readFileSync(json, 'utf8'));
    assert.deepEqual([new Set(tour).size, tour.length], [300, 300]);
    assert.ok(length > 0 && moves > 0 && seconds < 60, `${length} in ${seconds} s`);
  });
});

describe('SIGTERM', () => {
  it('lost the plan of a search, which is written, without a comparison of levers', async (t) => {
    const json = join(folder(t), 'a.json');
    const { code, stdout, stderr } = await signalled('SIGTERM', 1, ...plan('--seconds', '600', '--savings', '--json', json));
    assert.equal(code, 0, stderr);
    assert.match(stdout, /^Levers {5}not compared, because of SIGTERM$/m);
    const { summary, savings } = JSON.parse(readFileSync(json, 'utf8'));
    assert.deepEqual([summary.contours, savings], [60, []]);
  });

  it('leaves out the drawings after that of the search', async (t) => {
    const at = folder(t);
    for (const name of ['a', 'b', 'c']) copyFileSync(fixture(KEYBOARD), join(at, `${name}.dxf`));
    const { code, stderr } = await signalled('SIGTERM', 1, 'plan', `${at}/*.dxf`, '--seconds', '600', '--json', `${at}/`);
    assert.equal(code, 4, stderr);
    assert.deepEqual(stderr.match(/(?<=[/])\w\.dxf was left out: SIGTERM ended the command before\./g), [
      'b.dxf was left out: SIGTERM ended the command before.',
      'c.dxf was left out: SIGTERM ended the command before.',
    ]);
    assert.deepEqual(['a', 'b', 'c'].map((name) => existsSync(join(at, `${name}.json`))), [true, false, false]);
  });

  it('ends a command that watches, after its plan is written', async (t) => {
    const at = folder(t);
    const { signal, stderr } = await signalled('SIGTERM', 1, ...plan('--seconds', '600', '--watch', '--json', join(at, 'a.json')));
    assert.equal(signal, 'SIGTERM', stderr);
    assert.equal(JSON.parse(readFileSync(join(at, 'a.json'), 'utf8')).contours.length, 60);
  });
});
