/** Answers one request for a drawing: the same work for a service of one machine and for the workers of a queue. */

import { doubtAbout, hasProgram } from '../doubt.js';
import { KerfwayError } from '../errors.js';
import type { Functions, QuoteWithin } from '../functions.js';
import { inspectReport } from '../inspect-report.js';
import { reading } from '../options.js';
import type { Loaded, OutputKind } from '../protocol.js';
import { quoteBudget } from '../quote-budget.js';
import { thumbnailOf } from '../thumbnail.js';
import { outputsIn, type JobKind } from './request-options.js';

/** A drawing and what is wanted of it. It is plain data, except for the bytes. */
export interface Job {
  kind: JobKind;
  name: string;
  options: Record<string, unknown>;
  /** Size of the pictures of parts that `inspect` adds, in pixels; `null`: none. */
  thumbnails: number | null;
  /** Whether programs are written although the unit of the drawing is in doubt. */
  acceptGuess: boolean;
  /** The most moves of a quote that states no budget: its default grows with the drawing. */
  mostMoves?: number;
}

/** The most parts that get a picture, in the order of the report. More would keep the thread of the service busy for seconds. */
export const MOST_THUMBNAILS = 1000;

/** Does the work. The result is what the response has as JSON. */
export async function done(on: Functions, { kind, name, options, thumbnails, acceptGuess, mostMoves = Infinity }: Job, bytes: Uint8Array, signal: AbortSignal): Promise<object> {
  const named = { ...options, name, signal };
  if (kind === 'quote') {
    const quote: QuoteWithin = on.quote;
    return quote(bytes, named, (loaded) => within(quoteBudget(loaded), mostMoves));
  }
  if (kind === 'inspect') {
    const loaded = await on.inspect(bytes, named);
    const pictures = thumbnails === null ? {} : { thumbnails: picturesOf(loaded, thumbnails) };
    return { ...inspectReport(loaded), ...pictures };
  }
  const wanted = outputsIn(options);
  if (!acceptGuess && hasProgram(wanted)) refuseDoubt(await on.inspect(bytes, { ...reading(options), name, signal }));
  const { loaded, path: _, beam: __, common: ___, outputs, ...planned } = await on.plan<OutputKind>(bytes, { ...named, outputs: wanted });
  const asText = Object.entries(outputs).map(([of, data]) => [of, typeof data === 'string' ? data : Buffer.from(data).toString('base64')]);
  return { schema: 'kerfway.planned/1', input: { sha256: loaded.sha256, name: loaded.name }, ...planned, findings: [...loaded.findings, ...planned.findings], outputs: Object.fromEntries(asText) };
}

/** The budget with no more moves than these. */
const within = (budget: ReturnType<typeof quoteBudget>, most: number) => ({ ...budget, moves: Math.min(budget.moves, most) });

/** Pictures of the first parts, by the id of their outer contour. */
function picturesOf(loaded: Loaded, size: number): Record<string, string> {
  return Object.fromEntries(loaded.parts.slice(0, MOST_THUMBNAILS).map((part) => [part.outer, thumbnailOf(loaded, part, { size })]));
}

/** Refuses before the search, which may take a minute. */
function refuseDoubt(loaded: Loaded): void {
  const doubt = doubtAbout(loaded);
  if (doubt !== null) throw new KerfwayError('unwritable', `${doubt} No program is written while the unit is in doubt: state it by "units" or "dpi", or accept this guess by "acceptGuess".`);
}
