/**
 * The elements in templates of Vue 3. Tell its compiler that they are custom elements (`isCustomElement: (tag) => tag.startsWith('kerfway-')`):
 *
 *     import 'kerfway/element/vue';
 *     <kerfway-quote machine="co2-100w" :price="price" @result="(event) => show(event.detail)" />
 */

import type { HTMLAttributes, VNodeProps } from 'vue';
import type { PlannerAttributes, QuoteAttributes } from './attributes.js';
import type { PlannerEvents, QuoteEvents } from './index.js';

type Handlers<Events> = { [Name in keyof Events as `on${Capitalize<string & Name>}`]?: (event: Events[Name]) => void };

type Of<Events> = Omit<HTMLAttributes, keyof Handlers<Events>> & Handlers<Events> & VNodeProps;

/** The properties of `<kerfway-planner>`. */
export type PlannerProps = Of<PlannerEvents> & PlannerAttributes;

/** The properties of `<kerfway-quote>`. */
export type QuoteProps = Of<QuoteEvents> & QuoteAttributes;

declare module 'vue' {
  interface GlobalComponents {
    'kerfway-planner': new () => { $props: PlannerProps };
    'kerfway-quote': new () => { $props: QuoteProps };
    KerfwayPlanner: new () => { $props: PlannerProps };
    KerfwayQuote: new () => { $props: QuoteProps };
  }
}
