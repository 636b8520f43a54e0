/**
 * The base class of the elements. A drawing is dropped, chosen or passed by the host; it is planned in a worker while its
 * path is shown, and the result is dispatched as an event. Each element decides what the result is.
 */

import { activeContours } from '../contours.js';
import { reportOf } from '../errors.js';
import { createFunctions, type DefaultBudget, type Functions, type Planned, type PlanRun } from '../functions.js';
import type { Source } from '../bytes.js';
import type { PlanJobOptions, PlanningOptions } from '../options.js';
import type { Planner } from '../planner.js';
import type { ErrorReport, Loaded, MachineProfile, MethodInfo, OutputKind, Progress } from '../protocol.js';
import { checkSize } from '../size.js';
import { abortable } from '../with-planner.js';
import { homeAround } from './home.js';
import { ENGLISH, type ElementLabels } from './labels.js';
import { dress, label, type Looks } from './looks.js';
import { attributed, early, nameOf } from './options.js';
import { Picture } from './picture.js';

/** The events of an element with their `detail`. They do not bubble. */
export interface DrawingEvents<Result> {
  /** The planner has started. */
  ready: CustomEvent<{ machines: readonly MachineProfile[]; methods: readonly MethodInfo[] }>;
  progress: CustomEvent<Progress>;
  result: CustomEvent<Result>;
  /** Why it failed: a code, the values that the sentence names, and the sentence, which the element shows as well. */
  error: CustomEvent<ErrorReport>;
}

/** The state of an element, which is also its attribute `state`. */
export type ElementState = 'empty' | 'reading' | 'planning' | 'done' | 'failed';

// On a server, where there is no `HTMLElement`, the module can still be imported.
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** The events of an element with their types: those of the DOM, of which some have another meaning here. */
type ElementEvents<Result> = Omit<HTMLElementEventMap, keyof DrawingEvents<Result>> & DrawingEvents<Result>;

// The types of its listeners. `error` and `progress` are events of the DOM as well, with other members.
export interface DrawingElement<Result, K extends OutputKind> {
  /** @hidden Adds a listener. The events of the element have their `detail`; all others are those of the DOM. */
  addEventListener<T extends keyof ElementEvents<Result>>(type: T, listener: (this: this, event: ElementEvents<Result>[T]) => unknown, options?: boolean | AddEventListenerOptions): void;
  /** @hidden Adds a listener for an event of any other name. */
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
  /** @hidden Removes a listener. */
  removeEventListener<T extends keyof ElementEvents<Result>>(type: T, listener: (this: this, event: ElementEvents<Result>[T]) => unknown, options?: boolean | EventListenerOptions): void;
  /** @hidden Removes a listener for an event of any other name. */
  removeEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | EventListenerOptions): void;
}

/** The base class of `<kerfway-planner>` and `<kerfway-quote>`. `K` are the outputs that an element needs to make its `Result`. */
export abstract class DrawingElement<Result, K extends OutputKind> extends Base {
  /** Opens the planner of an element; `define.ts` sets it. */
  static createPlanner: () => Promise<Planner>;

  /** Options of reading and planning. They override the attributes. */
  options: PlanningOptions = early(this as DrawingElement<Result, K>, 'options') ?? {};
  /** The contents of the drawing, once it has been read. */
  loaded: Loaded | null = null;
  /** The result of the last drawing. */
  result: Result | null = null;

  /** The texts that the host has set. */
  private own: Partial<ElementLabels> = {};
  protected source: Source | null = null;
  /** The running or last plan, which a new one aborts. */
  private job: { control: AbortController; stop: () => void; words: string } | null = null;
  private planner: Promise<Planner> | null = null;
  /** The planner that has the finished plan. An element that was removed from its page and put back has another one. */
  private holder: Promise<Planner> | null = null;
  /** The machine presets, the default first. */
  private machines: readonly MachineProfile[] = [];
  /** The button that was pressed by keyboard has disappeared: the next one that appears gets the focus. */
  private isPressed = false;
  private readonly root: ShadowRoot;
  private readonly picture: Picture;

