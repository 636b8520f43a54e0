/**
 * Several searches of one plan, each in a worker of its own. The planner's own worker is the first; this class opens the
 * others. Each search uses its own stream of random numbers. At fixed numbers of moves (`search.ts`) all of them wait for
 * each other and continue from the best path among them, so the same seed, moves and number of workers give the same
 * bytes, whichever worker is faster. The caller hears the best of all searches. At the end the first worker takes over
 * the best path and writes the outputs.
 */

import { bounded } from './bound.js';
import type { PlanMessage } from './plan-handle.js';
import type { Budget, DoneReason, FromWorker, LoadOptions, PlanOptions, Progress, ToWorker } from './protocol.js';
import type { WasmModule } from './wasm-module.js';
import { type SILENCE_LIMITS, type StartWorker, WorkerConnection } from './worker-connection.js';

type Done = Extract<FromWorker, { type: 'done' }>;

/** A drawing as it is sent to every worker, each of which reads it for itself. */
export interface Drawing {
  bytes: ArrayBuffer;
  name: string;
  options: LoadOptions;
}

/** What the planner provides. */
export interface SearchOwner {
  module: WasmModule;
  start: StartWorker;
  silenceLimits?: typeof SILENCE_LIMITS;
  /** Sends a message to the first worker. */
  toFirst(message: ToWorker): void;
  /** Passes a message about a plan on to its caller. */
  report(message: PlanMessage): void;
}

/** The number of the first worker; the others are 1, 2, .... */
const FIRST = 0;

export class MultiSearch {
  /** The workers besides the first, with the drawing that each has read. */
  private others: { connection: WorkerConnection; drawing: Drawing }[] = [];
  private plan: SharedPlan | null = null;

  constructor(private readonly owner: SearchOwner) {}

  /** Starts the other searches of a plan that the first worker has started. */
  begin(id: number, options: PlanOptions, drawing: Drawing): void {
    this.end();
    const count = (options.workers ?? 1) - 1;
    for (const { connection } of this.others.splice(count)) connection.close();
    this.plan = new SharedPlan(id, options, count + 1);
    for (let k = 0; k < count; k++) {
      const connection = this.workerWith(k, id, drawing);
      connection.expect('working');
      connection.post({ type: 'plan', id, options: { ...options, member: k + 1 } });
    }
  }

  /** Continues the plan `before` for another budget, as plan `id`. The searches of any other plan end. */
  continue(before: number | undefined, id: number, budget: Budget): void {
    const plan = this.plan;
    if (plan === null || plan.id !== before) return this.end();
    // It may still be running.
    if (plan.best !== null) this.finish(plan, plan.total(plan.best));
    this.plan = new SharedPlan(id, budget, this.others.length + 1);
    this.post({ type: 'continue', id, budget });
  }

  /** Whether these searches belong to the plan with this id. */
  runs(id: number): boolean {
    return this.plan?.id === id;
  }

  /** Sends a message, such as pause, resume or stop, to all workers but the first. */
  post(message: ToWorker): void {
    this.others.forEach(({ connection }, k) => {
      connection.post(message);
      // A search that has ended does not answer.
      const answers = message.type !== 'pause' && this.plan?.ended.has(k + 1) === false;
      connection.expect(answers ? 'working' : 'idle');
    });
  }

  /**
   * Stops the other searches because another plan or drawing takes the place of theirs, or the first worker is gone, and reports the best path of all.
   * If there is none yet, the last message of the first worker ends the plan.
   */
  end(reason: DoneReason = 'stopped'): void {
    const plan = this.plan;
    if (plan === null) return;
    this.plan = null;
    this.post({ type: 'stop', id: plan.id });
    if (plan.best !== null) this.finish(plan, plan.total(plan.best), reason);
  }

  close(): void {
    this.plan = null;
    for (const { connection } of this.others.splice(0)) connection.close();
  }

  /** Handles a message of any of the workers about the plan, and reports what concerns the caller. */
  receive(member: number, message: FromWorker): void {
    const plan = this.plan;
    if (plan === null || !('id' in message) || message.id !== plan.id) return;
    switch (message.type) {
      case 'started':
        if (member === FIRST) this.owner.report(message);
        return;
      case 'progress':
        this.owner.report({ ...message, progress: plan.merged(member, message.progress) });
        return;
      case 'bound':
        plan.bound = message.lowerBound;
        this.owner.report(message);
        return;
      case 'meeting':
        this.owner.report({ type: 'progress', id: plan.id, progress: plan.merged(member, message.progress) });
        plan.waiting.set(member, message.progress);
        this.others[member - 1]?.connection.expect('idle');
        this.exchangeIfAllWait(plan);
        return;
      case 'done':
        this.searchEnded(plan, member, message);
        return;
      case 'failed':
        if (member !== FIRST) return this.workerDied(member);
        if (!plan.ended.has(FIRST)) this.owner.report(message);
        this.end();
        return;
    }
  }

  // A worker that has read the drawing; it is opened when there is none yet.
  private workerWith(k: number, id: number, drawing: Drawing): WorkerConnection {
    const existing = this.others[k];
    if (existing?.drawing === drawing) return existing.connection;
    const connection = existing?.connection ?? this.open(k + 1);
    this.others[k] = { connection, drawing };
    connection.post({ type: 'load', id, ...drawing });
    return connection;
  }

  private open(member: number): WorkerConnection {
    const { start, module, silenceLimits } = this.owner;
    return new WorkerConnection(start, { module }, (m) => this.receive(member, m), () => this.workerDied(member), silenceLimits);
  }

