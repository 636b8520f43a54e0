/**
 * A pool of planners for many files: a fixed number of files are worked on at once, and the others wait their turn. When
 * a worker dies, its file is tried once more from the start by a new worker; with the same seed and moves that gives the
 * same plan. Each planner serves one file after the other, so the pool holds no more drawings than its size.
 */

import { shown } from './check.js';
import { ClosedError } from './closed.js';
import { KerfwayError } from './errors.js';
import { createFunctions, type Functions, type WithPlanner } from './functions.js';
import { onAbort } from './on-abort.js';
import type { Configuration } from './places.js';
import type { Planner } from './planner.js';
import { abortable, diedEachTime, TRIES } from './with-planner.js';

/** The size of a pool and of its queue, and where its planners run. */
export interface PoolOptions extends Configuration {
  /** How many files are worked on at once, each in a worker of its own. Default: the number of processors. */
  size?: number;
  /** How many files may wait before `room` makes its caller wait too. Default: the same as `size`. */
  queue?: number;
  /**
   * Seconds that a call may take once its turn has come, besides the `seconds` of its own search. Default 300. A call that takes
   * longer rejects with the code `deadline`, and its worker ends. `Infinity`: no deadline.
   */
  deadline?: number;
}

/** Default of `deadline`, in seconds. The largest file takes about ten to read, and quotes of 10,000 contours take about two minutes. */
export const DEADLINE = 300;

/**
 * `inspect`, `plan`, `quote`, `verifyQuote`, `render` and `check` on the pool's workers. Each call waits its turn. To process more files than fit
 * into memory, pass a function that reads the file (`() => readFile(path)`), or wait for `room` before each call. When a
 * worker dies, its file is planned again from the start, and its progress starts again too.
 */
export interface Pool extends Functions {
  /** The number of calls that wait for their turn. A server may refuse more when it is large. */
  readonly waiting: number;
  /** Resolves when there is room for one more file, so that at most `queue` calls wait. */
  room(): Promise<void>;
  /** Ends the workers. Calls that run or wait are rejected. An open pool keeps a Node process alive. */
  close(): void;
}

const CLOSED = 'The pool was closed.';

/** A call that waits for its turn. */
interface QueuedCall {
  started: boolean;
  start: () => void;
  reject: (error: Error) => void;
}

/** A pool of planners that `open` creates, each with a worker of its own. */
export function poolOf(open: () => Promise<Planner>, size: number, queue: number = size, deadline: number = DEADLINE): Pool {
  checkCount('size', size, 1);
  checkCount('queue', queue, 0);
  if (typeof deadline !== 'number' || !(deadline > 0)) throw new KerfwayError('out-of-range', `The pool's deadline is ${shown(deadline)}. Give a number of seconds above 0.`, { field: 'deadline', value: shown(deadline) });
  const planners = new PlannerQueue(open, size, deadline);
  const room = async () => {
    while (planners.load >= size + queue) await planners.change();
  };
  return {
    ...createFunctions(planners.withPlanner),
    get waiting() {
      return planners.waiting;
    },
    room,
    close: () => planners.close(),
  };
}

/** The planners of a pool, and the queue of calls that wait for one. */
class PlannerQueue {
  private working = 0;
  private readonly queue: QueuedCall[] = [];
  private readonly idle: Planner[] = [];
  private readonly all = new Set<Planner>();
  private watchers: (() => void)[] = [];
  private closed = false;

  constructor(
    private readonly open: () => Promise<Planner>,
    private readonly size: number,
    private readonly deadline: number,
  ) {}

  get waiting(): number {
    return this.queue.length;
  }

  /** The number of calls that run or wait. */
  get load(): number {
    return this.working + this.queue.length;
  }

  /** Resolves when a call ends or leaves the queue. */
  change(): Promise<void> {
    return new Promise((resolve) => this.watchers.push(resolve));
  }

  readonly withPlanner: WithPlanner = async (work, given, seconds = 0) => {
    await this.turn(given);
    const { signal, clear } = withDeadline(given, this.deadline + seconds);
    try {
      const result = await this.runWithRetries(work, signal);
      // The result of a planner that was closed meanwhile may be incomplete.
      if (this.closed) throw new ClosedError(CLOSED);
      return result;
    } catch (error) {
      throw this.closed ? new ClosedError(CLOSED) : error;
    } finally {
      clear();
      this.endTurn();
    }
  };

  close(): void {
    this.closed = true;
    for (const planner of this.all) planner.close();
    for (const call of this.queue.splice(0)) call.reject(new ClosedError(CLOSED));
    this.notify();
  }

