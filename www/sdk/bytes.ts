/** The kinds of bytes that callers may give as a drawing, and how each is read. */

import { KerfwayError, notBytes } from './errors.js';
import { checkSize } from './size.js';

/** Something that holds bytes and reads them when asked: `Blob`, `File`, `Response`, `Request`. */
export interface ByteHolder {
  /** Reads the bytes. */
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** A drawing's bytes: an `ArrayBuffer`, any view of one (`Uint8Array`, Node's `Buffer`), or a `Blob`, `File`, `Response` or `Request`. */
export type Bytes = ArrayBuffer | ArrayBufferView | ByteHolder;

/** A drawing's bytes, or a function that reads them when its turn comes, so that a pool holds no more files than it works on. */
export type Source = Bytes | (() => Bytes | Promise<Bytes>);

/** Bytes that have been read, with the name of the file if they came from one. */
export interface ReadBytes {
  bytes: ArrayBuffer | Uint8Array;
  name: string | undefined;
}

/** Reads the bytes of a drawing. Throws a `TypeError` with the code `not-bytes` for anything that holds none. */
export async function readBytes(source: Source): Promise<ReadBytes> {
  const given: unknown = typeof source === 'function' ? await source() : source;
  const isHeld = viewed(given) === null && isHolder(given);
  const bytes = viewed(isHeld ? await held(given) : given);
  if (bytes === null) throw notBytes();
  return { bytes, name: isHeld && typeof given['name'] === 'string' && given['name'] !== '' ? given['name'] : undefined };
}

/** The bytes of a buffer or a view of one; `null` for anything else. */
export function viewed(given: unknown): ArrayBuffer | Uint8Array | null {
  // Recognised by its tag, because a buffer may come from another frame or context.
  const tag = Object.prototype.toString.call(given);
  const isBuffer = tag === '[object ArrayBuffer]' || tag === '[object SharedArrayBuffer]';
  try {
    if (ArrayBuffer.isView(given)) return new Uint8Array(given.buffer, given.byteOffset, given.byteLength);
    // What only has the tag of a buffer has another length, or none.
    if (isBuffer && new Uint8Array(given as ArrayBuffer).byteLength === (given as ArrayBuffer).byteLength) return given as ArrayBuffer;
  } catch {
    // A buffer that was given to another thread holds no bytes any more, and a proxy of a buffer cannot be read.
  }
  return null;
}

type Holder = ByteHolder & Record<string, unknown>;

function isHolder(given: unknown): given is Holder {
  return typeof given === 'object' && given !== null && typeof (given as Record<string, unknown>)['arrayBuffer'] === 'function';
}

/** The bytes of a blob, file, response or request. Sizes that are known are checked before anything is read. */
async function held(holder: Holder): Promise<unknown> {
  const { ok, status, size, headers } = holder as { ok?: unknown; status?: unknown; size?: unknown; headers?: { get?: (name: string) => string | null } };
  if (ok === false) throw new KerfwayError('download-failed', `The drawing could not be downloaded: the server answers ${String(status)}.`, { status: Number(status) });
  if (typeof size === 'number') checkSize(size);
  const length = typeof headers?.get === 'function' ? headers.get('content-length') : null;
  if (length !== null && Number(length) > 0) checkSize(Number(length));
  try {
    return await holder.arrayBuffer();
  } catch (error) {
    throw new KerfwayError('download-failed', `The drawing could not be read: ${error instanceof Error ? error.message : String(error)}.`);
  }
}
