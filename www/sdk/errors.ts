/**
 * The errors of the package. Each has a code for programs, the values that its sentence names, and one sentence for
 * people. The codes are those of the core (`src/job/code.rs`); a host that shows another language chooses its sentence by
 * the code.
 */

import type { ErrorCode, ErrorReport } from './generated/types.js';

/** What a sentence names, by name. */
export type ErrorParams = ErrorReport['params'];

/** The codes of errors after which the same call may succeed without a change: see `is_retryable` in `src/job/code.rs`. */
const RETRYABLE: ReadonlySet<ErrorCode> = new Set<ErrorCode>([
  'planner-died', 'not-started', 'deadline', 'busy', 'stopping', 'slow-upload', 'queue-unavailable', 'internal',
]);

/** An error of Kerfway: what went wrong, for programs and for people. */
export class KerfwayError extends Error {
  /** What went wrong. */
  readonly code: ErrorCode;
  /** The values that the sentence names, for example `field`, `value`, `least`, `most`. */
  readonly params: ErrorParams;

  constructor(code: ErrorCode, message: string, params: ErrorParams = {}) {
    super(message);
    this.name = 'KerfwayError';
    this.code = code;
    this.params = params;
  }

  /** Whether the same call may succeed later, without a change by the caller. */
  get retryable(): boolean {
    return RETRYABLE.has(this.code);
  }

  /** The error as JSON, as the command line and the service write it. */
  toJSON(): ErrorReport {
    const { code, message, params, retryable } = this;
    return { code, message, params, retryable };
  }

  /** The error that a report describes. */
  static of({ code, message, params }: ErrorReport): KerfwayError {
    return code === 'closed' ? new ClosedError(message) : new KerfwayError(code, message, params);
  }
}

/** The planner, pool or frame was closed by its owner, who knows about it. */
export class ClosedError extends KerfwayError {
  constructor(message: string) {
    super('closed', message);
  }
}

const NOT_BYTES = 'The drawing is not given as bytes, or its buffer was transferred. Give an ArrayBuffer, a Uint8Array, a Buffer, a Blob, a File or a Response.';

/** A mistake of the program that calls, and therefore a `TypeError`; it has a code and params as well. */
export function notBytes(): TypeError {
  return Object.assign(new TypeError(NOT_BYTES), { code: 'not-bytes' as const, params: {}, retryable: false });
}

/** Whether an error is one of Kerfway's. Works for errors of another copy of the package, for which `instanceof` does not. */
export function isKerfwayError(error: unknown): error is KerfwayError {
  return error instanceof KerfwayError || (error instanceof Error && error.name === 'KerfwayError' && 'code' in error && 'params' in error);
}

/** The report of any error. One that is not Kerfway's is a fault of the program: `internal`. */
export function reportOf(error: unknown): ErrorReport {
  if (isKerfwayError(error)) return error.toJSON();
  if (error instanceof TypeError && 'code' in error && error.code === 'not-bytes') return { code: 'not-bytes', message: error.message, params: {}, retryable: false };
  const report = (error as { report?: ErrorReport } | null)?.report;
  if (report !== undefined && typeof report === 'object') return report;
  const message = error instanceof Error ? error.message : String(error);
  return { code: 'internal', message, params: {}, retryable: true };
}
