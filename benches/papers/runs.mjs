// Runs of one method on the instances of a file, natively.

import { join } from 'node:path';
import { ROOT, run } from '../../scripts/tools.mjs';
import { mean, rows } from '../common/table.mjs';

const HERE = join(ROOT, 'benches', 'solve');
/** One of the programs of benches/solve. */
export const native = (name) => join(HERE, 'target', 'release', name);
const NATIVE = native('papers');

export function build() {
  console.log('bench: the methods of papers, natively');
  run('cargo', ['build', '--release', '--manifest-path', join(HERE, 'Cargo.toml'), ...['papers', 'hull', 'yang'].flatMap((bin) => ['--bin', bin])]);
}

/** A run for each seed: its length, the round that found it, the best length known. */
export function runs(method, file, { parameters = {}, only, seeds, seconds }) {
  const args = [method, file, '--parameters', JSON.stringify(parameters), '--seeds', String(seeds)];
  if (only !== undefined) args.push('--only', only);
  if (seconds !== undefined) args.push('--seconds', String(seconds));
  return rows(NATIVE, args);
}

/** Runs that came to an allowed tour; swarms may miss the edge that an instance fixes. */
const lengths = (list) => list.flatMap((r) => (r.length === null ? [] : [r.length]));
export const best = (list) => Math.min(...lengths(list));
export const average = (list) => mean(lengths(list));

/** Above the best value known, in %. */
export const above = (length, known) => (100 * (length - known)) / known;
export const percent = (value) => (Number.isFinite(value) ? `${value.toFixed(3)} %` : 'none');
