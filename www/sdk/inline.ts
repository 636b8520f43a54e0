/**
 * The wasm file of the planner inside JavaScript, for pages that are a single file or may not fetch. Pass it to `createPlanner`.
 *
 *     import { wasm } from 'kerfway/inline';
 *     const planner = await createPlanner({ wasm: wasm() });
 *
 * @module kerfway/inline
 */

import base64 from './inline-bytes.js';

/** The bytes of the wasm file. */
export function wasm(): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
}
