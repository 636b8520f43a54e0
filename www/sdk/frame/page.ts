/**
 * The frame page (`frame.html?host=https://shop.example`): `<kerfway-planner>` and a bridge to the page around it. The
 * bridge exchanges messages only with the parent window, and only while that has the origin given as `host`. Without a
 * `host` there is no bridge. The results of a drawing that a person drops go to that origin alone.
 */

import type { KerfwayPlanner, PlannerEvents } from '../element/index.js';
import '../element/index.js';
import { checkOptions, type PlanningOptions } from '../options.js';
import { MARK, messageToFrame, originOf, type FromFrame, type ToFrame } from './messages.js';

const planner = document.querySelector('kerfway-planner') as KerfwayPlanner;
const host = originOf(new URLSearchParams(location.search).get('host'));

if (host !== null && window.parent !== window) bridge(host);

function bridge(origin: string): void {
  const send = (message: FromFrame) => window.parent.postMessage({ ...message, kerfway: MARK }, origin);
  let ready: FromFrame | null = null;

  const on = <K extends keyof PlannerEvents>(type: K, handle: (detail: PlannerEvents[K]['detail']) => void) =>
    planner.addEventListener(type as string, (event) => handle((event as PlannerEvents[K]).detail));

  on('ready', (detail) => {
    ready = { type: 'ready', ...detail };
    send(ready);
  });
  on('progress', ({ moves, seconds, rate, summary }) => send({ type: 'progress', progress: { moves, seconds, rate, summary } }));
  on('result', (result) => send({ type: 'result', result }));
  on('error', ({ message }) => send({ type: 'error', message }));

  const answer = (id: number, work: Promise<unknown>) => {
    work.then(
      (value) => send({ type: 'answer', id, value }),
      (error: Error) => send({ type: 'refused', id, message: error.message }),
    );
  };
  // Unusable options are refused here, because a person who drops a file later could not know why it fails.
  const setOptions = (options: PlanningOptions) => {
    try {
      checkOptions(options, 'readingAndPlanning');
      planner.options = options;
    } catch (error) {
      send({ type: 'error', message: (error as Error).message });
    }
  };
  const receive = (message: ToFrame) => {
    switch (message.type) {
      case 'hello':
        if (ready !== null) send(ready);
        return;
      case 'options':
        setOptions(message.options);
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
    if (message !== null) receive(message);
  });
}
