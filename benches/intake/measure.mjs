// One case in a process of its own, so that memory starts small: node measure.mjs CASE FILE RUNS. One line of JSON out:
// milliseconds of processor time of every run, what was found, and the wasm memory after the first run.

import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { DIST, ROOT } from '../../scripts/tools.mjs';

const [kind, file, count] = process.argv.slice(2);
const bytes = readFileSync(file);

/** The readers side by side, built by `intake.mjs`. */
async function readers() {
  const at = join(DIST, 'bench-intake');
  const bench = await import(pathToFileURL(join(at, 'intake.js')).href);
  const { memory } = bench.initSync({ module: readFileSync(join(at, 'intake_bg.wasm')) });
  return { ...bench, memory };
}

/** The planner as it is shipped. */
async function planner() {
  const at = join(ROOT, 'www', 'sdk', 'pkg');
  const shipped = await import(pathToFileURL(join(at, 'kerfway.js')).href);
  const { memory } = shipped.initSync({ module: readFileSync(join(at, 'kerfway_bg.wasm')) });
  return { ...shipped, memory };
}

/** Processor time: on a busy machine it says what a free one would take. */
function timed(stage) {
  const start = process.cpuUsage();
  const value = stage();
  const { user, system } = process.cpuUsage(start);
  return { ms: (user + system) / 1e3, value };
}

/** Runs a stage again and again; the memory is what the first run left, which never shrinks. */
function repeat(memory, stage) {
  const times = [];
  let found, first;
  for (let i = 0; i < Number(count); i++) {
    const run = timed(stage);
    times.push(run.ms);
    found = run.value;
    first ??= memory.buffer.byteLength;
  }
  return { times, found, memory: first };
}

const cases = {
  async kerfway() {
    const { memory, read_kerfway } = await readers();
    return repeat(memory, () => read_kerfway(bytes));
  },
  async dxf() {
    const { memory, read_dxf_crate } = await readers();
    return repeat(memory, () => read_dxf_crate(bytes));
  },
  async svg() {
    const { memory, read_svg } = await readers();
    return repeat(memory, () => read_svg(bytes));
  },
  async assemble() {
    const { memory, Read } = await readers();
    const read = Read.open(bytes);
    return repeat(memory, () => read.assemble());
  },
  /** From bytes to contours and parts, or to the sentence that refuses them. */
  async hostile() {
    const { memory, Job } = await planner();
    return repeat(memory, () => {
      try {
        const job = new Job(new Uint8Array(bytes), basename(file), {});
        const { contours, findings } = job.report();
        job.free();
        return `${contours.length} contours, ${findings.length} findings`;
      } catch (error) {
        return error.message ?? String(error);
      }
    });
  },
  /** From bytes to a first whole path, as the page does it; then a search of `MOVES` moves. */
  async plan() {
    const MOVES = 100_000;
    const { memory, Job } = await planner();
    const load = timed(() => new Job(new Uint8Array(bytes), basename(file), { ignoreOutline: true }));
    const job = load.value;
    const start = timed(() => job.start({ seed: 1, moves: MOVES, machine: 'co2-100w' }));
    const first = timed(() => job.best().summary);
    const search = timed(() => {
      while (job.step(2000).end === 'running');
    });
    const { summary } = job.best();
    return {
      load: load.ms,
      first: load.ms + start.ms + first.ms,
      contours: summary.contours,
      drawnSeconds: start.value.baselines.drawing.total_time,
      firstSeconds: first.value.total_time,
      search: search.ms,
      seconds: summary.total_time,
      memory: memory.buffer.byteLength,
    };
  },
};

console.log(JSON.stringify(await cases[kind]()));
