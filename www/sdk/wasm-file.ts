/** Loading of wasm files: that of the planner, and those used on demand, which write outputs, draw PNGs and hold the methods from papers. */

import { KerfwayError } from './errors.js';

/** Loads a file. If that fails, the error names the file and what to do, which the error of the platform does not; one of our own does. */
export async function loadedFile<M>(name: string, load: () => Promise<M>): Promise<M> {
  try {
    return await load();
  } catch (error) {
    if (error instanceof KerfwayError) throw error;
    const why = error instanceof Error ? error.message.replace(/[.\s]+$/, '') : String(error);
    throw new KerfwayError('not-started', `The file ${name}_bg.wasm cannot be loaded: ${why}. Check that all files of the package are there and can be reached, then try again.`);
  }
}
