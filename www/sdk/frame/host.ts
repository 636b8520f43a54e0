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
 * Only messages of that frame, from the origin of its address, are heard, and only that origin is told anything.
 *
 * @module kerfway/frame
 */

import type { Planned } from '../functions.js';
import { checkOptions, type PlanningOptions } from '../options.js';
import type { MachineProfile, MethodInfo } from '../protocol.js';
import { MARK, type FromFrame, type Kind, type Marked, type Pace, type ToFrame } from './messages.js';

export type { Kind, Pace } from './messages.js';

/** What the frame tells, of drawings that the host opens and of those that a person drops. */
export interface FrameListener {
  /** The planner in the frame is ready: its machines and methods. */
  onReady?: (planner: { machines: readonly MachineProfile[]; methods: readonly MethodInfo[] }) => void;
  /** A plan is under way: its figures so far. */
  onProgress?: (progress: Pace) => void;
  /** A plan has ended. */
  onResult?: (result: Planned<'gcode'>) => void;
  /** One sentence for people; the frame shows it, too. */
  onError?: (message: string) => void;
}

/** A host's hold of its frame. */
export interface FrameConnection {
  /** How drawings are read and planned from now on, those a person drops, too. Throws one sentence when an option is unusable. */
  setOptions(options: PlanningOptions): void;
  /** Plans a drawing in the frame. Rejects with one sentence when it is unusable or another is opened. */
  open(bytes: ArrayBuffer, name: string): Promise<Planned<'gcode'>>;
  /** Ends the plan under way and keeps the best found. */
  stop(): void;
  /** The finished plan in another form: text, or the bytes of a PNG. */
  render(kind: Kind, options?: { width?: number }): Promise<string | Uint8Array>;
  /** Hears no more; what waits for an answer is rejected. */
  disconnect(): void;
}

interface Question {
  resolve: (value: never) => void;
  reject: (error: Error) => void;
}

/** Connects to a frame page whose address is set, loaded already or not. What is said before it is ready reaches it when it is. */
export function connectFrame(iframe: HTMLIFrameElement, listener: FrameListener = {}): FrameConnection {
  const { origin } = new URL(iframe.src, location.href);
  const questions = new Map<number, Question>();
  let lastId = 0;
  /** Said before the frame was ready; `null` afterwards. */
  let early: ToFrame[] | null = [];

  const post = (message: ToFrame) => iframe.contentWindow?.postMessage({ ...message, kerfway: MARK }, origin);
  const say = (message: ToFrame) => {
    if (early === null) post(message);
    else early.push(message);
  };
  const ask = <T>(message: (id: number) => ToFrame): Promise<T> =>
    new Promise((resolve, reject) => {
      const id = ++lastId;
      questions.set(id, { resolve, reject });
      say(message(id));
    });
  const settle = (id: number, how: (question: Question) => void) => {
    const question = questions.get(id);
    questions.delete(id);
    if (question !== undefined) how(question);
  };
  const hear = (message: FromFrame) => {
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
      case 'error':
        return listener.onError?.(message.message);
      case 'answer':
        return settle(message.id, ({ resolve }) => resolve(message.value as never));
      case 'refused':
        return settle(message.id, ({ reject }) => reject(new Error(message.message)));
    }
  };
  const listen = (event: MessageEvent<Marked<FromFrame> | null>) => {
    if (event.source === iframe.contentWindow && event.origin === origin && event.data?.kerfway === MARK) hear(event.data);
  };
  // Whoever is in the frame by now may hear that: it says nothing.
  const greet = () => iframe.contentWindow?.postMessage({ type: 'hello', kerfway: MARK }, '*');

  window.addEventListener('message', listen);
  iframe.addEventListener('load', greet);
  greet();
  return {
    setOptions: (options) => {
      checkOptions(options, 'readingAndPlanning');
      say({ type: 'options', options });
    },
    open: (bytes, name) => ask((id) => ({ type: 'open', id, bytes, name })),
    stop: () => say({ type: 'stop' }),
    render: (kind, { width } = {}) => ask((id) => ({ type: 'render', id, kind, width: width ?? null })),
    disconnect: () => {
      window.removeEventListener('message', listen);
      iframe.removeEventListener('load', greet);
      for (const { reject } of questions.values()) reject(new Error('The frame was disconnected.'));
      questions.clear();
    },
  };
}
