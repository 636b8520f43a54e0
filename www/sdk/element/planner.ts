/** The class of the element `<kerfway-planner>`. See `index.ts` for its use. */

import { KerfwayError } from '../errors.js';
import type { Planned, PlanRun } from '../functions.js';
import type { Source } from '../bytes.js';
import type { PlanJobOptions } from '../options.js';
import type { OutputKind, Progress } from '../protocol.js';
import { abortable } from '../with-planner.js';
import { DrawingElement, type DrawingEvents, type ElementState } from './drawing.js';
import { PLANNER } from './looks.js';

/** The events of `<kerfway-planner>`. The result is the plan with its G-code. */
export type PlannerEvents = DrawingEvents<Planned<'gcode'>>;
/** The state of `<kerfway-planner>`. */
export type PlannerState = ElementState;

// Beside the class, because hosts import its types, and not those of the file that registers it.
declare global {
  interface HTMLElementTagNameMap {
    'kerfway-planner': KerfwayPlanner;
  }
}

/** The class of `<kerfway-planner>`. */
export class KerfwayPlanner extends DrawingElement<Planned<'gcode'>, 'gcode'> {
  constructor() {
    super(PLANNER, 'Download G-code');
  }

  /** Writes the finished plan in another format; see `render`. Rejects when another drawing is opened before. */
  async render(kind: Exclude<OutputKind, 'json'>, options: { width?: number } = {}): Promise<string | Uint8Array> {
    if (this.result === null || this.source === null) throw new KerfwayError('no-plan', 'There is no plan yet. Open a drawing first.');
    // The planner is that of the next drawing as well.
    return abortable(this.functions().render(this.source, this.result, kind, options), this.replaced);
  }

  protected plan(source: Source, options: PlanJobOptions): PlanRun<'gcode'> {
    return this.functions().plan(source, { ...options, outputs: ['gcode'] });
  }

  protected async made(planned: Planned<'gcode'>): Promise<Planned<'gcode'>> {
    return planned;
  }

  protected inWords(plan: Progress | Planned<'gcode'>): string {
    const saved = 'baselines' in plan ? plan.baselines.drawing.total_time - plan.summary.total_time : null;
    return this.words.job(plan.summary, saved);
  }

  protected file(): { ending: string; text: string } | null {
    return this.result === null ? null : { ending: '.nc', text: this.result.outputs.gcode };
  }
}
