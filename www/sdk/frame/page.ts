/**
 * The frame page (`frame.html?host=https://shop.example`): `<kerfway-planner>` and a bridge to the page around it. The
 * bridge hears only the parent window, only from the origin stated in `host`, and speaks to no other. Without a `host`
 * there is no bridge. A drawing that a person drops is told to that origin alone.
 */

import type { KerfwayPlanner, PlannerEvents } from '../element/index.js';
import '../element/index.js';
import { checkOptions, type PlanningOptions } from '../options.js';
import { MARK, messageToFrame, originOf, type FromFrame, type ToFrame } from './messages.js';

const planner = document.querySelector('kerfway-planner') as KerfwayPlanner;
const host = originOf(new URLSearchParams(location.search).get('host'));

if (host !== null && window.parent !== window) bridge(host);

function bridge(origin: string): void {
  const tell = (message: FromFrame) => window.parent.postMessage({ ...message, kerfway: MARK }, origin);
  let ready: FromFrame | null = null;

  const on = <K extends keyof PlannerEvents>(type: K, does: (detail: PlannerEvents[K]['detail']) => void) =>
    planner.addEventListener(type as string, (event) => does((event as PlannerEvents[K]).detail));

  on('ready', (detail) => {
    ready = { type: 'ready', ...detail };
    tell(ready);
  });
  on('progress', ({ moves, seconds, rate, summary }) => tell({ type: 'progress', progress: { moves, seconds, rate, summary } }));
  on('result', (result) => tell({ type: 'result', result }));
  on('error', ({ message }) => tell({ type: 'error', message }));

  const answer = (id: number, work: Promise<unknown>) => {
    work.then(
      (value) => tell({ type: 'answer', id, value }),
      (error: Error) => tell({ type: 'refused', id, message: error.message }),
    );
  };
  // Options that cannot be used are refused here: a person who drops a file later could not know why it fails.
  const choose = (options: PlanningOptions) => {
    try {
      checkOptions(options, 'readingAndPlanning');
      planner.options = options;
    } catch (error) {
      tell({ type: 'error', message: (error as Error).message });
    }
  };
  const obey = (message: ToFrame) => {
    switch (message.type) {
      case 'hello':
        if (ready !== null) tell(ready);
        return;
      case 'options':
        choose(message.options);
        return;
      case 'open':
        answer(message.id, planner.open(message.bytes, message.name));
        return;
      case 'stop':
        planner.stop();
        return;
      case 'render':
        answer(message.id, planner.render(message.kind, message.width === null ? {} : { width: message.width }));
        return;
    }
  };

  window.addEventListener('message', (event) => {
    if (event.source !== window.parent || event.origin !== origin) return;
    const message = messageToFrame(event.data);
    if (message !== null) obey(message);
  });
}
