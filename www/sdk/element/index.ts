/**
 * Custom elements for a host's page. `<kerfway-planner>` takes a drawing by drag and drop, plans it, shows the path while it gets faster, and offers
 * the G-code for download.
 *
 *     <script type="module" src="kerfway/dist/sdk/element/index.js"></script>
 *     <kerfway-planner machine="co2-100w" seconds="5"></kerfway-planner>
 *
 * Attributes: `machine`, `method`, `units`, `dpi`, `seconds`, `moves`, `seed`, `workers`, `allow-off-bed`, with the meaning of the options of `plan`. Other options
 * (layers, a machine profile) are set by the property `options`. Both are read when a drawing is opened.
 * State, for style rules: the attribute `state` is one of `empty`, `reading`, `planning`, `done`, `failed`.
 * CSS parts: `stage`, `contours`, `path`, `drop`, `bar`, `numbers`, `message`, `button` with `choose`, `stop`, `download`, `again`.
 * CSS properties: `--kerfway-text`, `-surface`, `-sheet`, `-line`, `-edge`, `-contour`, `-accent`, `-on-accent`, `-error`, `-radius`,
 * `-font`; light or dark follows `color-scheme`.
 *
 * `<kerfway-quote>` does the same for a price: it shows the figures of a quote and offers the report for download.
 *
 *     <kerfway-quote machine="co2-100w" thickness="3" density="7.85"></kerfway-quote>
 *
 * In addition it has the attributes `material`, `thickness` (mm) and `density` (g/cm3), or the property `material`; the property `price`, a
 * function of the report that returns the price in words; and the parts `report`, `term`, `figure`, `price`. Its `result` is the report
 * (`Quote`); the event `result` is dispatched again when the material changes. Without `seconds` or `moves` it plans a
 * number of moves that grows with the contours, with seed 1, which a server can repeat.
 *
 * @module kerfway/element
 */

import { createPlanner } from '../index.js';
import { defineElements } from './define.js';

export type { ElementLabels } from './labels.js';
export type { DrawingElement, DrawingEvents, ElementState } from './drawing.js';
export { KerfwayPlanner, type PlannerEvents, type PlannerState } from './planner.js';
export { KerfwayQuote, type QuoteEvents } from './quote.js';

defineElements(() => createPlanner());
