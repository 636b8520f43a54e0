/** What every entry point exports. Entry points differ only in how they read the wasm and start a worker. */

import { createFunctions, type Functions } from './functions.js';
import { checkPlaces } from './options.js';
import type { Configuration } from './places.js';
import type { Planner, PlannerOptions } from './planner.js';
import { plannerFactory, type Platform } from './planner-factory.js';
import { poolOf, type Pool, type PoolOptions } from './pool.js';
import { withNewPlanner } from './with-planner.js';

export interface Entry extends Functions {
  createPlanner(options?: PlannerOptions): Promise<Planner>;
  createPool(options?: PoolOptions): Pool;
  configure(configuration: Configuration): void;
}

/** The functions of an entry point. */
export function entry(platform: Platform): Entry {
  let configured: Configuration = {};
  const open = plannerFactory(platform);
  const createPlanner = (options: PlannerOptions = {}) => open({ ...configured, ...options });
  return {
    createPlanner,
    createPool: (options = {}) => {
      checkPlaces(options, true);
      const { size = platform.processors(), queue, deadline, ...places } = options;
      return poolOf(() => createPlanner(places), size, queue, deadline);
    },
    configure: (configuration) => {
      checkPlaces(configuration);
      configured = { ...configured, ...configuration };
    },
    ...createFunctions(withNewPlanner(createPlanner)),
  };
}
