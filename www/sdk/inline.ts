/**
 * The wasm files of the planner and of the writers inside JavaScript, for pages that are a single file or may not fetch. Pass them to
 * `createPlanner`.
 *
 *     import { outputsWasm, wasm } from 'kerfway/inline';
 *     const planner = await createPlanner({ wasm: wasm(), outputsWasm: outputsWasm() });
 *
 * @module kerfway/inline
 */

import planner from './inline-bytes.js';
import outputs from './inline-outputs-bytes.js';

const decoded = (base64: string) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

/** The bytes of the planner. */
export function wasm(): Uint8Array<ArrayBuffer> {
  return decoded(planner);
}

/** The bytes of what writes programs and drawings. */
export function outputsWasm(): Uint8Array<ArrayBuffer> {
  return decoded(outputs);
}
