/** `kerfway solve`: solves a benchmark instance (TSPLIB, GTSPLIB, PCGTSP) with the default method. */

import { oneWord, parsed, seconds, whole } from './arguments.js';
import { DEFAULT_SECONDS } from '../options.js';
import { Destinations, outputsOf } from './destinations.js';
import { untilInterrupted } from './interrupt.js';
import { bytesOf, nameOf, subject, Unusable } from './io.js';
import { say } from './report.js';
import { loadedResearch } from './research.js';
import { elapsed, percentAtMost, plural } from '../words.js';

/** Moves between two checks of the clock, which take a few milliseconds. */
const SLICE = 20_000;

/** The document that `--json` writes. */
interface Solved {
  name: string;
  length: number;
  tour: number[];
  seconds: number;
  moves: number;
  seed: number;
  lower_bound: number | null;
}

export async function solve(args: string[]): Promise<void> {
  const given = parsed('solve', args, 'a .tsp, .gtsp or .pcglns file');
  const file = oneWord(given);
  const { values } = given;
  const moves = whole(values, 'moves');
  const limit = seconds(values);
  const seed = whole(values, 'seed') ?? Math.floor(Math.random() * 2 ** 32);
  const outputs = outputsOf(given, ['json']);
  const destinations = new Destinations(outputs);
  destinations.begin([file]);
  const found = await searched(file, seed, moves ?? Infinity, limit ?? (moves === undefined ? DEFAULT_SECONDS : Infinity));
  const data = `${JSON.stringify(found)}\n`;
  await destinations.write(file, outputs.map((output) => ({ output, data })));
  await say([
    `${nameOf(file)}: length ${found.length}, ${plural(found.tour.length, 'stop')}; ${proven(found)}`,
    `Search     seed ${seed}, ${plural(found.moves, 'move')} in ${elapsed(found.seconds)}`,
  ], destinations.piped);
}

function proven({ length, lower_bound: bound }: Solved): string {
  if (bound === null || bound <= 0) return 'no lower bound';
  if (bound >= length) return 'optimal';
  return `at most ${percentAtMost((length - bound) / bound)} above the optimum`;
}

async function searched(file: string, seed: number, moves: number, limit: number): Promise<Solved> {
  const bytes = await bytesOf(file);
  const research = await loadedResearch();
  const start = performance.now();
  const passed = () => (performance.now() - start) / 1000;
  let solving;
  try {
    solving = new research.Solving(bytes, seed);
  } catch (error) {
    throw new Unusable(`${subject(file)}: ${(error as Error).message}`);
  }
  let interrupted = false;
  await untilInterrupted(() => (interrupted = true), async () => {
    while (!interrupted && solving.moves() < moves && passed() < limit) {
      if (!solving.step(Math.min(SLICE, moves - solving.moves()))) break;
      // Signals are handled between two slices.
      await new Promise((resume) => setImmediate(resume));
    }
  });
  const tour = [...solving.tour()];
  return {
    name: solving.name(),
    length: solving.length(),
    tour,
    seconds: passed(),
    moves: solving.moves(),
    seed,
    lower_bound: solving.lowerBound() ?? null,
  };
}
