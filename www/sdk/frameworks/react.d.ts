/**
 * The elements in JSX of React 19, which sets properties and listens to events of custom elements:
 *
 *     import 'kerfway/element/react';
 *     <kerfway-quote machine="co2-100w" onresult={({ detail }) => show(detail)} />
 */

import type { HTMLAttributes, RefAttributes } from 'react';
import type { ElementLabels, KerfwayPlanner, KerfwayQuote, PlannerEvents, QuoteEvents } from './index.js';

type Handlers<Events> = { [Name in keyof Events as `on${string & Name}`]?: (event: Events[Name]) => void };

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

type Of<Element, Events> = Omit<HTMLAttributes<Element>, keyof Handlers<Events>> & RefAttributes<Element> & Handlers<Events> & Planning;

/** The properties of `<kerfway-planner>`. */
export type PlannerProps = Of<KerfwayPlanner, PlannerEvents> & { options?: KerfwayPlanner['options'] };

/** The properties of `<kerfway-quote>`. `material` is its property if it is an object, and its attribute if it is a name. */
export type QuoteProps = Of<KerfwayQuote, QuoteEvents> & {
  options?: KerfwayQuote['options'];
  material?: string | KerfwayQuote['material'];
  thickness?: number | string;
  density?: number | string;
  price?: KerfwayQuote['price'];
};

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'kerfway-planner': PlannerProps;
      'kerfway-quote': QuoteProps;
    }
  }
}
