/**
 * The compiled planner inside JavaScript, for pages that are one file or may not fetch: pass it to `createPlanner`.
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