  /** `download`: what the button says that offers the result. */
  constructor(
    private readonly looks: Looks,
    private readonly downloadLabel: string,
  ) {
    super();
    this.root = this.attachShadow({ mode: 'open' });
    dress(this.root, looks.css);
    this.root.innerHTML = looks.body;
    this.labels = early(this as DrawingElement<Result, K>, 'labels') ?? {};
    this.picture = new Picture(this.piece('contours'), this.piece('path'));
    this.root.addEventListener('click', (event) => this.press((event.target as HTMLElement).dataset['does']));
    this.input.addEventListener('change', () => this.take(this.input.files));
    for (const type of ['dragover', 'dragleave', 'drop'] as const) this.addEventListener(type, (event) => this.drag(event));
  }

  /** The texts, for another language: those that are set replace the English ones. */
  get labels(): Partial<ElementLabels> {
    return this.own;
  }

  set labels(labels: Partial<ElementLabels> | null) {
    this.own = { ...labels };
    label(this.root, this.words);
  }

  /** All texts of the element. */
  protected get words(): ElementLabels {
    return { ...ENGLISH, download: this.downloadLabel, ...this.own };
  }

  /** The state of the element. */
  get state(): ElementState {
    return (this.getAttribute('state') ?? 'empty') as ElementState;
  }

  /** @internal The browser calls it. */
  connectedCallback(): void {
    this.picture.watch();
    if (!this.hasAttribute('state')) this.setAttribute('state', 'empty');
    this.opened().then(
      ({ machines, methods }) => {
        this.machines = machines;
        this.tell('ready', { machines, methods });
      },
      (error: unknown) => this.fail(error),
    );
  }

  /** @internal The browser calls it. */
  disconnectedCallback(): void {
    this.picture.unwatch();
    this.job?.control.abort();
    if (this.state === 'reading' || this.state === 'planning') this.become('empty', '');
    this.planner?.then((planner) => planner.close(), () => {});
    this.planner = null;
  }

  /** @internal The browser calls it. */
  adoptedCallback(): void {
    dress(this.root, this.looks.css);
  }

  /** Reads and plans a drawing, as if it had been dropped. Resolves with the result; rejects when it fails or another drawing is opened. */
  async open(source: Source, name = nameOf(source)): Promise<Result> {
    this.job?.control.abort();
    const control = new AbortController();
    this.source = source;
    [this.loaded, this.result, this.holder] = [null, null, null];
    this.picture.show(null, null);
    this.become('reading', this.words.reading(name));
    const run = this.plan(source, {
      ...attributed(this),
      ...this.options,
      name,
      signal: control.signal,
      onLoaded: (loaded) => {
        if (!control.signal.aborted) this.show(loaded);
      },
      onProgress: (progress) => {
        if (!control.signal.aborted) this.follow(progress);
      },
    });
    const job = (this.job = { control, stop: () => run.stop(), words: '' });
    try {
      const planned = await run;
      this.holder = this.planner;
      job.words = this.inWords(planned);
      this.picture.follow(planned.path);
      const result = await this.made(planned, control.signal);
      this.finish(result);
      return result;
    } catch (error) {
      if (!control.signal.aborted) this.fail(error);
      throw error;
    }
  }

  /** Ends the running search and keeps the best plan. */
  stop(): void {
    this.job?.stop();
  }

  protected abstract plan(source: Source, options: PlanJobOptions): PlanRun<K>;
  /** Makes the result from a finished plan. */
  protected abstract made(planned: Planned<K>, signal: AbortSignal): Promise<Result>;
  /** The line of text below the picture, during the search and after it. */
  protected abstract inWords(plan: Progress | Planned<K>): string;
  /** The file to download: the ending of its name, and its text. */
  protected abstract file(): { ending: string; text: string } | null;

  // All drawings use the same planner, so a new drawing ends the previous plan.
  protected functions(defaultBudget?: DefaultBudget): Functions {
    return createFunctions(async (work, signal) => abortable(this.opened().then(work), signal), defaultBudget);
  }

