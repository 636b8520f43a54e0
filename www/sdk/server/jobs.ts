/** Answers one request for a drawing: the same work for a service of one machine and for the workers of a queue. */

import type { Functions } from '../functions.js';
import { inspectReport } from '../inspect-report.js';
import type { OutputKind } from '../protocol.js';
import { partThumbnail } from '../thumbnail.js';
import { outputsIn, type JobKind } from './request-options.js';

/** A drawing and what is wanted of it. It is plain data, except for the bytes. */
export interface Job {
  kind: JobKind;
  name: string;
  options: Record<string, unknown>;
  /** Size of the pictures of parts that `inspect` adds, in pixels; `null`: none. */
  thumbnails: number | null;
}

/** Does the work. The result is what the response has as JSON. */
export async function done(on: Functions, { kind, name, options, thumbnails }: Job, bytes: Uint8Array, signal: AbortSignal): Promise<object> {
  const named = { ...options, name, signal };
  if (kind === 'quote') return on.quote(bytes, named);
  if (kind === 'inspect') {
    const loaded = await on.inspect(bytes, named);
    const pictures = thumbnails === null ? {} : { thumbnails: Object.fromEntries(loaded.parts.map(({ outer }) => [outer, partThumbnail(loaded, outer, { size: thumbnails })])) };
    return { ...inspectReport(loaded), ...pictures };
  }
  const { loaded, path: _, beam: __, common: ___, outputs, ...planned } = await on.plan<OutputKind>(bytes, { ...named, outputs: outputsIn(options) });
  const asText = Object.entries(outputs).map(([of, data]) => [of, typeof data === 'string' ? data : Buffer.from(data).toString('base64')]);
  return { schema: 'kerfway.planned/1', input: { sha256: loaded.sha256, name: loaded.name }, ...planned, findings: [...loaded.findings, ...planned.findings], outputs: Object.fromEntries(asText) };
}
