/**
 * The planner in a worker made of text: everything it needs is inside, but for the renderer of pictures and the
 * methods of papers, and the planner of pierce groups, which would double it.
 */

import lab from '../pkg/kerfway_lab_bg.wasm';
import * as labModule from '../pkg/kerfway_lab.js';
import quote from '../pkg/kerfway_quote_bg.wasm';
import * as quoteModule from '../pkg/kerfway_quote.js';
import type { FromWorker, ToWorker } from '../protocol.js';
import { Session } from '../session.js';

const scope = self as unknown as {
  postMessage(message: FromWorker, transfer: ArrayBuffer[]): void;
  onmessage: (event: MessageEvent<ToWorker>) => void;
};

const session = new Session({
  post: (message, transfer = []) => scope.postMessage(message, transfer),
  lab: async () => {
    labModule.initSync({ module: lab });
    return labModule;
  },
  plate: async () => {
    throw new Error('The single-file build cuts every contour by itself. Use the package with its files for common cuts.');
  },
  papers: async () => {
    throw new Error('The single-file build has no methods from papers. Use the package with its files for them.');
  },
  quote: async () => {
    quoteModule.initSync({ module: quote });
    return quoteModule;
  },
  png: async () => {
    throw new Error('The single-file build writes no PNG. Render SVG instead, or use the package with its files.');
  },
});
scope.onmessage = ({ data }) => session.receive(data);
