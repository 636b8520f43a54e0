/**
 * The host's side of the frame page.
 *
 *     <iframe id="planner" src="https://cdn.example/kerfway/frame/frame.html?host=https://shop.example"></iframe>
 *
 *     import { connectFrame } from 'kerfway/frame';
 *     const frame = connectFrame(document.querySelector('#planner'), { onResult: ({ summary }) => quote(summary) });
 *     frame.setOptions({ machine: 'co2-100w', seconds: 5 });
 *     const { outputs } = await frame.open(await file.arrayBuffer(), file.name);
 *
 * Only messages from that frame and from the origin of its address are accepted, and messages are sent to that origin only.
 *
 * @module kerfway/frame
 */

import { ClosedError, KerfwayError } from '../errors.js';
import type { Planned } from '../functions.js';
import { checkOptions, type PlanningOptions } from '../options.js';
import type { MachineProfile, MethodInfo } from '../protocol.js';
import type { Material, Quote } from '../quote.js';
import { MARK, type FromFrame, type Kind, type Marked, type Pace, type ToFrame } from './messages.js';

export type { Kind, Pace } from './messages.js';

/** Callbacks for drawings that the host opens and for those that a person drops into the frame. */
export interface FrameListener {
  /** The planner in the frame has started; it has these machines and methods. */
  onReady?: (planner: { machines: readonly MachineProfile[]; methods: readonly MethodInfo[] }) => void;
  /** The search reports its progress. */
  onProgress?: (progress: Pace) => void;
  /** A plan has ended. */
  onResult?: (result: Planned<'gcode'>) => void;
  /** A report of a quote is finished, in a frame with `show=quote` in its address. */
  onQuote?: (quote: Quote) => void;
  /** The price of a report in words, or a promise of it, which the frame shows. Without it, or if it throws, the frame shows none. */
  price?: (quote: Quote) => string | Promise<string>;
  /** Something failed: one sentence for people, which the frame shows as well, and the error with its code. */
  onError?: (message: string, error: KerfwayError) => void;
}

/** The connection of a host to its frame. */
export interface FrameConnection {
  /** Sets how drawings are read and planned, including those that a person drops. Throws one sentence when an option is unusable. */
  setOptions(options: PlanningOptions): void;
  /** Plans a drawing in the frame. Rejects with one sentence when it is unusable or another drawing is opened. */
  open(bytes: ArrayBuffer, name: string): Promise<Planned<'gcode'>>;
  /** Quotes a drawing in a frame with `show=quote` in its address. */
  quote(bytes: ArrayBuffer, name: string): Promise<Quote>;
  /** Sets the material of the sheet for quotes. */
  setMaterial(material: Material): void;
  /** Ends the running search and keeps the best plan. */
  stop(): void;
  /** Writes the finished plan in another format: as text, or as the bytes of a PNG. */
  render(kind: Kind, options?: { width?: number }): Promise<string | Uint8Array>;
  /** Ends the connection. Calls that wait for an answer are rejected. */
  disconnect(): void;
}

interface Request {
  resolve: (value: never) => void;
  reject: (error: Error) => void;
}

/** Connects to a frame whose address is set; it need not be loaded yet. Messages that are sent before it is ready are delivered later. */
export function connectFrame(iframe: HTMLIFrameElement, listener: FrameListener = {}): FrameConnection {
  const { origin } = new URL(iframe.src, location.href);
  const requests = new Map<number, Request>();
  let lastId = 0;
  /** Messages for a frame that is not ready yet; `null` afterwards. */
  let early: ToFrame[] | null = [];

  const post = (message: ToFrame) => iframe.contentWindow?.postMessage({ ...message, kerfway: MARK }, origin);
  const send = (message: ToFrame) => {
    if (early === null) post(message);
    else early.push(message);
  };
  const ask = <T>(message: (id: number) => ToFrame): Promise<T> =>
    new Promise((resolve, reject) => {
      const id = ++lastId;
      requests.set(id, { resolve, reject });
      send(message(id));
    });
  const settle = (id: number, how: (request: Request) => void) => {
    const request = requests.get(id);
    requests.delete(id);
    if (request !== undefined) how(request);
  };
  const priceOf = async (quote: Quote) => {
    try {
      return String((await listener.price?.(quote)) ?? '');
    } catch (error) {
      console.error(error);
      return '';
    }
  };
  const receive = (message: FromFrame) => {
    switch (message.type) {
      case 'ready': {
        const first = early;
        early = null;
        first?.forEach(post);
        if (first !== null) listener.onReady?.({ machines: message.machines, methods: message.methods });
        return;
      }
      case 'progress':
        return listener.onProgress?.(message.progress);
      case 'result':
        return listener.onResult?.(message.result);
      case 'quoted':
        return listener.onQuote?.(message.quote);
      case 'price':
        return void priceOf(message.quote).then((text) => post({ type: 'priced', id: message.id, text }));
      case 'error':
        return listener.onError?.(message.error.message, KerfwayError.of(message.error));
      case 'answer':
        return settle(message.id, ({ resolve }) => resolve(message.value as never));
      case 'refused':
        return settle(message.id, ({ reject }) => reject(KerfwayError.of(message.error)));
    }
  };
  const listen = (event: MessageEvent<Marked<FromFrame> | null>) => {
    if (event.source === iframe.contentWindow && event.origin === origin && event.data?.kerfway === MARK) receive(event.data);
  };
  // The page in the frame may be another one by now. This message may go to any origin, because it contains nothing.
  const greet = () => iframe.contentWindow?.postMessage({ type: 'hello', kerfway: MARK }, '*');

  window.addEventListener('message', listen);
  iframe.addEventListener('load', greet);
  greet();
  return {
    setOptions: (options) => send({ type: 'options', options: checkOptions(options, 'readingAndPlanning') }),
    open: (bytes, name) => ask((id) => ({ type: 'open', id, bytes, name })),
    quote: (bytes, name) => ask((id) => ({ type: 'open', id, bytes, name })),
    setMaterial: (material) => send({ type: 'material', ...checkOptions({ material }, 'terms') }),
    stop: () => send({ type: 'stop' }),
    render: (kind, { width } = {}) => ask((id) => ({ type: 'render', id, kind, width: width ?? null })),
    disconnect: () => {
      window.removeEventListener('message', listen);
      iframe.removeEventListener('load', greet);
      for (const { reject } of requests.values()) reject(new ClosedError('The frame was disconnected.'));
      requests.clear();
    },
  };
}
