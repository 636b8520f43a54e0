// The lower bound of a sheet as it is shipped, in wasm: node bounds.mjs FILE SECONDS. Works on the proof alone, as the worker beside a search does,
// and prints a line of JSON: seconds of processor time and the bound of the air moves in mm then, whenever the time has doubled and at the end.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT } from '../../scripts/tools.mjs';

/** The sheets' layers that are not cut. */
const IGNORED = { layers: ['SHEET', 'MARK'].map((name) => ({ name, operation: 'ignore' })) };

/** Numbers of one call, as in `www/sdk/proving.ts`. */
const SLICE = 2_000_000;

const [file, seconds] = [process.argv[2], Number(process.argv[3])];
const at = join(ROOT, 'www', 'sdk', 'pkg');
const { Job, Proof, initSync } = await import(pathToFileURL(join(at, 'kerfway_research.js')).href);
initSync({ module: readFileSync(join(at, 'kerfway_research_bg.wasm')) });
const bytes = readFileSync(file);
const used = () => process.cpuUsage().user / 1e6;
// What every plan takes besides its air moves, which are all that the machine `length` counts in mm.
const job = new Job(bytes, 'sheet.dxf', IGNORED);
job.start({ seed: 1, moves: 1, machine: 'length' });
const { total_time, air_time } = job.best().summary;
const start = used();
const proof = new Proof(bytes, 'sheet.dxf', IGNORED, { seed: 1, machine: 'length' });
const trace = [];
for (let [more, next] = [true, 1]; more && used() - start < seconds; ) {
  more = proof.improve(SLICE);
  if (used() - start >= next || !more) {
    trace.push([used() - start, proof.seconds() - (total_time - air_time)]);
    next *= 2;
  }
}
trace.push([used() - start, proof.seconds() - (total_time - air_time)]);
console.log(JSON.stringify({ trace }));