  private searchEnded(plan: SharedPlan, member: number, message: Done): void {
    plan.waiting.delete(member);
    this.others[member - 1]?.connection.expect('idle');
    if (member === FIRST && plan.ended.has(FIRST)) return this.takenOver(plan, message);
    plan.ended.set(member, { ...message, progress: { ...message.progress } });
    plan.merged(member, message.progress);
    // A budget in moves applies to each search. Any other budget ends for all when it ends for the first.
    if (member === FIRST && !plan.inMoves) this.post({ type: 'stop', id: plan.id });
    if (member === FIRST && message.reason === 'stopped') this.post({ type: 'stop', id: plan.id });
    this.finishIfAllEnded(plan);
    this.exchangeIfAllWait(plan);
  }

  // When all have ended, the first worker takes over the best path. Its second `done` ends the plan.
  private finishIfAllEnded(plan: SharedPlan): void {
    const first = plan.ended.get(FIRST);
    if (first === undefined || plan.ended.size < plan.members.size) return;
    const best = bestOf([...plan.ended].map(([member, done]) => [member, done.progress]));
    if (best === null || best.member === FIRST) this.takenOver(plan, first);
    else this.owner.toFirst({ type: 'meet', id: plan.id, path: best.progress.path });
  }

  // The first worker has the best path.
  private takenOver(plan: SharedPlan, { progress }: Done): void {
    this.finish(plan, plan.merged(FIRST, progress, true));
  }

  private finish(plan: SharedPlan, progress: Progress, reason: DoneReason = 'stopped'): void {
    if (plan.reported) return;
    plan.reported = true;
    this.owner.report({ type: 'done', id: plan.id, reason: plan.ended.get(FIRST)?.reason ?? reason, progress });
  }

  // When every search that still runs has come to the meeting, all continue from the best path.
  private exchangeIfAllWait(plan: SharedPlan): void {
    if (plan.waiting.size === 0 || plan.waiting.size + plan.ended.size < plan.members.size) return;
    const best = bestOf([...plan.waiting]);
    for (const member of [...plan.waiting.keys()].sort((a, b) => a - b)) {
      const path = member === best?.member ? null : (best?.progress.path ?? null);
      const message: ToWorker = { type: 'meet', id: plan.id, path };
      if (member === FIRST) this.owner.toFirst(message);
      else {
        this.others[member - 1]?.connection.expect('working');
        this.others[member - 1]?.connection.post(message);
      }
    }
    plan.waiting.clear();
  }

  // A worker died. The plan continues with the workers before it; the next plan opens new ones.
  private workerDied(member: number): void {
    this.others.splice(member - 1).forEach(({ connection }) => connection.close());
    const plan = this.plan;
    if (plan === null) return;
    for (const gone of [...plan.members].filter((m) => m >= member)) plan.remove(gone);
    this.finishIfAllEnded(plan);
    this.exchangeIfAllWait(plan);
  }
}

/** The state of a plan that several workers search. */
class SharedPlan {
  /** The workers that still take part. */
  readonly members: Set<number>;
  /** The workers that wait at the meeting, with the best path of each. */
  readonly waiting = new Map<number, Progress>();
  /** The workers whose search has ended, with its last message. */
  readonly ended = new Map<number, Done>();
  /** Whether the budget is given in moves alone. */
  readonly inMoves: boolean;
  /** Whether the caller has been told that the plan is done. */
  reported = false;
  /** Lower bound of the job in seconds, as the first worker has proven it. */
  bound = 0;
  private readonly last = new Map<number, Progress>();
  /** The progress with the best path so far. */
  best: Progress | null = null;

  constructor(
    readonly id: number,
    budget: Budget,
    workers: number,
  ) {
    this.inMoves = budget.moves !== undefined && budget.seconds === undefined;
    this.members = new Set(Array.from({ length: workers }, (_, k) => k));
  }

  remove(member: number): void {
    this.members.delete(member);
    this.waiting.delete(member);
    this.ended.delete(member);
  }

  /** Turns the progress of one worker into that of all: sums of moves and rates, and the path only if it is the best so far. */
  merged(member: number, progress: Progress, withPath = false): Progress {
    this.last.set(member, { ...progress, path: null });
    const better = this.best === null || time(progress) < time(this.best);
    if (progress.path !== null && (better || withPath)) this.best = progress;
    return this.total(better || withPath ? progress : { ...progress, path: null });
  }

  /** The progress of all workers, with the path of this one. */
  total(progress: Progress): Progress {
    const sum = (number: (p: Progress) => number) => [...this.last.values()].reduce((total, p) => total + number(p), 0);
    const summary = bounded((this.best ?? progress).summary, this.bound);
    const seconds = this.last.get(FIRST)?.seconds ?? progress.seconds;
    return { moves: sum((p) => p.moves), seconds, rate: sum((p) => p.rate), summary, path: progress.path };
  }
}

const time = (progress: Progress): number => progress.summary.total_time;

/** The worker with the fastest path; on a tie, the one with the lowest number. */
function bestOf(all: [number, Progress][]): { member: number; progress: Progress } | null {
  let best: { member: number; progress: Progress } | null = null;
  for (const [member, progress] of all.sort(([a], [b]) => a - b)) {
    if (progress.path !== null && (best === null || time(progress) < time(best.progress))) best = { member, progress };
  }
  return best;
}
