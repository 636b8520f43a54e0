// A perforated sheet in the planner as it is shipped: node holes.mjs COUNT SECONDS. Draws COUNT round holes of several sizes in rows that are
// not quite even, plans them in slices of about 20 ms as a worker does, and prints one line of JSON: seconds of processor time until
// the drawing is read and until the first path, the mm of air at `MARKS` seconds of search, and the wasm memory.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT } from '../../scripts/tools.mjs';
import { drawing } from '../common/dxf.mjs';
import { Random } from '../dewil/random.mjs';

/** Seconds of search at which the path is measured. */
export const MARKS = [0, 2, 10, 60];
/** Milliseconds of a slice, as in `www/sdk/search.ts`. */
const SLICE = 20;
/** Most moves of a slice. */
const MOST = 1e6;
/** Distance of the holes, mm. */
const PITCH = 9.5;

function holes(count) {
  const random = new Random(5);
  const side = Math.ceil(Math.sqrt(count));
  const off = () => PITCH * (0.5 * random.even() - 0.25);
  const one = (k) => [
    ...['0', 'CIRCLE', '8', 'CUT', '10', PITCH * (k % side) + off(), '20', PITCH * Math.floor(k / side) + off()],
    ...['40', 0.5 + 1.5 * random.even()],
  ];
  return new TextEncoder().encode(drawing(Array.from({ length: count }, (_, k) => one(k)).flat()));
}

if (process.argv[1] === import.meta.filename) {
  const [count, seconds] = process.argv.slice(2).map(Number);
  const at = join(ROOT, 'www', 'sdk', 'pkg');
  const { Job, initSync } = await import(pathToFileURL(join(at, 'kerfway.js')).href);
  const { memory } = initSync({ module: readFileSync(join(at, 'kerfway_bg.wasm')) });
  const bytes = holes(count);
  const used = () => process.cpuUsage().user / 1e6;
  const start = used();
  const job = new Job(bytes, 'holes.dxf', {});
  const read = used() - start;
  job.start({ seed: 1, seconds, machine: 'length' });
  const air = [job.best().summary.air_length];
  const first = used() - start;
  const begin = used();
  for (let work = 256; air.length < MARKS.length && MARKS[air.length] <= seconds; ) {
    const before = performance.now();
    job.step(Math.round(work));
    // Slices that only tidy up take next to no time.
    work = Math.min(MOST, Math.max(256, (work * SLICE) / Math.max(0.1, performance.now() - before)));
    if (used() - begin >= MARKS[air.length]) air.push(job.best().summary.air_length);
  }
  console.log(JSON.stringify({ read, first, air, memory: memory.buffer.byteLength }));
}
