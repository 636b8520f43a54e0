/**
 * The worker of a planner: its requests, the plans that run in it, and the drawing that it has. A worker that dies or hangs is
 * replaced: the drawing is loaded again and the best plan is restored, so no result is lost.
 */

import { ClosedError, KerfwayError } from './errors.js';
import { MultiSearch, type Drawing } from './multi-search.js';
import { type PlanHandle, type PlanMessage, RunningPlan } from './plan-handle.js';
import type { Budget, FromWorker, Progress, ToWorker } from './protocol.js';
import { Requests } from './requests.js';
import type { Responses } from './responses.js';
import { type SILENCE_LIMITS, type StartWorker, type WasmFiles, WorkerConnection } from './worker-connection.js';
import { WorkerStart } from './worker-start.js';

/** What a planner needs. */
export interface Parts extends WasmFiles {
  start: StartWorker;
  onReplaced?: ((message: string) => void) | undefined;
  /** Seconds after which a silent worker counts as hung. */
  silenceLimits?: typeof SILENCE_LIMITS;
}

/** What a worker tells its planner. */
interface Told {
  /** It has started, for the first time or again. */
  ready(message: Extract<FromWorker, { type: 'ready' }>): void;
  /** It has died for this reason, and another one takes its place. */
  replaced(why: string): void;
}

const CLOSED = 'The planner was closed.';

/** The worker of one planner, from its start to its end. */
export class PlannerWorker {
  /** The drawing in the worker. */
  drawing: Drawing | null = null;
  /** The last plan, running or ended. */
  current: RunningPlan | null = null;
  /** Plans that continue one which has not begun, each the one before it. */
  continued: { before: number; id: number; budget: Budget }[] = [];
  closed = false;
  /** The other searches of a plan with several workers. */
  readonly others: MultiSearch;

  private connection!: WorkerConnection;
  private lastId = 0;
  private readonly requests = new Requests();
  /** Running plans: one, and for a moment also the one that it replaces. */
  private readonly plans = new Map<number, RunningPlan>();
  /** Messages wait for this: it resolves when the worker has started and has read the drawing. */
  private ready: Promise<void> = Promise.resolve();
  private readonly starting = new WorkerStart();
  private restoring = false;

  constructor(
    private readonly parts: Parts,
    private readonly told: Told,
  ) {
    this.others = new MultiSearch({
      ...parts,
      toFirst: (message) => this.connection.post(message),
      report: (message) => this.report(message),
    });
  }

  /** Starts the worker, and resolves when it is ready. */
  open(): Promise<void> {
    this.ready = this.connect();
    return this.ready;
  }

  /** The answer of the worker to a request, once it is ready. */
  async ask<K extends keyof Responses>(message: (id: number) => ToWorker): Promise<Responses[K]> {
    await this.ready;
    return this.request<K>(message);
  }

  /** Begins a plan. If `prepare` refuses it, it fails and a running one goes on. Otherwise `prepare` returns the message that begins it. */
  begin(onProgress: (progress: Progress) => unknown, prepare: (plan: RunningPlan) => ToWorker): PlanHandle {
    const plan = new RunningPlan(++this.lastId, onProgress, (message) => {
      this.whenReady(message);
      if (this.others.runs(plan.id)) this.others.post(message);
    });
    try {
      this.refuseClosed();
      this.whenReady(prepare(plan), (error) => {
        this.plans.delete(plan.id);
        plan.fail(error);
      });
      this.current = plan;
      this.plans.set(plan.id, plan);
    } catch (error) {
      plan.fail(error);
    }
    return plan.handle;
  }

  /** Sends a message once the worker is ready. `failed` hears why it cannot be sent. What concerns a plan that could not begin needs no sending. */
  whenReady(message: ToWorker, failed: (error: unknown) => void = () => {}): void {
    const post = () => {
      this.connection.post(message);
      this.updateExpectation();
    };
    this.ready.then(post).catch(failed);
  }

  /** Throws a `ClosedError` once the planner was closed. */
  refuseClosed(): void {
    if (this.closed) throw new ClosedError(CLOSED);
  }

  /** Ends the worker. Requests and plans that are running are rejected. */
  close(): void {
    this.closed = true;
    this.others.close();
    this.connection.close();
    const reason = new ClosedError(CLOSED);
    // Calls that wait for a worker that is still starting are rejected too.
    this.ready.catch(() => {});
    this.starting.fail(reason);
    this.abandon(reason);
  }

