/**
 * The limit on the size of a file. It is checked before a file is read, so that a file that is too large costs no memory.
 * The number is that of `Limits` in `src/drawing/reading.rs`; a Rust test compares the two.
 */

import { shown } from './check.js';
import { KerfwayError } from './errors.js';

/** The size of the largest file that can be read, in bytes. */
export const MAX_BYTES = 256 * 2 ** 20;

/** Why a file of this size is refused, in one sentence for people; `null` when it can be read. */
export function tooLarge(bytes: number): string | null {
  if (typeof bytes !== 'number' || !(bytes >= 0)) throw new KerfwayError('wrong-type', `The size of the file is ${shown(bytes)}. Give the number of its bytes.`, { field: 'bytes' });
  return bytes <= MAX_BYTES ? null : refusal(`${megabytes(bytes)} MB`);
}

/** Why a stream that has not ended after `MAX_BYTES` is refused, in one sentence. */
export function endless(): string {
  return refusal(`more than ${megabytes(MAX_BYTES)} MB`);
}

/** Throws an error with the sentence of `tooLarge` when a file of this size cannot be read. */
export function checkSize(bytes: number): void {
  const sentence = tooLarge(bytes);
  if (sentence !== null) throw new KerfwayError('too-large', sentence, { bytes, limit: MAX_BYTES });
}

function refusal(size: string): string {
  return `The file has ${size}; up to ${megabytes(MAX_BYTES)} MB can be read. Delete what is not to be cut, or split the drawing.`;
}

// Rounded up, so that a size just above the limit does not look like the limit itself.
function megabytes(bytes: number): number {
  return Math.ceil(bytes / 2 ** 20);
}
