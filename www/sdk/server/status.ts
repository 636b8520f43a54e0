/** The HTTP status of each error, and the body that describes it. */

import type { ErrorCode, ErrorReport } from '../generated/types.js';

/** 400 the request is wrong, 422 the drawing cannot be used, 5xx the service failed. */
const STATUS: Readonly<Record<ErrorCode, number>> = {
  'unknown-field': 400, 'missing-field': 400, 'wrong-type': 400, 'out-of-range': 400, 'not-a-choice': 400, 'invalid-parameter': 400, 'not-json': 400,
  'options-conflict': 400, 'unknown-contour': 400, 'unfit-path': 400, 'not-bytes': 400, 'not-a-quote': 400, 'malformed-form': 400, 'wrong-usage': 400,
  unauthorized: 401, 'not-found': 404, 'method-not-allowed': 405, 'slow-upload': 408, 'too-large': 413, 'unsupported-media-type': 415,
  'not-a-drawing': 422, 'empty-drawing': 422, 'nothing-to-cut': 422, 'other-drawing': 422, 'far-from-origin': 422, 'off-bed': 422, unwritable: 422, 'download-failed': 422,
  busy: 429,
  'no-drawing': 500, 'no-plan': 500, 'unsound-plan': 500, 'planner-died': 500, 'not-started': 500, 'not-in-this-build': 501, internal: 500,
  'unreadable-file': 500, 'unwritable-output': 500,
  closed: 503, stopping: 503, 'queue-unavailable': 503, deadline: 504,
};

/** What is counted and logged for a client that has disconnected before its answer, as nginx does: no fault of the service. */
export const CLIENT_LEFT = 499;

export function statusOf(code: ErrorCode): number {
  return STATUS[code] ?? 500;
}

const FAULT = 'The request failed because of a fault of the service. Try again later.';

/** What the client sees. Details of faults in the service go only to its log. */
export function told(report: ErrorReport): ErrorReport {
  return report.code === 'internal' ? { ...report, message: FAULT, params: {} } : report;
}