  private request<K extends keyof Responses>(message: (id: number) => ToWorker): Promise<Responses[K]> {
    if (this.closed) return Promise.reject(new ClosedError(CLOSED));
    const id = ++this.lastId;
    this.connection.post(message(id));
    const answer = this.requests.add<K>(id);
    this.updateExpectation();
    return answer;
  }

  private connect(): Promise<void> {
    const open = () => {
      const { start, silenceLimits } = this.parts;
      this.connection = new WorkerConnection(start, this.parts, (m) => this.receive(m), (why) => this.lost(why), silenceLimits);
      this.connection.expect('working');
    };
    return this.starting.run(open, () => (this.closed ? new ClosedError(CLOSED) : null));
  }

  private lost(why: string): void {
    if (this.starting.running) this.starting.fail(new KerfwayError('planner-died', why));
    else void this.replace(why);
  }

  private receive(message: FromWorker): void {
    if (message.type === 'ready') {
      this.told.ready(message);
      this.starting.succeed();
    } else if ('id' in message) {
      this.deliver(message);
    }
    this.updateExpectation();
  }

  private deliver(message: Extract<FromWorker, { id: number }>): void {
    const plan = this.plans.get(message.id);
    if (plan !== undefined) {
      const { workers = 1 } = plan.options;
      const isLast = plan === this.current || this.continued[0]?.before === plan.id;
      if (message.type === 'started' && workers > 1 && this.drawing !== null && isLast) {
        this.others.begin(plan.id, { ...plan.options, seed: message.seed }, this.drawing);
        for (const { before, id, budget } of this.continued.splice(0)) this.others.continue(before, id, budget);
      }
      if (this.others.runs(plan.id)) this.others.receive(0, message);
      // Its other searches have ended, so there is nobody to wait for.
      else if (message.type === 'meeting') this.connection.post({ type: 'meet', id: plan.id, path: null });
      else this.report(message as PlanMessage);
    } else {
      this.requests.settle(message);
    }
  }

  private report(message: PlanMessage): void {
    const plan = this.plans.get(message.id);
    plan?.receive(message);
    if (plan?.ended === true) this.plans.delete(message.id);
    this.updateExpectation();
  }

  // Tells the connection what the worker is doing now, which decides how long it may stay silent.
  private updateExpectation(): void {
    const plans = [...this.plans.values()].filter((p) => !p.paused);
    // One of several searches sends nothing while it waits for the others.
    const sendsProgress = (p: RunningPlan) => p.begun !== null && !this.others.runs(p.id);
    const searching = plans.length > 0 && plans.every(sendsProgress) && !this.requests.pending;
    const busy = plans.length > 0 || this.requests.pending;
    this.connection.expect(searching ? 'searching' : busy ? 'working' : 'idle');
  }

  // A worker died. A drawing that it was reading is not read again, because it may have caused the death. The drawing from
  // before is restored once: if the new worker dies of that, it is replaced by one without a drawing.
  private async replace(why: string): Promise<void> {
    const kept = this.restoring ? null : this.drawing;
    this.told.replaced(why);
    const message = `${why} It was started again${kept === null ? '.' : ' and the drawing loaded again.'}`;
    this.abandon(new KerfwayError('planner-died', message));
    const plan = kept === null ? null : this.current;
    [this.drawing, this.current] = [null, plan];
    this.ready = this.connect().then(() => (kept === null ? undefined : this.restore(kept, plan)));
    // If the worker could not be started, later calls reject with the reason.
    const started = await this.ready.then(() => true, () => false);
    if (started) this.reportReplacement(message);
  }

  // This callback belongs to no call, so there is nobody to pass its errors to.
  private reportReplacement(message: string): void {
    try {
      const returned: unknown = this.parts.onReplaced?.(message);
      if (returned instanceof Promise) returned.catch(() => {});
    } catch {}
  }

  private async restore(drawing: Drawing, plan: RunningPlan | null): Promise<void> {
    this.restoring = true;
    try {
      await this.request<'load'>((id) => ({ type: 'load', id, ...drawing }));
      this.drawing = drawing;
      if (plan === null || plan.path === null || plan.begun === null) return;
      const { seed, method } = plan.begun;
      const options = { ...plan.options, seed, method, warm: plan.path, seconds: undefined, moves: 0 };
      await this.request<'restore'>((id) => ({ type: 'plan', id, options }));
    } finally {
      this.restoring = false;
    }
  }

  private abandon(reason: Error): void {
    this.others.end('replaced');
    this.requests.rejectAll(reason);
    for (const plan of this.plans.values()) plan.interrupt(reason);
    this.plans.clear();
  }
}
