/** The calls of a host that wait for an answer of the frame. Each of them settles: they are rejected when the frame is silent for too long. */

import type { KerfwayError } from '../errors.js';

interface Call {
  resolve: (value: never) => void;
  reject: (error: KerfwayError) => void;
}

export class Calls {
  private readonly waiting = new Map<number, Call>();
  private lastId = 0;
  /** Seconds since the frame was last heard, while calls wait. */
  private silence = 0;
  private timer: ReturnType<typeof setInterval> | null = null;

  /** `onSilence` gets the seconds of silence, every second while calls wait. */
  constructor(private readonly onSilence: (seconds: number) => void) {}

  /** A new call, and the promise of its answer. */
  add<T>(): { id: number; answer: Promise<T> } {
    const id = ++this.lastId;
    const answer = new Promise<T>((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    // Counted in ticks and not by the clock, because a laptop that was asleep has not waited.
    this.timer ??= setInterval(() => this.onSilence(++this.silence), 1000);
    return { id, answer };
  }

  /** The frame has been heard: it is there. */
  heard(): void {
    this.silence = 0;
  }

  /** The answer to a call has come. A call that nobody waits for any more is ignored. */
  answered(id: number, value: unknown): void {
    this.waiting.get(id)?.resolve(value as never);
    this.forget(id);
  }

  refused(id: number, error: KerfwayError): void {
    this.waiting.get(id)?.reject(error);
    this.forget(id);
  }

  /** Nobody waits for this call any more. */
  forget(id: number): void {
    this.waiting.delete(id);
    if (this.waiting.size > 0 || this.timer === null) return;
    clearInterval(this.timer);
    [this.timer, this.silence] = [null, 0];
  }

  rejectAll(error: KerfwayError): void {
    for (const id of [...this.waiting.keys()]) this.refused(id, error);
  }
}
