/**
 * The elements in templates of Vue 3. Tell its compiler that they are custom elements (`isCustomElement: (tag) => tag.startsWith('kerfway-')`):
 *
 *     import 'kerfway/element/vue';
 *     <kerfway-quote machine="co2-100w" :price="price" @result="(event) => show(event.detail)" />
 */

import type { HTMLAttributes, VNodeProps } from 'vue';
import type { ElementLabels, KerfwayPlanner, KerfwayQuote, PlannerEvents, QuoteEvents } from './index.js';

type Handlers<Events> = { [Name in keyof Events as `on${Capitalize<string & Name>}`]?: (event: Events[Name]) => void };

/** Attributes that both elements have. */
interface Planning {
  machine?: string;
  method?: string;
  units?: string;
  seconds?: number | string;
  moves?: number | string;
  seed?: number | string;
  workers?: number | string;
  labels?: Partial<ElementLabels>;
}

type Of<Events> = Omit<HTMLAttributes, keyof Handlers<Events>> & Handlers<Events> & Planning & VNodeProps;

/** The properties of `<kerfway-planner>`. */
export type PlannerProps = Of<PlannerEvents> & { options?: KerfwayPlanner['options'] };

/** The properties of `<kerfway-quote>`. */
export type QuoteProps = Of<QuoteEvents> & {
  options?: KerfwayQuote['options'];
  material?: string | KerfwayQuote['material'];
  thickness?: number | string;
  density?: number | string;
  price?: KerfwayQuote['price'];
};

declare module 'vue' {
  interface GlobalComponents {
    'kerfway-planner': new () => { $props: PlannerProps };
    'kerfway-quote': new () => { $props: QuoteProps };
    KerfwayPlanner: new () => { $props: PlannerProps };
    KerfwayQuote: new () => { $props: QuoteProps };
  }
}
