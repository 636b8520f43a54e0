// The lower bound of a sheet as it is shipped, in wasm: node bounds.mjs FILE SECONDS. Works on the proof alone, as the worker beside a search does,
// and prints a line of JSON: seconds of processor time and the bound of the air moves in mm then, whenever the time has doubled and at the end.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT } from '../../scripts/tools.mjs';
import { IGNORED } from '../common/data.mjs';

/** Numbers of one call, as in `www/sdk/proving.ts`. */
const SLICE = 2_000_000;

const [file, seconds] = [process.argv[2], Number(process.argv[3])];
const at = join(ROOT, 'www', 'sdk', 'pkg');
const { Job, Proof, initSync } = await import(pathToFileURL(join(at, 'kerfway_research.js')).href);
initSync({ module: readFileSync(join(at, 'kerfway_research_bg.wasm')) });
const [bytes, reading] = [readFileSync(file), { layers: IGNORED }];
const used = () => process.cpuUsage().user / 1e6;
// What every plan takes besides its air moves, which are all that the machine `length` counts in mm.
const job = new Job(bytes, 'sheet.dxf', reading);
job.start({ seed: 1, moves: 1, machine: 'length' });
const { total_time, air_time } = job.best().summary;
const start = used();
const proof = new Proof(bytes, 'sheet.dxf', reading, { seed: 1, machine: 'length' });
const trace = [];
const look = () => trace.push([used() - start, proof.seconds() - (total_time - air_time)]);
for (let next = 1; proof.improve(SLICE) && used() - start < seconds; ) {
  if (used() - start < next) continue;
  look();
  next *= 2;
}
look();
console.log(JSON.stringify({ trace }));
