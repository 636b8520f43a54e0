// The lower bounds of one instance in wasm, in a process of its own: node instance-bounds.mjs FILE KNOWN SECONDS. The walks with the orders that
// are left work until they end, and the flows in what is left of the seconds of the processor. One line of JSON: the bound of each, with
// its seconds. The bound by flows is the value that the check of its certificate gives; null where flows do not apply, or had no time.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { DIST } from '../../scripts/tools.mjs';

/** Numbers of one call, as in `www/sdk/proving.ts`. */
const SLICE = 2_000_000;
/** A bound this share below the best known value proves it optimal: the orders that are left are closed up to a ten-millionth. */
const PROVEN = 2e-7;

const [file, known, seconds] = [process.argv[2], Number(process.argv[3]), Number(process.argv[4])];
const at = join(DIST, 'bench-solve');
const { Bounds, initSync } = await import(pathToFileURL(join(at, 'solve.js')).href);
initSync({ module: readFileSync(join(at, 'solve_bg.wasm')) });
const used = () => process.cpuUsage().user / 1e6;
const start = used();
const bounds = Bounds.open(file, readFileSync(file), known);
while (used() - start < seconds && bounds.improveWalks(SLICE));
const walks = { bound: bounds.walks(), seconds: used() - start };
let flows = null;
if (walks.bound < known * (1 - PROVEN) && walks.seconds < seconds && bounds.startFlows()) {
  while (used() - start < seconds && bounds.improveFlows(SLICE));
  const bound = bounds.certified();
  if (bound !== undefined) flows = { bound, seconds: used() - start };
}
console.log(JSON.stringify({ walks, flows }));
