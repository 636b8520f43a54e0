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
import { KerfwayError } from '../errors.js';
import type { Planned } from '../functions.js';
import { checkOptions, type JobOptions, type PlanningOptions, type RenderOptions } from '../options.js';
import type { MachineProfile, MethodInfo } from '../protocol.js';
import type { Material, Quote } from '../quote.js';
import { abortable } from '../with-planner.js';
import { Connection } from './connection.js';
import { KINDS, LONGEST_NAME, type Kind, type Pace } from './messages.js';

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

/** Options of a call. An abort rejects it at once with the signal's reason, and ends its search in the frame as `stop` does. */
export type FrameCallOptions = Pick<JobOptions, 'signal'>;

/**
 * The connection of a host to its frame. Calls to a frame that is silent reject: with the code `not-started` after 120 seconds without a sign of its
 * page or planner, later with `planner-died` after 300 seconds.
 */
export interface FrameConnection {
  /** Sets how drawings are read and planned, including those that a person drops. Throws one sentence when an option is unusable. */
  setOptions(options: PlanningOptions): void;
  /** Plans a drawing in the frame. Rejects with one sentence when it is unusable, another drawing is opened, or the frame is loaded again. */
  open(bytes: Bytes, name: string, options?: FrameCallOptions): Promise<Planned<'gcode'>>;
  /** Quotes a drawing in a frame with `show=quote` in its address. */
  quote(bytes: Bytes, name: string, options?: FrameCallOptions): Promise<Quote>;
  /** Sets the material of the sheet for quotes. */
  setMaterial(material: Material): void;
  /** Ends the running search and keeps the best plan. */
  stop(): void;
  /** Writes the finished plan in another format: as text, or as the bytes of a PNG. */
  render(kind: Kind, options?: RenderOptions): Promise<string | Uint8Array>;
  /** Ends the connection. Calls that wait for an answer are rejected, and so are later ones. */
  disconnect(): void;
}

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
  const connection = new Connection(iframe, listener);
  // Whatever the frame would ignore is refused here, because nothing would answer it.
  const openFile = async <T>(given: Bytes, name: string, options: FrameCallOptions = {}): Promise<T> => {
    checkOne('The option', 'name', 'text', name);
    if (name.length === 0 || name.length > LONGEST_NAME) {
      throw new KerfwayError('out-of-range', `The option "name" has ${name.length} characters. Give 1 to ${LONGEST_NAME}.`, { field: 'name', value: name.slice(0, LONGEST_NAME), least: 1, most: LONGEST_NAME });
    }
    const { signal } = checkOptions(options, 'frameCall');
    // Bytes that are there already are sent before this call returns, so that they stay in order with other messages.
    const bytes = ownBuffer(viewed(given) ?? (await abortable(readBytes(given), signal)).bytes);
    return connection.ask<T>((id) => ({ type: 'open', id, bytes, name }), signal);
  };
  return {
    setOptions: (options) => connection.send({ type: 'options', options: checkOptions(options, 'readingAndPlanning') }),
    open: openFile,
    quote: openFile,
    // One that is undefined is no material either, and the frame would ignore the message.
    setMaterial: (material) => connection.send({ type: 'material', ...checkOptions({ material: material ?? (null as never) }, 'terms') }),
    stop: () => connection.send({ type: 'stop' }),
    render: async (kind, options = {}) => {
      checkOne('The option', 'kind', { choice: KINDS }, kind);
      const { width, signal } = checkOptions(options, 'render');
      return connection.ask((id) => ({ type: 'render', id, kind, width: width ?? null }), signal);
    },
    disconnect: () => connection.close(),
  };
}

/** The bytes as a buffer to send: a view may be a part of a larger buffer, or of memory that threads share. */
function ownBuffer(read: ArrayBuffer | Uint8Array): ArrayBuffer {
  return read instanceof ArrayBuffer ? read : new Uint8Array(read).buffer;
}
