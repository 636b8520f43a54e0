/** The planner in a worker thread of Node. */

import { readFile } from 'node:fs/promises';
import { parentPort } from 'node:worker_threads';
import type { ToWorker } from './protocol.js';
import { type Host, Session } from './session.js';

const host: Host = {
  post: (message, transfer = []) => parentPort?.postMessage(message, transfer),
  lab: async () => {
    const lab = await import('./pkg/kerfway_lab.js');
    lab.initSync({ module: await readFile(new URL('./pkg/kerfway_lab_bg.wasm', import.meta.url)) });
    return lab;
  },
  papers: async () => {
    const papers = await import('./pkg/kerfway_papers.js');
    papers.initSync({ module: await readFile(new URL('./pkg/kerfway_papers_bg.wasm', import.meta.url)) });
    return papers;
  },
  quote: async () => {
    const quote = await import('./pkg/kerfway_quote.js');
    quote.initSync({ module: await readFile(new URL('./pkg/kerfway_quote_bg.wasm', import.meta.url)) });
    return quote;
  },
  png: async () => {
    const renderer = await import('./pkg/kerfway_png.js');
    renderer.initSync({ module: await readFile(new URL('./pkg/kerfway_png_bg.wasm', import.meta.url)) });
    return renderer.renderPng;
  },
};

const session = new Session(host);
parentPort?.on('message', (message: ToWorker) => session.receive(message));
