/**
 * News of a plan for those who read it with `for await`. A reader that is slower than the search misses steps between
 * but never the latest: what has not been read yet is merged into one, so a slow reader costs no memory.
 */

import type { Progress } from './protocol.js';

export class News implements AsyncIterable<Progress> {
  private readonly readers = new Set<Reader>();
  private over = false;
  private failure: { error: unknown } | null = null;

  /** `left`: a reader has had enough (`break`). */
  constructor(private readonly left: () => void) {}

  tell(progress: Progress): void {
    for (const reader of this.readers) reader.tell(progress);
  }

  /** No more will come. */
  end(failure: { error: unknown } | null = null): void {
    this.over = true;
    this.failure = failure;
    for (const reader of this.readers) reader.end(failure);
    this.readers.clear();
  }

  /** A reader of what comes from now on; after the end, it ends at once, or throws what the plan failed with. */
  [Symbol.asyncIterator](): AsyncIterator<Progress, undefined> {
    const reader = new Reader(() => {
      this.readers.delete(reader);
      this.left();
    });
    if (this.over) reader.end(this.failure);
    else this.readers.add(reader);
    return reader;
  }
}

class Reader implements AsyncIterator<Progress, undefined> {
  /** Told, not read yet. */
  private latest: Progress | null = null;
  private ended: { failure: { error: unknown } | null } | null = null;
  private waiting: (() => void)[] = [];

  constructor(private readonly leave: () => void) {}

  tell(progress: Progress): void {
    this.latest = { ...progress, path: progress.path ?? this.latest?.path ?? null };
    this.wake();
  }

  end(failure: { error: unknown } | null): void {
    this.ended = { failure };
    this.wake();
  }

  async next(): Promise<IteratorResult<Progress, undefined>> {
    while (this.latest === null && this.ended === null) await new Promise<void>((resolve) => this.waiting.push(resolve));
    const value = this.latest;
    this.latest = null;
    if (value !== null) return { done: false, value };
    const failure = this.ended?.failure ?? null;
    // Thrown once: after that the reader has ended.
    this.ended = { failure: null };
    if (failure !== null) throw failure.error;
    return { done: true, value: undefined };
  }

  async return(): Promise<IteratorResult<Progress, undefined>> {
    if (this.ended === null) this.leave();
    this.ended = { failure: null };
    this.latest = null;
    this.wake();
    return { done: true, value: undefined };
  }

  private wake(): void {
    for (const resolve of this.waiting.splice(0)) resolve();
  }
}
