/** The messages between a host and the page in its frame, and what the host does when that page is not there yet, is loaded again, or is silent. */

import { ClosedError, KerfwayError } from '../errors.js';
import type { Quote } from '../quote.js';
import { abortable } from '../with-planner.js';
import { Calls } from './calls.js';
import type { FrameListener } from './host.js';
import { MARK, type FromFrame, type Marked, type ToFrame } from './messages.js';

/**
 * Seconds for which calls wait for a frame that is silent. Until its planner has started, a frame loads its page and then 1.6 MB of wasm, each within
 * this time: 14 kB a second are enough. Later its own planner reports a worker that is silent for 120 seconds, and a call may read a drawing twice.
 */
const PATIENCE = { starting: 120, working: 300 };

const DISCONNECTED = 'The frame was disconnected.';

export class Connection {
  private readonly origin: string;
  private readonly calls = new Calls((seconds) => this.silent(seconds));
  /** Messages for a frame whose page does not listen yet; `null` afterwards. */
  private early: ToFrame[] | null = [];
  /** The page that is ready in the frame: it may be loaded again. */
  private page: number | null = null;
  /** The latest options and material, which a page that is loaded again does not have. */
  private readonly settings = new Map<'options' | 'material', ToFrame>();
  /** The drawing that the frame was given last. */
  private opened: number | null = null;
  private connected = true;

  constructor(
    private readonly iframe: HTMLIFrameElement,
    private readonly listener: FrameListener,
  ) {
    this.origin = new URL(iframe.src, location.href).origin;
    window.addEventListener('message', this.listen);
    iframe.addEventListener('load', this.greet);
    this.greet();
  }

  /** Sends a message, once the page in the frame listens. */
  send(message: ToFrame): void {
    if (!this.connected) return;
    if (message.type === 'options' || message.type === 'material') this.settings.set(message.type, message);
    if (message.type === 'open') this.opened = message.id;
    if (this.early === null) this.post(message);
    else this.early.push(message);
  }

  /** Sends a message and waits for its answer. */
  async ask<T>(message: (id: number) => ToFrame, signal?: AbortSignal): Promise<T> {
    if (!this.connected) throw new ClosedError(DISCONNECTED);
    signal?.throwIfAborted();
    const { id, answer } = this.calls.add<T>();
    this.send(message(id));
    try {
      return await abortable(answer, signal);
    } catch (error) {
      if (signal?.aborted === true) this.abort(id);
      throw error;
    }
  }

  close(): void {
    this.connected = false;
    window.removeEventListener('message', this.listen);
    this.iframe.removeEventListener('load', this.greet);
    this.calls.rejectAll(new ClosedError(DISCONNECTED));
  }

  private post(message: ToFrame): void {
    this.iframe.contentWindow?.postMessage({ ...message, kerfway: MARK }, this.origin);
  }

  // The page in the frame may be another one by now. This message may go to any origin, because it contains nothing.
  private readonly greet = () => {
    this.calls.heard();
    this.iframe.contentWindow?.postMessage({ type: 'hello', kerfway: MARK }, '*');
  };

  private readonly listen = (event: MessageEvent<Marked<FromFrame> | null>) => {
    if (event.source !== this.iframe.contentWindow || event.origin !== this.origin || event.data?.kerfway !== MARK) return;
    this.calls.heard();
    this.receive(event.data);
  };

  private receive(message: FromFrame): void {
    const { listener, calls } = this;
    switch (message.type) {
      case 'ready':
        return this.ready(message);
      case 'progress':
        return listener.onProgress?.(message.progress);
      case 'result':
        return listener.onResult?.(message.result);
      case 'quoted':
        return listener.onQuote?.(message.quote);
      case 'price':
        return void this.priceOf(message.quote).then((text) => this.post({ type: 'priced', id: message.id, text }));
      case 'error':
        // Before the page is ready, this is why its planner could not start. The page listens, and tries again for every drawing.
        this.deliver();
        return listener.onError?.(message.error.message, KerfwayError.of(message.error));
      case 'answer':
        return calls.answered(message.id, message.value);
      case 'refused':
        return calls.refused(message.id, KerfwayError.of(message.error));
    }
  }

  private ready({ page, machines, methods }: Extract<FromFrame, { type: 'ready' }>): void {
    // A page says this again when it is greeted again.
    if (this.early === null && page === this.page) return;
    if (this.early === null) {
      this.calls.rejectAll(new KerfwayError('planner-died', 'The frame was loaded again before its answer. Open the drawing again.'));
      for (const message of this.settings.values()) this.post(message);
    }
    this.deliver();
    this.page = page;
    this.listener.onReady?.({ machines, methods });
  }

  /** Sends what was said before the page listened. */
  private deliver(): void {
    for (const message of this.early ?? []) this.post(message);
    this.early = null;
  }

  private async priceOf(quote: Quote): Promise<string> {
    try {
      return String((await this.listener.price?.(quote)) ?? '');
    } catch (error) {
      console.error(error);
      return '';
    }
  }

  private silent(seconds: number): void {
    const limit = this.early === null ? PATIENCE.working : PATIENCE.starting;
    if (seconds < limit) return;
    // What nobody waits for must not be done when the frame answers after all.
    if (this.early !== null) this.early = [...this.settings.values()];
    const { origin, pathname } = new URL(this.iframe.src, location.href);
    const sentence = this.early === null
      ? 'Load the frame again, then open the drawing again.'
      : `Check that ${origin}${pathname} is the frame page, and that "host" in its address is ${new URL(location.href).origin}, then try again.`;
    this.calls.rejectAll(new KerfwayError(this.early === null ? 'planner-died' : 'not-started', `The frame has not answered for ${limit} seconds. ${sentence}`, { seconds: limit }));
  }

  /** Takes a call back. The frame ends its search, unless it has another drawing by now. */
  private abort(id: number): void {
    this.calls.forget(id);
    if (this.early !== null) this.early = this.early.filter((message) => !('id' in message) || message.id !== id);
    else if (id === this.opened) this.post({ type: 'stop' });
  }
}