  /** Waits until fewer calls than the pool's size are running, and counts this one. */
  private async turn(signal: AbortSignal | undefined): Promise<void> {
    signal?.throwIfAborted();
    if (this.closed) throw new ClosedError(CLOSED);
    if (this.working < this.size) {
      this.working += 1;
      return;
    }
    const call: QueuedCall = { started: false, start: () => {}, reject: () => {} };
    const started = new Promise<void>((resolve, reject) => {
      call.start = () => {
        // Counted here and not after the promise has resolved: no other call may come in between.
        this.working += 1;
        call.started = true;
        resolve();
      };
      call.reject = reject;
    });
    this.queue.push(call);
    try {
      await abortable(started, signal);
    } catch (error) {
      this.leave(call);
      throw error;
    }
  }

  /** A call that ends before its work begins. Its turn may have come just before it was aborted; then the next call gets its place. */
  private leave(call: QueuedCall): void {
    const index = this.queue.indexOf(call);
    if (index >= 0) {
      this.queue.splice(index, 1);
      this.notify();
    } else if (call.started) {
      this.endTurn();
    }
  }

  private endTurn(): void {
    this.working -= 1;
    this.queue.shift()?.start();
    this.notify();
  }

  private async runWithRetries<T>(work: (planner: Planner) => Promise<T>, signal: AbortSignal | undefined): Promise<T> {
    let why = '';
    for (let k = 0; k < TRIES; k++) {
      // A retry always gets a new planner: what killed the first may have killed idle ones too, without their having said so yet.
      const planner = await this.inTime(k === 0 ? this.idleOrNew() : this.openPlanner(), signal);
      try {
        const result = await abortable(work(planner), signal);
        if (planner.replaced === null) {
          this.idle.push(planner);
          return result;
        }
      } catch (error) {
        if (planner.replaced === null || signal?.aborted === true) {
          // After an abort the planner is still busy, so it cannot serve another file.
          if (signal?.aborted === true) this.dismiss(planner);
          else this.idle.push(planner);
          throw error;
        }
      }
      why = planner.replaced;
      this.dismiss(planner);
    }
    throw diedEachTime(why);
  }

  /** A planner, unless the signal aborts first. One that is still starting then is kept for the next call. */
  private async inTime(opening: Promise<Planner>, signal: AbortSignal | undefined): Promise<Planner> {
    try {
      return await abortable(opening, signal);
    } catch (error) {
      opening.then((planner) => (this.all.size > this.size ? this.dismiss(planner) : this.idle.push(planner)), () => {});
      throw error;
    }
  }

  // An idle planner whose worker has died is not used: it is busy starting another worker.
  private async idleOrNew(): Promise<Planner> {
    for (let planner = this.idle.pop(); planner !== undefined; planner = this.idle.pop()) {
      if (planner.replaced === null) return planner;
      this.dismiss(planner);
    }
    return this.openPlanner();
  }

  private async openPlanner(): Promise<Planner> {
    const planner = await this.open();
    this.all.add(planner);
    if (this.closed) this.dismiss(planner);
    return planner;
  }

  private dismiss(planner: Planner): void {
    this.all.delete(planner);
    planner.close();
  }

  private notify(): void {
    for (const resolve of this.watchers.splice(0)) resolve();
  }
}

function checkCount(name: string, count: number, least: number): void {
  if (!Number.isInteger(count) || count < least) throw new KerfwayError('out-of-range', `The pool's ${name} is ${shown(count)}. Give a whole number from ${least} on.`, { field: name, value: shown(count), least });
}

/** The longest time that a timer can wait, in seconds: 2^31 - 1 milliseconds. */
const LONGEST_TIMER = 2_147_483;

/** A signal that aborts with the given one, or with the code `deadline` after the given number of seconds. */
function withDeadline(given: AbortSignal | undefined, seconds: number): { signal: AbortSignal; clear: () => void } {
  const control = new AbortController();
  const follow = () => control.abort(given?.reason);
  if (given?.aborted === true) follow();
  const forget = given === undefined ? null : onAbort(given, follow);
  const late = () => control.abort(new KerfwayError('deadline', `The drawing was not finished within ${seconds} seconds. Try again when there is less to do, or raise the deadline.`, { seconds }));
  const timer = seconds <= LONGEST_TIMER ? setTimeout(late, seconds * 1000) : undefined;
  const clear = () => {
    clearTimeout(timer);
    forget?.();
  };
  return { signal: control.signal, clear };
}
