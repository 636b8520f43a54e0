/**
 * The progress of a plan for readers that use `for await`. A reader that is slower than the search skips steps but always
 * gets the latest: unread progress is merged into one item, so a slow reader costs no memory.
 */

import type { Progress } from './protocol.js';

export class ProgressStream implements AsyncIterable<Progress> {
  private readonly readers = new Set<Reader>();
  private over = false;
  private failure: { error: unknown } | null = null;

  /** `onLeave` is called when a reader leaves its loop early (`break`). */
  constructor(private readonly onLeave: () => void) {}

  push(progress: Progress): void {
    for (const reader of this.readers) reader.push(progress);
  }

  /** Ends the stream, with the error if the plan failed. */
  end(failure: { error: unknown } | null = null): void {
    this.over = true;
    this.failure = failure;
    for (const reader of this.readers) reader.end(failure);
    this.readers.clear();
  }

  /** A reader of the progress from now on. After the end it ends at once, or throws the error of the plan. */
  [Symbol.asyncIterator](): AsyncIterator<Progress, undefined> {
    const reader = new Reader(() => {
      this.readers.delete(reader);
      this.onLeave();
    });
    if (this.over) reader.end(this.failure);
    else this.readers.add(reader);
    return reader;
  }
}

class Reader implements AsyncIterator<Progress, undefined> {
  /** Progress that has not been read yet. */
  private unread: Progress | null = null;
  private ended: { failure: { error: unknown } | null } | null = null;
  private waiting: (() => void)[] = [];

  constructor(private readonly onLeave: () => void) {}

  push(progress: Progress): void {
    this.unread = { ...progress, path: progress.path ?? this.unread?.path ?? null };
    this.wake();
  }

  end(failure: { error: unknown } | null): void {
    this.ended = { failure };
    this.wake();
  }

  async next(): Promise<IteratorResult<Progress, undefined>> {
    while (this.unread === null && this.ended === null) await new Promise<void>((resolve) => this.waiting.push(resolve));
    const value = this.unread;
    this.unread = null;
    if (value !== null) return { done: false, value };
    const failure = this.ended?.failure ?? null;
    // The error is thrown once; after that the reader has ended.
    this.ended = { failure: null };
    if (failure !== null) throw failure.error;
    return { done: true, value: undefined };
  }

  async return(): Promise<IteratorResult<Progress, undefined>> {
    if (this.ended === null) this.onLeave();
    this.ended = { failure: null };
    this.unread = null;
    this.wake();
    return { done: true, value: undefined };
  }

  private wake(): void {
    for (const resolve of this.waiting.splice(0)) resolve();
  }
}
