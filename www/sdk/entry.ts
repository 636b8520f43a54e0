/** What every entry point exports. Entry points differ only in how they read the wasm and start a worker. */

import { createFunctions, type Functions } from './functions.js';
import type { Planner, PlannerOptions } from './planner.js';
import { plannerFactory } from './planner-factory.js';
import { poolOf, type Pool, type PoolOptions } from './pool.js';
import { withNewPlanner } from './with-planner.js';
import type { StartWorker } from './worker-connection.js';
import type { WasmModule } from './wasm-module.js';

export interface Entry extends Functions {
  createPlanner(options?: PlannerOptions): Promise<Planner>;
  createPool(options?: PoolOptions): Pool;
}

/** The functions of an entry point. `processors` gives the default size of a pool. */
export function entry(read: () => Promise<WasmModule>, start: StartWorker, processors: () => number): Entry {
  const createPlanner = plannerFactory(read, start);
  return {
    createPlanner,
    createPool: ({ size = processors(), queue } = {}) => poolOf(createPlanner, size, queue),
    ...createFunctions(withNewPlanner(createPlanner)),
  };
}
