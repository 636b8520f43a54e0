/**
 * A preview of the drawing as other options would read it, while the current plan goes on. A planner of its own reads it, so that nothing has
 * to wait. Only the newest request counts; requests between two readings are skipped.
 */

import { createPlanner, type Loaded, type LoadOptions, type Planner } from 'kerfway';
import { Emitter } from '../core/emitter.js';
import { messageOf } from '../core/strings.js';
import { compareReadings, type Comparison } from './comparison.js';
import type { Source } from './drawing.js';
import type { Session } from './session.js';

/** Milliseconds without a new request before the drawing is read: moving a slider makes sixty requests a second. */
const REST = 120;
/** Milliseconds for which the planner is kept after the last request. */
const KEPT = 30_000;

interface Events extends Record<string, unknown> {
  /** What would change; null when the preview has ended. */
  comparison: Comparison | null;
  /** The options are not possible: one sentence. */
  refused: string;
}

export class Preview extends Emitter<Events> {
  private requested: LoadOptions | null = null;
  private timer = 0;
  private working = false;
  /** The planner, and the drawing that it has read. */
  private held: { source: Source; planner: Promise<Planner> } | null = null;
  private releaseTimer = 0;

  constructor(private readonly session: Session) {
    super();
    const end = () => {
      this.clear();
      this.release();
    };
    session.store.on('loaded', ({ fresh }) => (fresh ? end() : this.clear()));
    session.store.on('cleared', end);
  }

  /** Reads the drawing with these options, soon. */
  request(options: LoadOptions): void {
    this.requested = options;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.work(), REST);
  }

  /** Ends the preview. */
  clear(): void {
    this.requested = null;
    clearTimeout(this.timer);
    this.emit('comparison', null);
  }

  private async work(): Promise<void> {
    if (this.working) return;
    this.working = true;
    clearTimeout(this.releaseTimer);
    let done: LoadOptions | null = null;
    while (this.requested !== null && this.requested !== done) {
      done = this.requested;
      try {
        const then = await this.read(done);
        const now = this.session.state.loaded;
        // When another request has arrived meanwhile, it is read next.
        if (this.requested === done && now !== null && then !== null) this.emit('comparison', compareReadings(now, then, done.joinTolerance ?? 0));
      } catch (error) {
        if (this.requested === done) this.emit('refused', messageOf(error));
      }
    }
    this.working = false;
    this.releaseTimer = window.setTimeout(() => this.release(), KEPT);
  }

  private async read(options: LoadOptions): Promise<Loaded | null> {
    const { source } = this.session.drawing;
    if (source === null) return null;
    if (this.held?.source === source) return (await this.held.planner).reload(options);
    this.release();
    this.held = { source, planner: createPlanner() };
    const { planner } = this.held;
    return (await planner).load(source.bytes, source.name, options).catch((error: unknown) => {
      this.release();
      throw error;
    });
  }

  private release(): void {
    clearTimeout(this.releaseTimer);
    this.held?.planner.then((planner) => planner.close(), () => {});
    this.held = null;
  }
}
