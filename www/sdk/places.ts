/** Where the files of the package are, for hosts that serve them from another place. */

import { shown } from './check.js';
import { KerfwayError } from './errors.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';

/** Options that say where the planner runs and where its files are. */
export interface Places {
  /**
   * `false`: plan in the caller's thread instead of a worker, in slices of some milliseconds between which the event loop runs.
   * For places that have no workers. It has everything except the PNG renderer, the reader of SVG, the methods from papers (with
   * `commonCuts: insertion`), and the levers `fly`, `chains`, `bridges`, `common_cuts`, `tips`, `heat` and `corners`.
   */
  worker?: boolean;
  /**
   * The address of a file of the package (`worker.js`, in Node `node-worker.js`; `kerfway_bg.wasm`; without workers also `kerfway_outputs_bg.wasm`),
   * for hosts that serve them from a place of their own. A file for which it returns `undefined` is beside the package.
   */
  locate?: (file: string) => string | URL | undefined;
  /** The address of `kerfway_bg.wasm`. Overrides `locate`. */
  wasmUrl?: string | URL;
  /** The address of `worker.js`. Overrides `locate`. */
  workerUrl?: string | URL;
}

/** Where all planners run and where their files are: see `configure`. */
export interface Configuration extends Places {
  /** The compiled planner or its bytes. Default: the wasm file beside the package. */
  wasm?: WasmModule | WasmBytes;
  /** The compiled writers of programs and drawings, or their bytes. Default: the wasm file beside the package, which is loaded when the first output is asked for. */
  outputsWasm?: WasmModule | WasmBytes;
}

/** The address of a file that `locate` gives; `undefined`: beside the package. */
export function located({ locate }: Places, file: string): string | URL | undefined {
  const address: unknown = locate?.(file);
  if (address === undefined || address instanceof URL || (typeof address === 'string' && address !== '')) return address;
  throw new KerfwayError('wrong-type', `The function "locate" returns ${shown(address)} for ${file}. Return its address at once, as a text or a URL.`, { field: 'locate', value: shown(address) });
}

/** The address of the wasm file that these options give; `undefined`: beside the package. */
export function wasmAt(places: Places): string | URL | undefined {
  return places.wasmUrl ?? located(places, 'kerfway_bg.wasm');
}

/** The address of the worker's script that these options give; `undefined`: beside the package. */
export function workerAt(places: Places, file = 'worker.js'): string | URL | undefined {
  return places.workerUrl ?? located(places, file);
}
