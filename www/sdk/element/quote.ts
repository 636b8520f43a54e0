/** The class of the element `<kerfway-quote>`. See `index.ts` for its use. */

import { KerfwayError } from '../errors.js';
import type { Planned, PlanRun } from '../functions.js';
import type { Source } from '../bytes.js';
import type { PlanJobOptions } from '../options.js';
import type { Progress } from '../protocol.js';
import type { Material, Quote } from '../quote.js';
import { quoteBudget } from '../quote-budget.js';
import { abortable } from '../with-planner.js';
import { DrawingElement, type DrawingEvents } from './drawing.js';
import { QUOTE } from './looks.js';
import { early, numberIn } from './options.js';

/** Events of `<kerfway-quote>`; the result is the report. */
export type QuoteEvents = DrawingEvents<Quote>;

const MATERIAL = ['material', 'thickness', 'density'] as const;

// Beside the class, because hosts import its types, and not those of the file that registers it.
declare global {
  interface HTMLElementTagNameMap {
    'kerfway-quote': KerfwayQuote;
  }
}

/** `<kerfway-quote>`. */
export class KerfwayQuote extends DrawingElement<Quote, never> {
  /** @internal The browser reads it. */
  static readonly observedAttributes: readonly string[] = MATERIAL;

  /** A function of the host that returns the price in words, which is shown above the figures. It is called for every report. */
  price: ((quote: Quote) => string | Promise<string>) | null = early(this as KerfwayQuote, 'price') ?? null;

  private sheet: Material | null = null;
  /** The number of reports requested so far. The results of earlier requests are dropped. */
  private requested = 0;

  constructor() {
    super(QUOTE, 'Download the report');
    const material = early(this as KerfwayQuote, 'material');
    if (material !== undefined) this.material = material;
  }

  /** The material of the sheet: the one set here, or else that of the attributes. Setting it makes a new report of the same plan. */
  get material(): Material {
    return this.sheet ?? attributedMaterial(this);
  }

  // React and Vue set the property where a page in HTML has the attribute, which is the material's name.
  set material(material: Material | string | null | undefined) {
    if (typeof material === 'string') {
      this.setAttribute('material', material);
      return;
    }
    this.sheet = material ?? null;
    this.reportAgain();
  }

  /** @internal The browser calls it. */
  attributeChangedCallback(): void {
    if (this.sheet === null) this.reportAgain();
  }

  protected plan(source: Source, options: PlanJobOptions): PlanRun {
    this.piece('report').replaceChildren();
    this.piece('price').textContent = '';
    return this.functions(quoteBudget).plan(source, options);
  }

  protected async made(_: Planned, signal: AbortSignal): Promise<Quote> {
    return this.reported(signal);
  }

  protected inWords({ summary }: Progress | Planned): string {
    return this.words.job(summary, null);
  }

  protected file(): { ending: string; text: string } | null {
    return this.result === null ? null : { ending: '.quote.json', text: `${JSON.stringify(this.result, null, 2)}\n` };
  }

  // Reports the finished plan again for another material, without a new search.
  private reportAgain(): void {
    // One that failed, for a thickness that cannot be one, can be put right.
    if (this.state !== 'done' && !(this.state === 'failed' && this.held)) return;
    if (!this.held && this.source !== null) {
      this.open(this.source, this.loaded?.name).catch(() => {});
      return;
    }
    const [number, { replaced }] = [this.requested, this];
    this.reported(replaced).then(
      (quote) => this.finish(quote),
      (error: unknown) => {
        if (number + 1 === this.requested && replaced?.aborted !== true) this.fail(error);
      },
    );
  }

  private async reported(signal: AbortSignal | undefined): Promise<Quote> {
    const number = (this.requested += 1);
    const planner = await this.opened();
    const quote = await abortable(planner.quote({ material: this.material }), signal);
    // The worker died, and the one that took its place knows only its path: no server could confirm this report.
    if (quote.from_path && !this.options?.warm) throw new KerfwayError('planner-died', 'The planner had to be started again. Open the drawing again.');
    const price = await abortable(Promise.resolve(this.price?.(quote) ?? ''), signal);
    if (number !== this.requested) throw new DOMException('Another report was requested.', 'AbortError');
    this.piece('price').textContent = price;
    this.piece('report').replaceChildren(...this.words.facts(quote).flatMap(([term, figure]) => [piece('dt', 'term', term), piece('dd', 'figure', figure)]));
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
