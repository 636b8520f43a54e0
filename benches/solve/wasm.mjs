// One search in wasm, in a process of its own: node wasm.mjs FILE INDEX SEED SECONDS MOVES KNOWN [cpu]. One line of JSON out, as the
// native program prints. It ends as soon as KNOWN is reached, unless that is NaN.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { pathToFileURL } from 'node:url';
import { DIST } from '../../scripts/tools.mjs';

const [file, index, seed, seconds, moves, known, cpu] = process.argv.slice(2);
/** Moves between two looks at the value, about a quarter of a millisecond; and slices between two looks at the clock, which take time too. */
const SLICE = 5_000;
const SLICES = 8;

const at = join(DIST, 'bench-solve');
const bench = await import(pathToFileURL(join(at, 'solve.js')).href);
const { memory } = bench.initSync({ module: readFileSync(join(at, 'solve_bg.wasm')) });
const bytes = readFileSync(file);

// A first time to have the machine code ready, as in a worker that has planned before: V8 compiles what runs often once more, beside.
const WARM = 500_000;
const open = () => bench.Runner.open(file, bytes, Number(index), Number(seed));
const first = open();
for (let done = 0; done < WARM; done += SLICE) first.step(SLICE);
first.value();
await setTimeout(300);
/**
 * Seconds by the wall, or those this thread was on a processor, as Linux tells them: what V8 compiles and cleans up beside, in other
 * threads, is in neither. A thread's seconds are told up to the last time it left the processor: hence the nap.
 */
const nap = new Int32Array(new SharedArrayBuffer(4));
const clock = () => {
  if (cpu === undefined) return performance.now() / 1000;
  Atomics.wait(nap, 0, 0, 0.001);
  return Number(readFileSync('/proc/self/schedstat', 'latin1').split(' ')[0]) / 1e9;
};
const start = clock();
const now = () => clock() - start;
const runner = open();
let value = runner.cost();
const trace = [[now(), value]];
let [done, found] = [0, trace[0][0]];
const reached = () => value <= Number(known) + 1e-6;
for (let k = 1; done < Number(moves) && !reached(); k++) {
  if (k % SLICES === 0 && now() >= Number(seconds)) break;
  const work = Math.min(SLICE, Number(moves) - done);
  const came = runner.step(work);
  done += work;
  if (came === 1) {
    value = runner.cost();
    found = now();
    trace.push([found, value]);
  }
  if (came === 2) break;
}
const took = now();
// Checked at the end: at every improvement the check would take most of the time on 10,000 contours.
value = runner.value();
trace.push([found, value]);
const row = { seed: Number(seed), value, seconds: took, moves: done, found, reached: reached(), memory: memory.buffer.byteLength, trace };
console.log(JSON.stringify(row));
