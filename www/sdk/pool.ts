/**
 * A pool of planners for many files: so many are worked on at once, the others wait their turn. A worker that dies loses
 * nothing: its file is tried again from the start, once, by a new one; with the same seed and moves that gives the
 * same plan. Planners serve one file after the other, so what is held is no more than the pool's size in drawings.
 */

import { ClosedError } from './closed.js';
import { functionsOn, type Functions, type Lend } from './functions.js';
import { abortable } from './lend.js';
import type { Planner } from './planner.js';

/** How large a pool is. */
export interface PoolOptions {
  /** Files worked on at once, each in a worker of its own. Default: the processors there are. */
  size?: number;
  /** Files that may wait besides before `room` lets its caller wait, too. Default: as many as are worked on. */
  queue?: number;
}

/**
 * `inspect`, `plan`, `quote` and `render` by the pool's workers: each call waits its turn. To go through more files than fit
 * into memory, hand over what reads a file (`() => readFile(path)`), or wait for `room` before each. A file whose worker
 * died is planned anew, and its news begin anew.
 */
export interface Pool extends Functions {
  /** Calls that wait for their turn: a server may refuse more when there are many. */
  readonly waiting: number;
  /** Resolves when there is room for one more file: all that wait are then at most the pool's `queue`. */
  room(): Promise<void>;
  /** Ends the workers; what is under way or waits is rejected. An open pool keeps a process alive. */
  close(): void;
}

const CLOSED = 'The pool was closed.';

/** Tries of a file whose worker died. */
const TRIES = 2;

/** A call that waits. */
interface Turn {
  come: () => void;
  refuse: (error: Error) => void;
}

/** A pool of planners, each of its own worker, that `open` gives. */
export function poolOf(open: () => Promise<Planner>, size: number, queue: number = size): Pool {
  counted('size', size, 1);
  counted('queue', queue, 0);
  const benches = new Benches(open, size);
  const room = async () => {
    while (benches.load >= size + queue) await benches.change();
  };
  return {
    ...functionsOn(benches.lend),
    get waiting() {
      return benches.waiting;
    },
    room,
    close: () => benches.close(),
  };
}

/** Where the planners of a pool sit, and who waits for one. */
class Benches {
  private working = 0;
  private readonly turns: Turn[] = [];
  private readonly idle: Planner[] = [];
  private readonly all = new Set<Planner>();
  private watchers: (() => void)[] = [];
  private closed = false;

  constructor(
    private readonly open: () => Promise<Planner>,
    private readonly size: number,
  ) {}

  get waiting(): number {
    return this.turns.length;
  }

  /** Files that are worked on or wait. */
  get load(): number {
    return this.working + this.turns.length;
  }

  /** Resolves when a file is done with. */
  change(): Promise<void> {
    return new Promise((resolve) => this.watchers.push(resolve));
  }

  readonly lend: Lend = async (work, signal) => {
    await this.turn(signal);
    try {
      const result = await this.tried(work, signal);
      // What a planner had when it was closed is not the whole of what was asked.
      if (this.closed) throw new ClosedError(CLOSED);
      return result;
    } catch (error) {
      throw this.closed ? new ClosedError(CLOSED) : error;
    } finally {
      this.working -= 1;
      this.turns.shift()?.come();
      this.tellChange();
    }
  };

  close(): void {
    this.closed = true;
    for (const planner of this.all) planner.close();
    for (const turn of this.turns.splice(0)) turn.refuse(new ClosedError(CLOSED));
    this.tellChange();
  }

  private async turn(signal: AbortSignal | undefined): Promise<void> {
    signal?.throwIfAborted();
    if (this.closed) throw new ClosedError(CLOSED);
    if (this.working >= this.size) {
      const turn: Turn = { come: () => {}, refuse: () => {} };
      const come = new Promise<void>((resolve, reject) => {
        turn.come = () => {
          // Taken here and not by the one who waits: between the two nobody may slip in.
          this.working += 1;
          resolve();
        };
        turn.refuse = reject;
      });
      this.turns.push(turn);
      try {
        return await abortable(come, signal);
      } catch (error) {
        this.leave(turn);
        throw error;
      }
    }
    this.working += 1;
  }

  private leave(turn: Turn): void {
    const at = this.turns.indexOf(turn);
    if (at >= 0) this.turns.splice(at, 1);
    this.tellChange();
  }

  private async tried<T>(work: (planner: Planner) => Promise<T>, signal: AbortSignal | undefined): Promise<T> {
    let why = '';
    for (let k = 0; k < TRIES; k++) {
      // Not again one that was idle: what killed a worker may have killed those beside it, and not be told yet.
      const planner = await (k === 0 ? this.seated() : this.opened());
      try {
        const result = await abortable(work(planner), signal);
        if (planner.replaced === null) {
          this.idle.push(planner);
          return result;
        }
      } catch (error) {
        if (planner.replaced === null || signal?.aborted === true) {
          // An aborted planner is still at work.
          if (signal?.aborted === true) this.dismiss(planner);
          else this.idle.push(planner);
          throw error;
        }
      }
      why = planner.replaced;
      this.dismiss(planner);
    }
    throw new Error(`${why} It was tried ${TRIES} times; this file may need more memory than there is.`);
  }

  // An idle planner whose worker died meanwhile is of no use: it is busy starting another.
  private async seated(): Promise<Planner> {
    for (let planner = this.idle.pop(); planner !== undefined; planner = this.idle.pop()) {
      if (planner.replaced === null) return planner;
      this.dismiss(planner);
    }
    return this.opened();
  }

  private async opened(): Promise<Planner> {
    const planner = await this.open();
    this.all.add(planner);
    if (this.closed) this.dismiss(planner);
    return planner;
  }

  private dismiss(planner: Planner): void {
    this.all.delete(planner);
    planner.close();
  }

  private tellChange(): void {
    for (const resolve of this.watchers.splice(0)) resolve();
  }
}

function counted(name: string, count: number, least: number): void {
  if (!Number.isInteger(count) || count < least) throw new RangeError(`The pool's ${name} is ${count}. Give a whole number from ${least} on.`);
}
