/** Loading of the wasm files that are used on demand: the writers of outputs, the PNG renderer, and the methods from papers. */

import { KerfwayError } from './errors.js';

/** Loads a file. If that fails, the error names the file and what to do, which the error of the platform does not. */
export async function optionalFile<M>(name: string, load: () => Promise<M>): Promise<M> {
  try {
    return await load();
  } catch (error) {
    const why = error instanceof Error ? error.message.replace(/[.\s]+$/, '') : String(error);
    throw new KerfwayError('not-started', `The file ${name}_bg.wasm cannot be loaded: ${why}. Check that all files of the package are there and can be reached, then try again.`);
  }
}
