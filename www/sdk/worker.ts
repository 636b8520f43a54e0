/** The planner in a Web Worker. */

import type { ToWorker } from './protocol.js';
import { type Host, Session } from './session.js';

/** What is used of a dedicated worker's global scope, whose types clash with those of a page. */
interface WorkerScope {
  postMessage(message: unknown, transfer: ArrayBuffer[]): void;
  onmessage: (event: MessageEvent<ToWorker>) => void;
}

const scope = self as unknown as WorkerScope;

const host: Host = {
  post: (message, transfer = []) => scope.postMessage(message, transfer),
  lab: async () => {
    const lab = await import('./pkg/kerfway_lab.js');
    await lab.default();
    return lab;
  },
  papers: async () => {
    const papers = await import('./pkg/kerfway_papers.js');
    await papers.default();
    return papers;
  },
  quote: async () => {
    const quote = await import('./pkg/kerfway_quote.js');
    await quote.default();
    return quote;
  },
  png: async () => {
    const renderer = await import('./pkg/kerfway_png.js');
    await renderer.default();
    return renderer.renderPng;
  },
};

const session = new Session(host);
scope.onmessage = ({ data }) => session.receive(data);
