/**
 * Elements for a host's page. `<kerfway-planner>`: a place to drop a drawing that plans it, shows the path as it gets faster, and hands G-code out.
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
 *
 * `<kerfway-quote>`: the same for whoever wants a price: it shows the figures of a quote, and hands the report out.
 *
 *     <kerfway-quote machine="co2-100w" thickness="3" density="7.85"></kerfway-quote>
 *
 * Besides: attributes `material`, `thickness` (mm), `density` (g/cm3), or the property `material`; the property `price`, a function
 * of the report that says the price in words; parts `report`, `term`, `figure`, `price`. Its `result` is the report (`Quote`), told anew
 * when the material changes. Without `seconds` or `moves` it plans 100,000 moves of seed 1, which a server can do again.
 *
 * @module kerfway/element
 */

import { createPlanner } from '../index.js';
import { defineElements } from './define.js';

export type { DrawingElement, DrawingEvents, ElementState } from './drawing.js';
export { KerfwayPlanner, type PlannerEvents, type PlannerState } from './planner.js';
export { KerfwayQuote, type QuoteEvents } from './quote.js';

defineElements(() => createPlanner());
