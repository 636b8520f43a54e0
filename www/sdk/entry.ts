/** What every entry point exports. Entry points differ only in how they read the wasm and start a worker. */

import { createFunctions, type Functions } from './functions.js';
import { checkPlaces, given } from './options.js';
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

/** Opens planners on a platform. */
export function opening(platform: Platform): Pick<Entry, 'createPlanner' | 'configure'> {
  let configured: Configuration = {};
  const open = plannerFactory(platform);
  return {
    createPlanner: async (options = {}) => {
      checkPlaces(options);
      // What is undefined is not given: it must not hide what was configured.
      return open({ ...configured, ...given(options) });
    },
    configure: (configuration) => {
      checkPlaces(configuration);
      configured = { ...configured, ...given(configuration) };
    },
  };
}

/** What works with planners of its own. Nothing happens before the first call, so that a bundler may leave out what is not used. */
export function working({ createPlanner }: Pick<Entry, 'createPlanner'>, { processors }: Platform): Functions & Pick<Entry, 'createPool'> {
  return {
    createPool: (options = {}) => {
      checkPlaces(options, true);
      const { size = processors(), queue, deadline, ...places } = options;
      return poolOf(() => createPlanner(places), size, queue, deadline);
    },
    ...createFunctions(withNewPlanner(createPlanner)),
  };
}

/** The functions of an entry point. */
export function entry(platform: Platform): Entry {
  const planners = opening(platform);
  return { ...planners, ...working(planners, platform) };
}
