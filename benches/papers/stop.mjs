// How long a stop waits: the longest slice of each method in wasm, cut as a worker cuts them (www/sdk/slice.ts).

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from '../../scripts/build.mjs';
import { DIST } from '../../scripts/tools.mjs';
import { ms, table } from '../common/table.mjs';

/** As in www/sdk/search.ts. */
const SLICE_MS = 20;
/** Of each method on each sheet, ms: hundreds of slices, most of a generation on the largest. */
const WATCHED = 12_000;

export const tables = { stop };

async function stop({ only, instances }) {
  await build();
  const sdk = join(DIST, 'sdk');
  const [{ stepFor }, research] = await Promise.all(['slice.js', 'pkg/kerfway_research.js'].map((file) => import(join(sdk, file))));
  research.initSync({ module: readFileSync(join(sdk, 'pkg', 'kerfway_research_bg.wasm')) });
  for (const sheet of only === undefined ? ['sheet_500', 'sheet_10000'] : [only]) {
    const job = new research.Job(new Uint8Array(readFileSync(instances.file(`sheets/${sheet}.dxf`))), `${sheet}.dxf`, {});
    const lines = research.paperMethods().map(({ name }) => {
      const { times, round } = slices(job, name, stepFor);
      const at = (share) => ms(times[Math.min(Math.floor(times.length * share), times.length - 1)]);
      return [name, String(times.length), at(0.5), at(0.99), at(1), String(round)];
    });
    table(`Slices of ${sheet}, in wasm: a stop waits for one`, ['', 'slices', 'median', '99 of 100', 'longest', 'rounds'], lines);
    job.free();
  }
}

function slices(job, method, stepFor) {
  job.start({ method, parameters: '{}', seed: 1, moves: Number.MAX_SAFE_INTEGER, machine: 'co2-100w' });
  const times = [];
  const end = performance.now() + WATCHED;
  for (let work = 256; performance.now() < end; ) {
    const start = performance.now();
    const slice = stepFor(job, Math.round(work), SLICE_MS);
    const took = performance.now() - start;
    times.push(took);
    if (slice.end === 'exhausted') break;
    const fitting = ((slice.done / Math.max(took, 0.05)) * SLICE_MS) / work;
    work = Math.min(Math.max(work * Math.min(Math.max(fitting, 0.25), 4), 1), 1e9);
  }
  const { round } = job.insight();
  return { times: times.sort((a, b) => a - b), round };
}
