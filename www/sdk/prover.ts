/** A proof in a worker of its own, beside the search: the planner's side. */

import { KerfwayError } from './errors.js';
import type { Drawing } from './multi-search.js';
import type { FromWorker, PlanOptions, Proof, ProofBudget, WarmPath } from './protocol.js';
import { type SILENCE_LIMITS, type StartWorker, WorkerConnection } from './worker-connection.js';
import type { WasmModule } from './wasm-module.js';

/** A running proof. */
export interface ProofHandle {
  /**
   * Resolves when the proof ends for any reason, also when its worker dies: what was reported is proven. Rejects with one sentence when the drawing cannot
   * be planned.
   */
  readonly done: Promise<Proof>;
  /** Ends the proof; what is proven is kept, and its certificate is made, which may take some time. */
  stop(): void;
  /** Ends the proof at once, without a certificate. Bounds that were reported stay. */
  close(): void;
}

export class Prover implements ProofHandle {
  readonly done: Promise<Proof>;
  private readonly connection: WorkerConnection;
  private settle!: { resolve: (proof: Proof) => void; reject: (error: Error) => void };
  private proven = 0;
  private path: WarmPath | null = null;

  constructor(
    { start, module, silenceLimits }: { start: StartWorker; module: WasmModule; silenceLimits?: typeof SILENCE_LIMITS },
    { bytes, name, options }: Drawing,
    planning: PlanOptions,
    budget: ProofBudget,
    private readonly onBound: (seconds: number, path: WarmPath | null) => unknown,
  ) {
    this.done = new Promise((resolve, reject) => (this.settle = { resolve, reject }));
    this.connection = new WorkerConnection(start, { module }, (m) => this.receive(m), (why) => this.end(why), silenceLimits);
    this.connection.post({ type: 'prove', id: 0, bytes, name, options, planning, budget });
    this.connection.expect('working');
  }

  stop(): void {
    this.connection.post({ type: 'stop', id: 0 });
  }

  close(): void {
    this.connection.close();
    this.end(null);
  }

  /** Ends with what was reported. `hindrance`: why there is no more. */
  private end(hindrance: string | null): void {
    this.finish({ seconds: this.proven, certificate: null, hindrance });
  }

  private finish(proof: Omit<Proof, 'path'>): void {
    this.settle.resolve({ ...proof, path: this.path });
  }

  private receive(message: FromWorker): void {
    if (message.type === 'bound') {
      this.proven = message.lowerBound;
      this.path = message.path ?? this.path;
      const heard = async () => this.onBound(this.proven, this.path);
      // A callback that throws (or rejects) fails its proof.
      heard().catch((error: Error) => {
        this.connection.close();
        this.settle.reject(error);
      });
    } else if (message.type === 'proof' || message.type === 'failed') {
      this.connection.close();
      if (message.type === 'failed') this.settle.reject(KerfwayError.of(message.error));
      else this.finish(message.proof);
    }
  }
}
