/** The class of the element `<kerfway-planner>`. See `index.ts` for its use. */

import { duration, plural } from '../cli/words.js';
import type { Planned, PlanRun } from '../functions.js';
import type { PlanJobOptions, Source } from '../options.js';
import type { OutputKind, Progress } from '../protocol.js';
import { DrawingElement, type DrawingEvents, type ElementState } from './drawing.js';
import { fillPlanner } from './looks.js';

/** The events of `<kerfway-planner>`. The result is the plan with its G-code. */
export type PlannerEvents = DrawingEvents<Planned<'gcode'>>;
/** The state of `<kerfway-planner>`. */
export type PlannerState = ElementState;

/** Savings below this many seconds are not shown: they round to 0.0 s. */
const LEAST_SAVING = 0.05;

/** The class of `<kerfway-planner>`. */
export class KerfwayPlanner extends DrawingElement<Planned<'gcode'>, 'gcode'> {
  constructor() {
    super(fillPlanner);
  }

  /** Writes the finished plan in another format; see `render`. */
  async render(kind: Exclude<OutputKind, 'json'>, options: { width?: number } = {}): Promise<string | Uint8Array> {
    if (this.result === null || this.source === null) throw new Error('There is no plan yet. Open a drawing first.');
    return this.functions().render(this.source, this.result, kind, options);
  }

  protected plan(source: Source, options: PlanJobOptions): PlanRun<'gcode'> {
    return this.functions().plan(source, { ...options, outputs: ['gcode'] });
  }

  protected async made(planned: Planned<'gcode'>): Promise<Planned<'gcode'>> {
    return planned;
  }

  protected inWords(plan: Progress | Planned<'gcode'>): string {
    const { total_time, contours } = plan.summary;
    const saved = 'baselines' in plan ? plan.baselines.drawing.total_time - total_time : 0;
    return `Job ${duration(total_time)}, ${plural(contours, 'contour')}${saved >= LEAST_SAVING ? `, ${duration(saved)} less than as drawn` : ''}`;
  }

  protected file(): { ending: string; text: string } | null {
    return this.result === null ? null : { ending: '.nc', text: this.result.outputs.gcode };
  }
}
