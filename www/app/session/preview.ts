/**
 * A look at the drawing as other options would read it, while the plan of the one in hand goes on: a planner of its own reads
 * it, so that nothing waits. The newest wish wins; what is wished in between is never read.
 */

import { createPlanner, type Loaded, type LoadOptions, type Planner } from 'kerfway';
import { Emitter } from '../core/emitter.js';
import { messageOf } from '../core/strings.js';
import { outlook, type Outlook } from './outlook.js';
import type { Session, Source } from './session.js';

/** Milliseconds a wish rests before it is read: a slider that is moved wishes sixty times a second. */
const REST = 120;
/** Milliseconds after the last look in which the planner is kept. */
const KEPT = 30_000;

interface Events extends Record<string, unknown> {
  /** What would change; null: nothing is looked at any more. */
  outlook: Outlook | null;
  /** These options cannot be: one sentence. */
  refused: string;
}

export class Preview extends Emitter<Events> {
  private wish: LoadOptions | null = null;
  private rest = 0;
  private working = false;
  /** The planner and what it has read. */
  private held: { source: Source; planner: Promise<Planner> } | null = null;
  private idle = 0;

  constructor(private readonly session: Session) {
    super();
    const gone = () => {
      this.clear();
      this.release();
    };
    session.on('loaded', ({ fresh }) => (fresh ? gone() : this.clear()));
    session.on('cleared', gone);
  }

  /** Looks at the drawing as these options read it. */
  ask(options: LoadOptions): void {
    this.wish = options;
    clearTimeout(this.rest);
    this.rest = window.setTimeout(() => void this.work(), REST);
  }

  /** Nothing is to be looked at any more. */
  clear(): void {
    this.wish = null;
    clearTimeout(this.rest);
    this.emit('outlook', null);
  }

  private async work(): Promise<void> {
    if (this.working) return;
    this.working = true;
    clearTimeout(this.idle);
    let done: LoadOptions | null = null;
    while (this.wish !== null && this.wish !== done) {
      done = this.wish;
      try {
        const then = await this.read(done);
        const now = this.session.state.loaded;
        // Whatever was wished meanwhile comes next.
        if (this.wish === done && now !== null && then !== null) this.emit('outlook', outlook(now, then, done.joinTolerance ?? 0));
      } catch (error) {
        if (this.wish === done) this.emit('refused', messageOf(error));
      }
    }
    this.working = false;
    this.idle = window.setTimeout(() => this.release(), KEPT);
  }

  private async read(options: LoadOptions): Promise<Loaded | null> {
    const { source } = this.session;
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
    clearTimeout(this.idle);
    this.held?.planner.then((planner) => planner.close(), () => {});
    this.held = null;
  }
}
