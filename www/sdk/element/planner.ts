/** The element that `<kerfway-planner>` is; how it is used: see `index.ts`. */

import { duration, plural } from '../cli/words.js';
import type { Planned, PlanRun } from '../functions.js';
import type { PlanJobOptions, Source } from '../options.js';
import type { OutputKind, Progress } from '../protocol.js';
import { DrawingElement, type DrawingEvents, type ElementState } from './drawing.js';
import { furnishPlanner } from './looks.js';

/** Events of `<kerfway-planner>`; the result is the plan with its G-code. */
export type PlannerEvents = DrawingEvents<Planned<'gcode'>>;
/** What `<kerfway-planner>` is at. */
export type PlannerState = ElementState;

/** What makes less of a difference than this many seconds is not worth a word. */
const WORTH_TELLING = 0.05;

/** `<kerfway-planner>`. */
export class KerfwayPlanner extends DrawingElement<Planned<'gcode'>, 'gcode'> {
  constructor() {
    super(furnishPlanner);
  }

  /** The finished plan in another form; see `render`. */
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
    return `Job ${duration(total_time)}, ${plural(contours, 'contour')}${saved >= WORTH_TELLING ? `, ${duration(saved)} less than as drawn` : ''}`;
  }

  protected file(): { ending: string; text: string } | null {
    return this.result === null ? null : { ending: '.nc', text: this.result.outputs.gcode };
  }
}