  protected opened(): Promise<Planner> {
    this.planner ??= DrawingElement.createPlanner().catch((error: unknown) => {
      this.planner = null;
      throw error;
    });
    return this.planner;
  }

  /** Aborts when another drawing takes the place of this one, and when the element leaves its page. */
  protected get replaced(): AbortSignal | undefined {
    return this.job?.control.signal;
  }

  protected finish(result: Result): void {
    this.result = result;
    this.become('done', this.job?.words ?? '');
    this.tell('result', result);
  }

  /** Whether the planner still has the finished plan of the drawing. */
  protected get held(): boolean {
    return this.holder !== null && this.holder === this.planner;
  }

  protected fail(error: unknown): void {
    const report = reportOf(error);
    this.become('failed', '');
    this.piece('message').textContent = this.words.error(report);
    this.tell('error', report);
  }

  // The state alone decides which pieces are visible.
  protected become(state: ElementState, numbers: string): void {
    const pressed = this.root.querySelector('button:focus-visible');
    this.setAttribute('state', state);
    this.piece('numbers').textContent = numbers;
    this.piece('drop').hidden = state !== 'empty' && state !== 'failed';
    this.piece('stop').hidden = state !== 'planning';
    this.piece('download').hidden = this.piece('again').hidden = state !== 'done';
    this.piece('message').hidden = state !== 'failed';
    const isShown = (button: Element) => button.closest('[hidden]') === null;
    if (pressed !== null) this.isPressed = !isShown(pressed);
    const next = [...this.root.querySelectorAll('button')].find(isShown);
    if (!this.isPressed || next === undefined) return;
    this.isPressed = false;
    // While the file was read, nothing could have the focus. Who has gone on since stays there.
    if (pressed !== null || document.activeElement === document.body) next.focus({ preventScroll: true });
  }

  protected piece<E extends HTMLElement = HTMLElement>(name: string): E {
    return this.root.querySelector(`[part~=${name}]`) as E;
  }

  private show(loaded: Loaded): void {
    this.loaded = loaded;
    this.become('planning', this.words.contours(activeContours(loaded).length));
    // A framework may set the property to nothing.
    const options = this.options ?? {};
    const machine = options.machine ?? this.getAttribute('machine');
    const preset = this.machines.find((m) => m.name === machine) ?? this.machines[0] ?? null;
    const used = typeof machine === 'object' && machine !== null ? machine : preset;
    this.picture.show(loaded, used && homeAround(used, options, loaded));
  }

  private follow(progress: Progress): void {
    if (progress.path !== null) this.picture.follow(progress.path);
    this.piece('numbers').textContent = this.inWords(progress);
    this.tell('progress', progress);
  }

  private press(what: string | undefined): void {
    if (what === 'choose') this.input.click();
    else if (what === 'stop') this.stop();
    else if (what === 'download') this.download();
  }

  private drag(event: DragEvent): void {
    event.preventDefault();
    this.toggleAttribute('dragging', event.type === 'dragover');
    if (event.type === 'drop') this.take(event.dataTransfer?.files ?? null);
  }

  private take(files: FileList | null): void {
    const file = files?.[0];
    if (file === undefined) return;
    // Results and errors are shown and dispatched as events, so the promise is not needed.
    const read = async () => {
      checkSize(file.size);
      return file.arrayBuffer();
    };
    this.open(read, file.name).catch(() => {});
    this.input.value = '';
  }

  private download(): void {
    const file = this.file();
    if (file === null) return;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([file.text], { type: 'text/plain' }));
    link.download = `${this.loaded?.name.replace(/\.(dxf|svg)$/i, '')}${file.ending}`;
    link.click();
    // A minute later the browser has read the file.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }

  private tell<T extends keyof DrawingEvents<Result>>(type: T, detail: DrawingEvents<Result>[T]['detail']): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  private get input(): HTMLInputElement {
    return this.root.querySelector('input') as HTMLInputElement;
  }
}
