// Kerfway's plans for instances of the benchmark.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gunzipSync } from 'node:zlib';
import { DIST, ROOT } from '../scripts/tools.mjs';
import { asDxf } from './drawing.mjs';
import { Trace } from './trace.mjs';

/** A machine without anything but what an instance charges for. */
function machine({ track, cost, home, closed }) {
  const timed = cost.unit === 's';
  const rapid = timed ? { speed: [cost.speed, cost.speed], accel: [cost.acceleration, cost.acceleration] } : { speed: [1, 1], accel: null };
  const base = { version: 1, name: 'benchmark', title: 'Benchmark', home, return_home: closed, travel: 'vector', rapid, pierce_time: cost.pierce };
  const rest = { cut: { speed: 1, accel: null, power: 1 }, mark: { speed: 1, accel: null, power: 0.1 }, junction_deviation: null };
  // A machine whose pre-cuts cost nothing may leave contours unfinished.
  return { ...base, ...rest, pre_cut_time: track === 'ECP' || track === 'ICP' ? 0 : null, beam_on_delay: 0, beam_off_delay: 0, dialect: 'grbl-m4', max_s: 1000 };
}

/**
 * A plan for an instance, with its lower bound if there is one, and a trace of an instance that is cut; budget: `seconds` or `moves`.
 * `prove`: the budget of a thread of its own that works on the bound, `seconds` or `work`.
 */
export async function solved(instance, { prove, ...budget }, seed = 1) {
  if (instance.gtsplib) return tour(instance, budget, seed);
  const reading = { keepBorder: true, commonCuts: 'off', joinTolerance: 1e-5, copyTolerance: 1e-5, tolerance: 1e-5 };
  // The default method stops anywhere on a contour; the method of the paper can be told to stop at ends of lines and arcs only.
  const at = instance.track === 'ECP' ? { method: 'partition-tree', parameters: { nodes: 'element-ends' } } : { method: 'tour-tree' };
  const planner = await (await kerfway()).createPlanner();
  try {
    await planner.load(Buffer.from(asDxf(instance)), 'instance.dxf', reading);
    const trace = new Trace();
    const run = planner.plan({ machine: machine(instance), ...at, seed, ...budget }, ({ summary }) => trace.found(summary));
    await run.started;
    const proof = prove === undefined ? null : planner.prove(prove, (seconds) => trace.proven(seconds)).done;
    const [, proven] = await Promise.all([run.done, proof]);
    const { moves, summary } = JSON.parse(await planner.output('json'));
    trace.found(summary);
    trace.proven(proven?.seconds ?? 0);
    return { trace, plan: { by: `kerfway ${at.method}, seed ${seed}`, moves }, bound: trace.bound };
  } finally {
    planner.close();
  }
}

const kerfway = () => import(pathToFileURL(join(DIST, 'sdk', 'node.js')).href);

/** The plan document of a drawing. */
export async function planned(bytes, options) {
  const { plan } = await kerfway();
  return JSON.parse((await plan(bytes, { ...options, outputs: ['json'] })).outputs.json);
}

/** A tour of an instance of GTSPLIB, by the command line. */
function tour({ gtsplib }, { seconds, moves }, seed) {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  const file = join(folder, 'instance.gtsp');
  writeFileSync(file, gunzipSync(readFileSync(join(ROOT, 'benchmark', gtsplib))));
  const budget = moves === undefined ? ['--seconds', seconds] : ['--moves', moves];
  const out = execFileSync('node', [join(DIST, 'sdk', 'cli.js'), 'solve', file, ...budget.map(String), '--seed', String(seed), '--json', '-'], { stdio: ['ignore', 'pipe', 'ignore'] });
  rmSync(folder, { recursive: true });
  const { tour: nodes, lower_bound: bound } = JSON.parse(out);
  return { plan: { by: `kerfway tour-tree, seed ${seed}`, tour: nodes }, bound: bound ?? 0 };
}
