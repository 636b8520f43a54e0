/** The requests to a worker that wait for their answers. */

import { KerfwayError } from './errors.js';
import type { FromWorker } from './protocol.js';
import { FINAL, type Responses } from './responses.js';

interface Waiting {
  resolve: (answer: never) => void;
  reject: (error: Error) => void;
}

export class Requests {
  private readonly waiting = new Map<number, Waiting>();

  /** Whether a request waits. */
  get pending(): boolean {
    return this.waiting.size > 0;
  }

  /** A promise of the answer to the request with this id. */
  add<K extends keyof Responses>(id: number): Promise<Responses[K]> {
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  /** Settles the request that this message answers. A message that is not the final answer of a request does nothing. */
  settle(message: Extract<FromWorker, { id: number }>): void {
    const request = this.waiting.get(message.id);
    if (request === undefined || !FINAL.has(message.type)) return;
    this.waiting.delete(message.id);
    if (message.type === 'failed') request.reject(KerfwayError.of(message.error));
    else request.resolve(message as never);
  }

  /** Rejects all requests: their worker is gone. */
  rejectAll(reason: Error): void {
    for (const { reject } of this.waiting.values()) reject(reason);
    this.waiting.clear();
  }
}
