/** The attributes and properties that frameworks may set on the elements: `frameworks/react.d.ts` and `frameworks/vue.d.ts` add the events. */

import type { ElementLabels } from './labels.js';
import type { KerfwayPlanner } from './planner.js';
import type { KerfwayQuote } from './quote.js';

/** Those of both elements. */
interface Planning {
  machine?: string;
  method?: string;
  units?: string;
  dpi?: number | string;
  seconds?: number | string;
  moves?: number | string;
  seed?: number | string;
  workers?: number | string;
  'allow-off-bed'?: boolean | '';
  labels?: Partial<ElementLabels>;
}

/** Those of `<kerfway-planner>`. */
export interface PlannerAttributes extends Planning {
  options?: KerfwayPlanner['options'];
}

/** Those of `<kerfway-quote>`. `material` is its property if it is an object, and its attribute if it is a name. */
export interface QuoteAttributes extends Planning {
  options?: KerfwayQuote['options'];
  material?: string | KerfwayQuote['material'];
  thickness?: number | string;
  density?: number | string;
  price?: KerfwayQuote['price'];
}
