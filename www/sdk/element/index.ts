/**
 * `<kerfway-planner>`: a place to drop a drawing that plans it, shows the path as it gets faster, and hands G-code out.
 *
 *     <script type="module" src="kerfway/dist/sdk/element/index.js"></script>
 *     <kerfway-planner machine="co2-100w" seconds="5"></kerfway-planner>
 *
 * Attributes: `machine`, `method`, `units`, `seconds`, `moves`, `seed`, `workers`, as in the options of `plan`; what is no text
 * (layers, a machine of one's own) goes into the property `options`. Both are read when a drawing is opened.
 * State, for styles: the attribute `state`, one of `empty`, `reading`, `planning`, `done`, `failed`.
 * Parts: `stage`, `contours`, `path`, `drop`, `bar`, `numbers`, `message`, `button` with `choose`, `stop`, `download`, `again`.
 * Properties for CSS: `--kerfway-text`, `-surface`, `-sheet`, `-line`, `-edge`, `-contour`, `-accent`, `-on-accent`, `-error`, `-radius`,
 * `-font`; light or dark follows `color-scheme`.
 */

import { createPlanner } from '../index.js';
import { definePlanner } from './element.js';

export { KerfwayPlanner, type PlannerEvents, type PlannerState } from './element.js';

definePlanner(() => createPlanner());
