/**
 * The elements in JSX of React 19, which sets properties and listens to events of custom elements:
 *
 *     import 'kerfway/element/react';
 *     <kerfway-quote machine="co2-100w" onresult={({ detail }) => show(detail)} />
 */

import type { HTMLAttributes, RefAttributes } from 'react';
import type { PlannerAttributes, QuoteAttributes } from './attributes.js';
import type { KerfwayPlanner, KerfwayQuote, PlannerEvents, QuoteEvents } from './index.js';

type Handlers<Events> = { [Name in keyof Events as `on${string & Name}`]?: (event: Events[Name]) => void };

type Of<Element, Events> = Omit<HTMLAttributes<Element>, keyof Handlers<Events>> & RefAttributes<Element> & Handlers<Events>;

/** The properties of `<kerfway-planner>`. */
export type PlannerProps = Of<KerfwayPlanner, PlannerEvents> & PlannerAttributes;

/** The properties of `<kerfway-quote>`. */
export type QuoteProps = Of<KerfwayQuote, QuoteEvents> & QuoteAttributes;

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'kerfway-planner': PlannerProps;
      'kerfway-quote': QuoteProps;
    }
  }
}
