/** The texts of the elements. A host in another language sets the property `labels`; what it leaves out stays English. */

import { duration, plural } from '../words.js';
import type { ErrorReport } from '../generated/types.js';
import type { Summary } from '../protocol.js';
import type { Quote } from '../quote.js';
import { facts } from './facts.js';

/** The texts of an element. Those that contain something are functions. */
export interface ElementLabels {
  /** Describes the picture, for screen readers. */
  picture: string;
  /** Asks for a file. */
  drop: string;
  choose: string;
  stop: string;
  /** The download: of G-code, or of the report. */
  download: string;
  again: string;
  /** While a file is read. */
  reading: (name: string) => string;
  /** When it has been read. */
  contours: (count: number) => string;
  /** During and after a search. `saved`: seconds less than as drawn, after the search. */
  job: (summary: Summary, saved: number | null) => string;
  /** A failure, from its code and what it names; `message` is the English sentence. */
  error: (error: ErrorReport) => string;
  /** The rows of a quote: term and figure. */
  facts: (quote: Quote) => [string, string][];
}

/** Savings below this many seconds are not shown: they round to 0.0 s. */
const LEAST_SAVING = 0.05;

/** The texts in English. `download` differs between the elements. */
export const ENGLISH: Omit<ElementLabels, 'download'> = {
  picture: 'The drawing with its cutting path',
  drop: 'Drop a drawing here',
  choose: 'Choose a file',
  stop: 'Stop',
  again: 'Another file',
  reading: (name) => `Reading ${name}`,
  contours: (count) => plural(count, 'contour'),
  job: ({ total_time, contours }, saved) => {
    const less = saved !== null && saved >= LEAST_SAVING ? `, ${duration(saved)} less than as drawn` : '';
    return `Job ${duration(total_time)}, ${plural(contours, 'contour')}${less}`;
  },
  error: ({ message }) => message,
  facts,
};
