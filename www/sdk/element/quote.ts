/** The element that `<kerfway-quote>` is; how it is used: see `index.ts`. */

import { duration } from '../cli/words.js';
import type { Planned, PlanRun } from '../functions.js';
import { abortable } from '../lend.js';
import type { PlanJobOptions, Source } from '../options.js';
import type { Progress } from '../protocol.js';
import type { Material, Quote } from '../quote.js';
import { DrawingElement, type DrawingEvents } from './drawing.js';
import { facts } from './facts.js';
import { furnishQuote } from './looks.js';
import { numberIn } from './options.js';

/** Events of `<kerfway-quote>`; the result is the report. */
export type QuoteEvents = DrawingEvents<Quote>;

/**
 * What is searched when nobody says: counted in moves and from one seed, so that a server which plans again confirms the
 * report by its hash. It takes about a second.
 */
const BUDGET = { moves: 100_000, seed: 1 } as const;

const MATERIAL = ['material', 'thickness', 'density'] as const;

/** `<kerfway-quote>`. */
export class KerfwayQuote extends DrawingElement<Quote, never> {
  /** @internal The browser reads it. */
  static readonly observedAttributes: readonly string[] = MATERIAL;

  /** What the host asks for the job, in words; shown above the figures. Called for every report. */
  price: ((quote: Quote) => string | Promise<string>) | null = null;

  private sheet: Material | null = null;
  /** Counts reports: what comes of an earlier one is of no interest. */
  private asked = 0;

  constructor() {
    super(furnishQuote);
  }

  /** What the sheet is made of: what is set here, or else what the attributes say. Another one makes a new report of the same plan. */
  get material(): Material {
    return this.sheet ?? attributedMaterial(this);
  }

  set material(material: Material | null) {
    this.sheet = material;
    this.again();
  }

  /** @internal The browser calls it. */
  attributeChangedCallback(): void {
    if (this.sheet === null) this.again();
  }

  protected plan(source: Source, options: PlanJobOptions): PlanRun {
    const free = options.moves === undefined && options.seconds === undefined;
    this.piece('report').replaceChildren();
    this.piece('price').textContent = '';
    return this.functions().plan(source, free ? { ...BUDGET, ...options } : options);
  }

  protected async made(_: Planned, signal: AbortSignal): Promise<Quote> {
    return this.reported(signal);
  }

  protected inWords({ summary }: Progress | Planned): string {
    return `Job ${duration(summary.total_time)}`;
  }

  protected file(): { ending: string; text: string } | null {
    return this.result === null ? null : { ending: '.quote.json', text: `${JSON.stringify(this.result, null, 2)}\n` };
  }

  // A plan that is done is not searched again for another sheet.
  private again(): void {
    if (this.state !== 'done') return;
    if (!this.held && this.source !== null) {
      this.open(this.source, this.loaded?.name).catch(() => {});
      return;
    }
    const asked = this.asked;
    this.reported().then(
      (quote) => this.finish(quote, `Job ${duration(quote.times.total)}`),
      (error: Error) => {
        if (asked + 1 === this.asked) this.fail(error);
      },
    );
  }

  private async reported(signal?: AbortSignal): Promise<Quote> {
    const asked = (this.asked += 1);
    const planner = await this.opened();
    const quote = await abortable(planner.quote(this.material), signal);
    const price = await abortable(Promise.resolve(this.price?.(quote) ?? ''), signal);
    if (asked !== this.asked) throw new DOMException('Another report was asked for.', 'AbortError');
    this.piece('price').textContent = price;
    this.piece('report').replaceChildren(...facts(quote).flatMap(([term, figure]) => [piece('dt', 'term', term), piece('dd', 'figure', figure)]));
    return quote;
  }
}

function piece(tag: string, part: string, text: string): HTMLElement {
  const made = document.createElement(tag);
  made.setAttribute('part', part);
  made.textContent = text;
  return made;
}

function attributedMaterial(element: Element): Material {
  const [name, thickness, density] = MATERIAL.map((attribute) => element.getAttribute(attribute) || null);
  return {
    ...(name ? { name } : {}),
    ...(thickness ? { thickness: numberIn(thickness) } : {}),
    ...(density ? { density: numberIn(density) } : {}),
  };
}
