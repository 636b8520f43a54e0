/** The report of a quote (`kerfway.quote/2`): see `quote.schema.json`. Lengths mm, areas mm2, times s, weights g. */

import type * as core from './generated/types.js';

export type { Limits, Material, Quote } from './generated/types.js';

/** What is stated about the job of a quote. */
export interface QuoteTerms extends Partial<core.QuoteTerms> {}
