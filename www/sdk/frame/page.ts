/**
 * The frame page (`frame.html?host=https://shop.example`): `<kerfway-planner>`, or with `&show=quote` `<kerfway-quote>`, and a bridge to the page around it. The
 * bridge exchanges messages only with the parent window, and only while that has the origin given as `host`. Without a
 * `host` there is no bridge. The results of a drawing that a person drops go to that origin alone.
 */

import { KerfwayQuote, type KerfwayPlanner, type PlannerEvents } from '../element/index.js';
import { KerfwayError, reportOf } from '../errors.js';
import { checkOptions, type PlanningOptions } from '../options.js';
import { MARK, messageToFrame, originOf, type FromFrame, type ToFrame } from './messages.js';

/** Milliseconds that a host has to name a price. */
const PATIENCE = 10_000;

const parameters = new URLSearchParams(location.search);
const host = originOf(parameters.get('host'));
const element = shown();

if (host !== null && window.parent !== window) bridge(host);

/** The element that the page shows. */
function shown(): KerfwayPlanner | KerfwayQuote {
  const planner = document.querySelector('kerfway-planner') as KerfwayPlanner;
  if (parameters.get('show') !== 'quote') return planner;
  const quote = document.createElement('kerfway-quote');
  planner.replaceWith(quote);
  return quote;
}

function bridge(origin: string): void {
  const send = (message: FromFrame) => window.parent.postMessage({ ...message, kerfway: MARK }, origin);
  let ready: FromFrame | null = null;

  const on = <K extends keyof PlannerEvents>(type: K, handle: (detail: PlannerEvents[K]['detail']) => void) =>
    (element as HTMLElement).addEventListener(type, (event) => handle((event as unknown as PlannerEvents[K]).detail));
  /** Reports whose price the host has not told yet. */
  const prices = new Map<number, (text: string) => void>();
  let lastPrice = 0;
  if (element instanceof KerfwayQuote) {
    // A host that does not answer has no price.
    element.price = (quote) =>
      new Promise((resolve) => {
        const id = ++lastPrice;
        prices.set(id, resolve);
        setTimeout(() => priced(id, ''), PATIENCE);
        send({ type: 'price', id, quote });
      });
  }
  const priced = (id: number, text: string) => {
    prices.get(id)?.(text);
    prices.delete(id);
  };

  on('ready', (detail) => {
    ready = { type: 'ready', page: performance.timeOrigin, ...detail };
    send(ready);
  });
  on('progress', ({ moves, seconds, rate, summary }) => send({ type: 'progress', progress: { moves, seconds, rate, summary } }));
  if (element instanceof KerfwayQuote) element.addEventListener('result', ({ detail }) => send({ type: 'quoted', quote: detail }));
  else on('result', (result) => send({ type: 'result', result }));
  on('error', (detail) => send({ type: 'error', error: detail }));

  const answer = (id: number, work: Promise<unknown>) => {
    work.then(
      (value) => send({ type: 'answer', id, value }),
      (error: unknown) => send({ type: 'refused', id, error: reportOf(error) }),
    );
  };
  // Unusable options are refused here, because a person who drops a file later could not know why it fails.
  const setOptions = (options: PlanningOptions) => {
    try {
      checkOptions(options, 'readingAndPlanning');
      element.options = options;
    } catch (error) {
      send({ type: 'error', error: reportOf(error) });
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
        answer(message.id, element.open(message.bytes, message.name));
        return;
      case 'material':
        if (element instanceof KerfwayQuote) element.material = message.material;
        return;
      case 'priced':
        priced(message.id, message.text);
        return;
      case 'stop':
        element.stop();
        return;
      case 'render':
        if (element instanceof KerfwayQuote) answer(message.id, Promise.reject(new KerfwayError('not-in-this-build', 'This frame quotes and writes no plans: leave show=quote out of its address.')));
        else answer(message.id, element.render(message.kind, message.width === null ? {} : { width: message.width }));
        return;
    }
  };

  window.addEventListener('message', (event) => {
    if (event.source !== window.parent || event.origin !== origin) return;
    const message = messageToFrame(event.data);
    if (message !== null) receive(message);
  });
}
