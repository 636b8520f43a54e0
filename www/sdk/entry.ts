/** What an entry point exports, the same on every host: they differ in how the wasm is read and how a worker starts. */

import { functionsOn, type Functions } from './functions.js';
import { lendingNew } from './lend.js';
import type { StartWorker } from './line.js';
import { opener } from './opener.js';
import type { Planner, PlannerOptions } from './planner.js';
import { poolOf, type Pool, type PoolOptions } from './pool.js';

export interface Entry extends Functions {
  createPlanner(options?: PlannerOptions): Promise<Planner>;
  createPool(options?: PoolOptions): Pool;
}

/** `processors`: what a pool works on at once when nobody says. */
export function entry(read: () => Promise<WebAssembly.Module>, start: StartWorker, processors: () => number): Entry {
  const createPlanner = opener(read, start);
  return {
    createPlanner,
    createPool: ({ size = processors(), queue } = {}) => poolOf(createPlanner, size, queue),
    ...functionsOn(lendingNew(createPlanner)),
  };
}
