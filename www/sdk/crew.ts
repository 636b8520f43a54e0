/**
 * Several searches of one plan. The planner's own worker is the first; the others are this crew's. Each draws on random
 * numbers of its own; at fixed counts of moves (`search.ts`) all wait for each other and go on from the best path
 * there is, so the same seed, moves and number of workers give the same bytes, whoever is faster. What the caller
 * hears is the best of all; at the end the first worker takes it over, and writes the outputs.
 */

import { bounded } from './bound.js';
import { Line, type PATIENCE, type StartWorker } from './line.js';
import type { PlanMessage } from './plan-handle.js';
import type { Budget, FromWorker, LoadOptions, PlanOptions, Progress, ToWorker } from './protocol.js';

type Done = Extract<FromWorker, { type: 'done' }>;

/** A drawing, as every worker reads it for itself. */
export interface Drawing {
  bytes: ArrayBuffer;
  name: string;
  options: LoadOptions;
}

/** What the crew needs of the planner. */
export interface Captain {
  module: WebAssembly.Module;
  start: StartWorker;
  patience?: typeof PATIENCE;
  /** Sends a message to the first worker. */
  toFirst(message: ToWorker): void;
  /** Tells of a plan. */
  tell(message: PlanMessage): void;
}

/** The first worker's number; the crew's are 1, 2, .... */
const FIRST = 0;

export class Crew {
  /** The workers besides the first, with the drawing each has read. */
  private others: { line: Line; drawing: Drawing }[] = [];
  private plan: SharedPlan | null = null;

  constructor(private readonly captain: Captain) {}

  /** The plan of which the first worker says that it has started gets the others' help. */
  begin(id: number, options: PlanOptions, drawing: Drawing): void {
    this.end();
    const count = (options.workers ?? 1) - 1;
    for (const { line } of this.others.splice(count)) line.close();
    this.plan = new SharedPlan(id, options, count + 1);
    for (let k = 0; k < count; k++) {
      const line = this.reader(k, id, drawing);
      line.expect('working');
      line.post({ type: 'plan', id, options: { ...options, member: k + 1 } });
    }
  }

  /** Goes on with the plan that is done, for another budget. */
  again(id: number, budget: Budget): void {
    if (this.plan === null) return;
    this.plan = new SharedPlan(id, budget, this.others.length + 1);
    this.post({ type: 'continue', id, budget });
  }

  /** Whether this is the plan the crew works on. */
  works(id: number): boolean {
    return this.plan?.id === id;
  }

  /** Pause, resume or stop, as the first worker is told too. */
  post(message: ToWorker): void {
    for (const { line } of this.others) {
      line.post(message);
      line.expect(message.type === 'pause' ? 'idle' : 'working');
    }
  }

  /** Ends the help: another plan begins, or the first worker is gone. What the first one had is told. */
  end(): void {
    const plan = this.plan;
    if (plan === null) return;
    this.post({ type: 'stop' });
    const first = plan.ended.get(FIRST);
    if (first !== undefined) this.over(plan, first);
    this.plan = null;
  }

  close(): void {
    this.plan = null;
    for (const { line } of this.others.splice(0)) line.close();
  }

  /** What the first worker or another says of the plan; passes on what its caller should hear. */
  hear(member: number, message: FromWorker): void {
    const plan = this.plan;
    if (plan === null || !('id' in message) || message.id !== plan.id) return;
    switch (message.type) {
      case 'started':
        if (member === FIRST) this.captain.tell(message);
        return;
      case 'progress':
        this.captain.tell({ ...message, progress: plan.merged(member, message.progress) });
        return;
      case 'bound':
        plan.bound = message.lowerBound;
        this.captain.tell(message);
        return;
      case 'meeting':
        this.captain.tell({ type: 'progress', id: plan.id, progress: plan.merged(member, message.progress) });
        plan.waiting.set(member, message.progress);
        this.others[member - 1]?.line.expect('idle');
        this.meet(plan);
        return;
      case 'done':
        this.done(plan, member, message);
        return;
      case 'failed':
        if (member === FIRST) {
          this.end();
          this.captain.tell(message);
        } else this.lose(member);
        return;
    }
  }

  // A worker with the drawing read; a new one where there is none yet.
  private reader(k: number, id: number, drawing: Drawing): Line {
    const there = this.others[k];
    if (there?.drawing === drawing) return there.line;
    const line = there?.line ?? this.opened(k + 1);
    this.others[k] = { line, drawing };
    line.post({ type: 'load', id, ...drawing });
    return line;
  }

  private opened(member: number): Line {
    const { start, module, patience } = this.captain;
    return new Line(start, module, (m) => this.hear(member, m), () => this.lose(member), patience);
  }

