/** The report of a quote (`kerfway.quote/1`): see `quote.schema.json`. Lengths mm, areas mm2, times s, weights g. */

export type { Material, Quote } from './generated/types.js';
