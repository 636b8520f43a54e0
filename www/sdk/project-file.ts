/** Reads and writes project files, and refuses what cannot be used in one sentence. What a project is: see `project.ts`. */

import { base64 } from './base64.js';
import { readBytes, viewed, type Bytes } from './bytes.js';
import { isRecord, shown } from './check.js';
import { KerfwayError, notBytes } from './errors.js';
import { checkOptions } from './options.js';
import { asJson, withWarmPath } from './plain-data.js';
import type { Project, SavedPlan } from './project.js';
import { checkSize, endless, MAX_BYTES } from './size.js';
import type { WarmPath } from './protocol.js';

const SCHEMA = 'kerfway.project/1';

/** The text of a project file. Throws a `KerfwayError` for what `readProject` would refuse. */
export async function writeProject(project: Project): Promise<string> {
  const unwritable: Refusal = (why) => new KerfwayError('wrong-type', `This project cannot be written: ${why}.`);
  if (!isRecord(project)) throw unwritable('it is no object');
  const { name, reading, planning, plan } = project;
  const bytes = viewed(project.drawing);
  if (bytes === null) throw notBytes();
  const document = JSON.parse(JSON.stringify(asJson({ schema: SCHEMA, name, reading, planning, plan }))) as Record<string, unknown>;
  checked(document, unwritable);
  // A copy, because a blob takes no memory that threads share.
  const packed = await through(new Uint8Array(bytes).slice(), new CompressionStream('gzip'), Infinity);
  return `${JSON.stringify({ ...document, drawing: base64(packed) })}\n`;
}

/**
 * Reads a project file. Throws a `KerfwayError` with one sentence if something in it is missing, of another type or out of
 * range. Whether the plan fits the drawing is checked when it is used.
 */
export async function readProject(file: Bytes): Promise<Project> {
  const { bytes } = await readBytes(file);
  checkSize(bytes.byteLength);
  const document = parsed(bytes);
  const { schema, drawing } = document;
  if (schema !== SCHEMA) throw unusable(`it is of the kind ${typeof schema === 'string' ? schema : shown(schema)}, and this version reads ${SCHEMA}`);
  if (typeof drawing !== 'string') throw unusable('its name or its drawing is missing');
  return { ...checked(document, unusable), drawing: await unpacked(drawing) };
}

/** The error for a project that cannot be used, with the reason. */
type Refusal = (why: string) => KerfwayError;

/** What a project says besides its drawing. */
function checked({ name, reading, planning, plan }: Record<string, unknown>, refusal: Refusal): Omit<Project, 'drawing'> {
  if (typeof name !== 'string') throw refusal('its name or its drawing is missing');
  if (!isRecord(reading) || !isRecord(planning)) throw refusal('what was decided about its drawing is missing');
  checkOptions(reading, 'load');
  checkOptions(planning, 'planning');
  return { name, reading, planning, plan: plan === null || plan === undefined ? null : savedPlan(plan, refusal) };
}

function parsed(bytes: ArrayBuffer | Uint8Array): Record<string, unknown> {
  try {
    const value: unknown = JSON.parse(new TextDecoder().decode(bytes));
    if (isRecord(value)) return value;
  } catch {}
  throw unusable('it is not JSON, or only a part of it');
}

function savedPlan(value: unknown, refusal: Refusal): SavedPlan {
  if (!isRecord(value) || !isRecord(value['path'])) throw refusal('its plan has no path');
  const { seed, moves, seconds, total_time, lower_bound = 0, done, path, curve } = value;
  const { at, total } = isRecord(curve) ? curve : {};
  const isNumbers = (list: unknown): list is number[] => Array.isArray(list) && list.every((n) => Number.isFinite(n) && (n as number) >= 0);
  if (!isNumbers([seed, moves, seconds, total_time, lower_bound]) || !isNumbers(at) || !isNumbers(total) || at.length !== total.length) throw refusal('a number of its plan is missing');
  const options = withWarmPath({ seed: seed as number, warm: path as unknown as WarmPath });
  checkOptions(options, 'planning');
  return { seed, moves, seconds, total_time, lower_bound, done: done === true, curve: { at, total }, path: options.warm } as SavedPlan;
}

async function unpacked(text: string): Promise<Uint8Array> {
  try {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return await through(packed, new DecompressionStream('gzip'), MAX_BYTES);
  } catch (error) {
    throw error instanceof KerfwayError ? error : unusable('its drawing is damaged');
  }
}

/** What a stream makes of bytes, refused beyond a size: a small file may hold a drawing that fills the memory. */
async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array> {
  const made = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(stream);
  const chunks: BlobPart[] = [];
  let length = 0;
  const reader = made.getReader();
  for (let { done, value } = await reader.read(); !done; { done, value } = await reader.read()) {
    const chunk = value as Uint8Array<ArrayBuffer>;
    chunks.push(chunk);
    length += chunk.length;
    if (length <= most) continue;
    await reader.cancel();
    throw new KerfwayError('too-large', endless(), { bytes: length, limit: most });
  }
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

const unusable: Refusal = (why) => new KerfwayError('not-a-drawing', `This project file cannot be used: ${why}. Save the project again.`);