  private done(plan: SharedPlan, member: number, message: Done): void {
    plan.waiting.delete(member);
    this.others[member - 1]?.line.expect('idle');
    if (member === FIRST && plan.ended.has(FIRST)) return this.over(plan, message);
    plan.ended.set(member, { ...message, progress: { ...message.progress } });
    plan.merged(member, message.progress);
    // A budget in moves is that of each; otherwise it is over for all when it is over for the first.
    if (member === FIRST && !plan.inMoves) this.post({ type: 'stop' });
    if (member === FIRST && message.reason === 'stopped') this.post({ type: 'stop' });
    this.finish(plan);
    this.meet(plan);
  }

  // All have ended: the first worker takes the best over and says so, which ends the plan.
  private finish(plan: SharedPlan): void {
    const first = plan.ended.get(FIRST);
    if (first === undefined || plan.ended.size < plan.crew.size) return;
    const best = bestOf([...plan.ended].map(([member, done]) => [member, done.progress]));
    if (best === null || best.member === FIRST) this.over(plan, first);
    else this.captain.toFirst({ type: 'meet', id: plan.id, path: best.progress.path });
  }

  private over(plan: SharedPlan, { progress }: Done): void {
    if (plan.told) return;
    plan.told = true;
    const reason = plan.ended.get(FIRST)?.reason ?? 'stopped';
    this.captain.tell({ type: 'done', id: plan.id, reason, progress: plan.merged(FIRST, progress, true) });
  }

  // Everybody who still works is here: all go on, from the best path.
  private meet(plan: SharedPlan): void {
    if (plan.waiting.size === 0 || plan.waiting.size + plan.ended.size < plan.crew.size) return;
    const best = bestOf([...plan.waiting]);
    for (const member of [...plan.waiting.keys()].sort((a, b) => a - b)) {
      const path = member === best?.member ? null : (best?.progress.path ?? null);
      const message: ToWorker = { type: 'meet', id: plan.id, path };
      if (member === FIRST) this.captain.toFirst(message);
      else {
        this.others[member - 1]?.line.expect('working');
        this.others[member - 1]?.line.post(message);
      }
    }
    plan.waiting.clear();
  }

  // A worker of the crew died: the others go on without it, and the next plan opens a new one.
  private lose(member: number): void {
    this.others.splice(member - 1).forEach(({ line }) => line.close());
    const plan = this.plan;
    if (plan === null) return;
    for (const gone of [...plan.crew].filter((m) => m >= member)) plan.leave(gone);
    this.finish(plan);
    this.meet(plan);
  }
}

/** What is known of a plan that several work on. */
class SharedPlan {
  /** Who still belongs to it. */
  readonly crew: Set<number>;
  /** Who waits where all meet, with the best path of each. */
  readonly waiting = new Map<number, Progress>();
  /** Who has ended, and how. */
  readonly ended = new Map<number, Done>();
  /** The budget is one in moves alone. */
  readonly inMoves: boolean;
  /** Its caller knows that it is over. */
  told = false;
  /** What no plan can be under, s: the first worker proves it. */
  bound = 0;
  private readonly last = new Map<number, Progress>();
  private best: Progress | null = null;

  constructor(
    readonly id: number,
    budget: Budget,
    workers: number,
  ) {
    this.inMoves = budget.moves !== undefined && budget.seconds === undefined;
    this.crew = new Set(Array.from({ length: workers }, (_, k) => k));
  }

  leave(member: number): void {
    this.crew.delete(member);
    this.waiting.delete(member);
    this.ended.delete(member);
  }

  /** One worker's news as news of all: moves and rates together, the path only where it is the best yet. */
  merged(member: number, progress: Progress, withPath = false): Progress {
    this.last.set(member, { ...progress, path: null });
    const better = this.best === null || time(progress) < time(this.best);
    if (progress.path !== null && (better || withPath)) this.best = progress;
    const path = progress.path !== null && (better || withPath) ? progress.path : null;
    const of = (number: (p: Progress) => number) => [...this.last.values()].reduce((sum, p) => sum + number(p), 0);
    const summary = bounded((this.best ?? progress).summary, this.bound);
    const seconds = this.last.get(FIRST)?.seconds ?? progress.seconds;
    return { moves: of((p) => p.moves), seconds, rate: of((p) => p.rate), summary, path };
  }
}

const time = (progress: Progress): number => progress.summary.total_time;

/** The one with the fastest path; of equals, the lowest number. */
function bestOf(all: [number, Progress][]): { member: number; progress: Progress } | null {
  let best: { member: number; progress: Progress } | null = null;
  for (const [member, progress] of all.sort(([a], [b]) => a - b)) {
    if (progress.path !== null && (best === null || time(progress) < time(best.progress))) best = { member, progress };
  }
  return best;
}
