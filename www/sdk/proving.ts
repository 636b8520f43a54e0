/**
 * The worker's side of a proof: works on the lower bound of a job in slices and reports what is proven. It has a worker to
 * itself, because the search must not wait for it.
 */

import type { Proof as Work } from './pkg/kerfway_research.js';
import { later } from './search.js';
import type { Proof, ProofBudget, WarmPath } from './protocol.js';

/** Numbers of one call: about a hundredth of a second, so that a stop takes effect at once. */
const SLICE = 2_000_000;
/** Longest time between two reports, far below the silence after which a worker counts as hung. */
const QUIET_MS = 5000;
/**
 * Shortest time between two paths. A plan takes them over after its search, and in its first seconds a proof finds many, each of which a later
 * one replaces.
 */
const PATH_MS = 1000;
/** The unit of `ProofBudget.work`, in numbers. */
const MILLION = 1_000_000;

export class Proving {
  private stopped = false;

  constructor(private readonly work: Work) {}

  /** Works until the budget is used up or nothing more can be proven. Each higher bound is reported, and a better path soon. */
  run({ seconds = Infinity, work = Infinity }: ProofBudget, report: (seconds: number, path: WarmPath | null) => void): Promise<Omit<Proof, 'path'>> {
    const until = performance.now() + 1000 * seconds;
    const most = work * MILLION;
    let [done, proven, reportBy, pathFrom] = [0, 0, performance.now() + QUIET_MS, performance.now() + PATH_MS];
    return new Promise((resolve, reject) => {
      const slice = () => {
        try {
          const more = done < most && this.work.improve(Math.min(SLICE, most - done));
          done += SLICE;
          const bound = this.work.seconds();
          const now = performance.now();
          const better = now >= pathFrom ? this.work.betterPath() : null;
          if (better !== null) pathFrom = now + PATH_MS;
          if (bound > proven || better !== null || now >= reportBy) {
            [proven, reportBy] = [bound, now + QUIET_MS];
            report(bound, better);
          }
          if (more && !this.stopped && now < until) later(slice);
          else {
            const last = this.work.betterPath();
            if (last !== null) report(bound, last);
            resolve({ seconds: bound, certificate: this.work.certificate() ?? null, hindrance: this.work.hindrance() ?? null });
          }
        } catch (error) {
          reject(error as Error);
        }
      };
      later(slice);
    });
  }

  stop(): void {
    this.stopped = true;
  }
}
