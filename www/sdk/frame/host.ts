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

import { readBytes, viewed, type Bytes } from '../bytes.js';
import { checkOne, isRecord, shown } from '../check.js';
import { ClosedError, KerfwayError } from '../errors.js';
import type { Planned } from '../functions.js';
import { checkOptions, type PlanningOptions } from '../options.js';
import type { MachineProfile, MethodInfo } from '../protocol.js';
import type { Material, Quote } from '../quote.js';
import { KINDS, LONGEST_NAME, MARK, type FromFrame, type Kind, type Marked, type Pace, type ToFrame } from './messages.js';

export type { Kind, Pace } from './messages.js';

/** Callbacks for drawings that the host opens and for those that a person drops into the frame. */
export interface FrameListener {
  /** The planner in the frame has started; it has these machines and methods. Called again when the frame was loaded again. */
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
  /** Plans a drawing in the frame. Rejects with one sentence when it is unusable, another drawing is opened, or the frame is loaded again. */
  open(bytes: Bytes, name: string): Promise<Planned<'gcode'>>;
  /** Quotes a drawing in a frame with `show=quote` in its address. */
  quote(bytes: Bytes, name: string): Promise<Quote>;
  /** Sets the material of the sheet for quotes. */
  setMaterial(material: Material): void;
  /** Ends the running search and keeps the best plan. */
  stop(): void;
  /** Writes the finished plan in another format: as text, or as the bytes of a PNG. */
  render(kind: Kind, options?: { width?: number }): Promise<string | Uint8Array>;
  /** Ends the connection. Calls that wait for an answer are rejected, and so are later ones. */
  disconnect(): void;
}

interface Request {
  resolve: (value: never) => void;
  reject: (error: Error) => void;
}

const DISCONNECTED = 'The frame was disconnected.';

/**
 * Connects to a frame whose address is set; it need not be loaded yet. Messages that are sent before it is ready are delivered later. Throws a
 * `KerfwayError` for anything else, such as the `null` of a `querySelector` that finds nothing.
 */
export function connectFrame(iframe: HTMLIFrameElement, listener: FrameListener = {}): FrameConnection {
  if (typeof iframe?.src !== 'string' || iframe.src === '') {
    throw new KerfwayError('wrong-type', `The frame is ${shown(iframe)}, not an iframe with an address. Give the element once its src is set.`, { field: 'iframe' });
  }
  const callbacks: unknown = listener;
  if (!isRecord(callbacks)) throw new KerfwayError('wrong-type', `The listener is ${shown(callbacks)}. Give an object with callbacks.`, { field: 'listener' });
  const { origin } = new URL(iframe.src, location.href);
  const requests = new Map<number, Request>();
  let lastId = 0;
  /** Messages for a frame that is not ready yet; `null` afterwards. */
  let early: ToFrame[] | null = [];
  /** The page that is ready in the frame: it may be loaded again. */
  let page: number | null = null;
  /** The latest options and material, which a page that is loaded again does not have. */
  const settings = new Map<'options' | 'material', ToFrame>();
  let connected = true;

  const post = (message: ToFrame) => iframe.contentWindow?.postMessage({ ...message, kerfway: MARK }, origin);
  const send = (message: ToFrame) => {
    if (!connected) return;
    if (message.type === 'options' || message.type === 'material') settings.set(message.type, message);
    if (early === null) post(message);
    else early.push(message);
  };
  const ask = <T>(message: (id: number) => ToFrame): Promise<T> =>
    new Promise((resolve, reject) => {
      if (!connected) throw new ClosedError(DISCONNECTED);
      const id = ++lastId;
      requests.set(id, { resolve, reject });
      send(message(id));
    });
  const settle = (id: number, how: (request: Request) => void) => {
    const request = requests.get(id);
    requests.delete(id);
    if (request !== undefined) how(request);
  };
  const rejectAll = (error: KerfwayError) => {
    for (const id of [...requests.keys()]) settle(id, ({ reject }) => reject(error));
  };
  // Whatever the frame would ignore is refused here, because such a call would never settle.
  const openFile = async <T>(given: Bytes, name: string): Promise<T> => {
    checkOne('The option', 'name', 'text', name);
    if (name.length === 0 || name.length > LONGEST_NAME) {
      throw new KerfwayError('out-of-range', `The option "name" has ${name.length} characters. Give 1 to ${LONGEST_NAME}.`, { field: 'name', value: name.slice(0, LONGEST_NAME), least: 1, most: LONGEST_NAME });
    }
    // Bytes that are there already are sent before this call returns, so that they stay in order with other messages.
    const read = viewed(given) ?? (await readBytes(given)).bytes;
    // A view may be a part of a larger buffer, or of memory that threads share.
    const bytes = read instanceof ArrayBuffer ? read : (ArrayBuffer.isView(read) ? read : new Uint8Array(read)).slice().buffer;
    return ask<T>((id) => ({ type: 'open', id, bytes, name }));
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
        // A page says this again when it is greeted again.
        if (early === null && message.page === page) return;
        if (early === null) rejectAll(new KerfwayError('planner-died', 'The frame was loaded again before its answer. Open the drawing again.'));
        (early ?? [...settings.values()]).forEach(post);
        [early, page] = [null, message.page];
        listener.onReady?.({ machines: message.machines, methods: message.methods });
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
    open: openFile,
    quote: openFile,
    // One that is undefined is no material either, and the frame would ignore the message.
    setMaterial: (material) => send({ type: 'material', ...checkOptions({ material: material ?? (null as never) }, 'terms') }),
    stop: () => send({ type: 'stop' }),
    render: async (kind, options = {}) => {
      checkOne('The option', 'kind', { choice: KINDS }, kind);
      const { width } = checkOptions(options, 'render');
      return ask((id) => ({ type: 'render', id, kind, width: width ?? null }));
    },
    disconnect: () => {
      connected = false;
      window.removeEventListener('message', listen);
      iframe.removeEventListener('load', greet);
      rejectAll(new ClosedError(DISCONNECTED));
    },
  };
}
