// Runs of the search and of the lower bound on an instance, natively and in wasm, each in a process of its own, and runs of other solvers.

import { basename, join } from 'node:path';
import { ROOT, Stop } from '../../scripts/tools.mjs';
import { rows } from '../common/table.mjs';

export const HERE = join(ROOT, 'benches', 'solve');
export const NATIVE = join(HERE, 'target', 'release', 'kerfway-bench-solve');
const BOUND = join(HERE, 'target', 'release', 'bound');
const BASELINES = join(HERE, 'baselines.py');
export const PYTHON = process.env.KERFWAY_PYTHON ?? 'python3';

/** Runs every seed natively. Returns the instances of a file, each with its runs. */
export function natively(file, { seconds, seeds, cpu = false }, ...more) {
  const args = [file, '--seconds', String(seconds), '--seeds', String(seeds), '--json', ...(cpu ? ['--cpu'] : []), ...more];
  const all = rows(NATIVE, args);
  return [...new Set(all.map((row) => row.instance))].map((name, index) => {
    const runs = all.filter((row) => row.instance === name);
    return { name, index, known: runs[0].known, items: runs[0].items, runs };
  });
}

/** Runs one seed in wasm. */
export function inWasm(file, { index, known }, seed, { seconds, cpu = false }, moves = Infinity) {
  const numbers = [index, seed, seconds, moves, known ?? NaN].map(String);
  return rows(process.execPath, [join(HERE, 'wasm.mjs'), file, ...numbers, ...(cpu ? ['cpu'] : [])])[0];
}

/** The best value of a run after some seconds. */
export function at(run, seconds) {
  return run.trace.findLast(([s]) => s <= seconds)?.[1] ?? run.trace[0][1];
}

/** The lines that the program of the lower bound prints for a file, without those about certificates. */
export function boundsOf(file, ...args) {
  return rows(BOUND, [file, ...args]).filter((row) => row.bound !== undefined);
}

/** The lower bound that is proven for each instance of a file within some seconds, natively. */
export function proven(file, seconds) {
  return new Map(boundsOf(file, '--seconds', String(seconds)).map((row) => [row.instance, row.bound]));
}

/** How far a value is above the proven bound. */
export const off = (value, bound) => (bound > 0 ? `${((100 * Math.max(0, value - bound)) / bound).toFixed(2)} %` : 'none');
export const percent = (value, known) => (known === null ? '' : `${((100 * (value - known)) / known).toFixed(3)} %`);

/** The result of another solver; `undefined` if it cannot solve the instance (two of them need a set of one node to start from). */
export const baseline = (file, solver, seconds) => firstRow(PYTHON, [BASELINES, file, '--seconds', String(seconds), '--solver', solver], `${solver} on ${basename(file)}`);

/** The first row that a program of others prints; `undefined`, with the reason printed, if it fails. */
export function firstRow(command, args, what) {
  try {
    return rows(command, args)[0];
  } catch (e) {
    if (!(e instanceof Stop)) throw e;
    console.log(`bench: ${what}: ${e.message.trim().split('\n').at(-1)}`);
    return undefined;
  }
}
