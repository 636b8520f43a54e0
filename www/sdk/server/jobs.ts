/** Answers one request for a drawing: the same work for a service of one machine and for the workers of a queue. */

import { doubtAbout, hasProgram } from '../doubt.js';
import { KerfwayError } from '../errors.js';
import type { Functions } from '../functions.js';
import { inspectReport } from '../inspect-report.js';
import { reading } from '../options.js';
import type { Loaded, OutputKind } from '../protocol.js';
import { partThumbnail } from '../thumbnail.js';
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
}

/** Does the work. The result is what the response has as JSON. */
export async function done(on: Functions, { kind, name, options, thumbnails, acceptGuess }: Job, bytes: Uint8Array, signal: AbortSignal): Promise<object> {
  const named = { ...options, name, signal };
  if (kind === 'quote') return on.quote(bytes, named);
  if (kind === 'inspect') {
    const loaded = await on.inspect(bytes, named);
    const pictures = thumbnails === null ? {} : { thumbnails: Object.fromEntries(loaded.parts.map(({ outer }) => [outer, partThumbnail(loaded, outer, { size: thumbnails })])) };
    return { ...inspectReport(loaded), ...pictures };
  }
  const wanted = outputsIn(options);
  if (!acceptGuess && hasProgram(wanted)) refuseDoubt(await on.inspect(bytes, { ...reading(options), name, signal }));
  const { loaded, path: _, beam: __, common: ___, outputs, ...planned } = await on.plan<OutputKind>(bytes, { ...named, outputs: wanted });
  const asText = Object.entries(outputs).map(([of, data]) => [of, typeof data === 'string' ? data : Buffer.from(data).toString('base64')]);
  return { schema: 'kerfway.planned/1', input: { sha256: loaded.sha256, name: loaded.name }, ...planned, findings: [...loaded.findings, ...planned.findings], outputs: Object.fromEntries(asText) };
}

/** Refuses before the search, which may take a minute. */
function refuseDoubt(loaded: Loaded): void {
  const doubt = doubtAbout(loaded);
  if (doubt !== null) throw new KerfwayError('unwritable', `${doubt} No program is written while the unit is in doubt: state it by "units" or "dpi", or accept this guess by "acceptGuess".`);
}
