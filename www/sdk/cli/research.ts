/** The wasm file with what is rarely needed: methods from papers, benchmark instances, certificates. Commands that need it load it themselves. */

import { readFile } from 'node:fs/promises';
import { loadedFile } from '../wasm-file.js';

const FILE = 'kerfway_research';

export function loadedResearch(): Promise<typeof import('../pkg/kerfway_research.js')> {
  return loadedFile(FILE, async () => {
    const research = await import('../pkg/kerfway_research.js');
    research.initSync({ module: await readFile(new URL(`../pkg/${FILE}_bg.wasm`, import.meta.url)) });
    return research;
  });
}
