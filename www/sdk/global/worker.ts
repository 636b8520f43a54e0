/**
 * The worker of the single-file build. It gets the planner and the writers of programs and drawings, but not the PNG renderer, the reader
 * of SVG and the methods from papers, which would double its size.
 */

import { KerfwayError } from '../errors.js';
import * as outputs from '../pkg/kerfway_outputs.js';
import type { FromWorker, ToWorker } from '../protocol.js';
import { Session } from '../session.js';

const scope = self as unknown as {
  postMessage(message: FromWorker, transfer: ArrayBuffer[]): void;
  onmessage: (event: MessageEvent<ToWorker>) => void;
};

const session = new Session({
  post: (message, transfer = []) => scope.postMessage(message, transfer),
  research: async () => {
    throw new KerfwayError('not-in-this-build', 'The single-file build reads no SVG, has no methods from papers, and does not plan the levers fly, chains, bridges, common_cuts, tips, heat and corners. Use the package with its files for them.');
  },
  outputs: async (given) => {
    await outputs.default({ module_or_path: given });
    return outputs;
  },
  png: async () => {
    throw new KerfwayError('not-in-this-build', 'The single-file build writes no PNG. Render SVG instead, or use the package with its files.');
  },
});
scope.onmessage = ({ data }) => session.receive(data);
