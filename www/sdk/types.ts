/** What both entry points, `index.ts` and `node.ts`, export besides their functions. */

export { Planner, type PlannerOptions } from './planner.js';
export type { PlanHandle, PlanResult, Started } from './plan-handle.js';
export type { Functions, Outputs, Planned, PlanRun } from './functions.js';
export type { Bytes, CheckOptions, InspectOptions, JobOptions, PlanJobOptions, PlanningOptions, QuoteOptions, RenderOptions, Source } from './options.js';
export type { Pool, PoolOptions } from './pool.js';
export type * from './protocol.js';
export type { Material, Quote } from './quote.js';
export { ANCHORS, pointOf } from './anchors.js';
export { activeContours } from './contours.js';
export { tooLarge } from './size.js';
