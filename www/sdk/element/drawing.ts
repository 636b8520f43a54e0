/**
 * What the elements have in common: a drawing is dropped, chosen or handed over, planned in a worker while its path is shown,
 * and what comes of it is told to the host. Each element says what is made of the finished plan.
 */

import { plural } from '../cli/words.js';
import { functionsOn, type Functions, type Planned, type PlanRun } from '../functions.js';
import { abortable } from '../lend.js';
import type { PlanJobOptions, PlanningOptions, Source } from '../options.js';
import type { Planner } from '../planner.js';
import type { Loaded, MachineProfile, MethodInfo, OutputKind, Progress } from '../protocol.js';
import { checkSize } from '../size.js';
import { worked } from '../worked.js';
import { attributed } from './options.js';
import { Picture } from './picture.js';

/** What the events of an element carry as `detail`; `Result` is what it makes. They do not bubble. */
export interface DrawingEvents<Result> {
  /** The planner is there. */
  ready: CustomEvent<{ machines: readonly MachineProfile[]; methods: readonly MethodInfo[] }>;
  progress: CustomEvent<Progress>;
  result: CustomEvent<Result>;
  /** One sentence for people; it is shown, too. */
  error: CustomEvent<{ message: string }>;
}

/** What an element is at; also its attribute `state`. */
export type ElementState = 'empty' | 'reading' | 'planning' | 'done' | 'failed';

// Where there is no page (a server that renders one), the module can be imported all the same.
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** What `<kerfway-planner>` and `<kerfway-quote>` have in common; `Result` is what they make, `K` what is written of the plan. */
export abstract class DrawingElement<Result, K extends OutputKind> extends Base {
  /** Where planners come from: see `define.ts`. */
  static createPlanner: () => Promise<Planner>;

  /** Options of reading and planning besides the attributes, which they override. */
  options: PlanningOptions = {};
  /** What the drawing holds, once it is read. */
  loaded: Loaded | null = null;
  /** What came of the last drawing. */
  result: Result | null = null;

  protected source: Source | null = null;
  /** Of the plan under way or the last one: a new one aborts it. */
  private job: { control: AbortController; stop: () => void } | null = null;
  private planner: Promise<Planner> | null = null;
  /** The planner that holds the finished plan; an element that was taken out of its page meanwhile has another one. */
  private holder: Promise<Planner> | null = null;
  /** Those of the planner, the default first. */
  private machines: readonly MachineProfile[] = [];
  private readonly root: ShadowRoot;
  private readonly picture: Picture;

  constructor(furnish: (root: ShadowRoot) => void) {
    super();
    this.root = this.attachShadow({ mode: 'open' });
    furnish(this.root);
    this.picture = new Picture(this.piece('contours'), this.piece('path'));
    this.root.addEventListener('click', (event) => this.press((event.target as HTMLElement).dataset['does']));
    this.input.addEventListener('change', () => this.take(this.input.files));
    for (const type of ['dragover', 'dragleave', 'drop'] as const) this.addEventListener(type, (event) => this.drag(event));
  }

  /** What it is at. */
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
      (error: Error) => this.fail(error),
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

  /** Reads and plans a drawing, as if it had been dropped. Resolves with what comes of it; rejects when it fails or another is opened. */
  async open(source: Source, name = 'drawing.dxf'): Promise<Result> {
    this.job?.control.abort();
    const control = new AbortController();
    this.source = source;
    [this.loaded, this.result] = [null, null];
    this.picture.show(null, null);
    this.become('reading', `Reading ${name}`);
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
    this.job = { control, stop: () => run.stop() };
    try {
      const planned = await run;
      this.holder = this.planner;
      this.picture.follow(planned.path);
      const result = await this.made(planned, control.signal);
      this.finish(result, this.inWords(planned));
      return result;
    } catch (error) {
      if (!control.signal.aborted) this.fail(error as Error);
      throw error;
    }
  }

  /** Ends the plan under way and keeps the best found. */
  stop(): void {
    this.job?.stop();
  }

  protected abstract plan(source: Source, options: PlanJobOptions): PlanRun<K>;
  /** What the host is told of a finished plan. */
  protected abstract made(planned: Planned<K>, signal: AbortSignal): Promise<Result>;
  /** The line below the picture, while it is planned and after. */
  protected abstract inWords(plan: Progress | Planned<K>): string;
  /** A file's name and text of what is taken away. */
  protected abstract file(): { ending: string; text: string } | null;

  // All on one planner, which is kept: a new drawing ends the plan before.
  protected functions(): Functions {
    return functionsOn(async (work, signal) => abortable(this.opened().then(work), signal));
  }

  protected opened(): Promise<Planner> {
    this.planner ??= DrawingElement.createPlanner().catch((error: unknown) => {
      this.planner = null;
      throw error;
    });
    return this.planner;
  }

  protected finish(result: Result, words: string): void {
    this.result = result;
    this.become('done', words);
    this.tell('result', result);
  }

  /** Whether the finished plan can still be asked. */
  protected get held(): boolean {
    return this.state === 'done' && this.holder !== null && this.holder === this.planner;
  }

  protected fail({ message }: Error): void {
    this.become('failed', '');
    this.piece('message').textContent = message;
    this.tell('error', { message });
  }

  // What can be seen and pressed follows from the state alone.
  protected become(state: ElementState, numbers: string): void {
    this.setAttribute('state', state);
    this.piece('numbers').textContent = numbers;
    this.piece('drop').hidden = state !== 'empty' && state !== 'failed';
    this.piece('stop').hidden = state !== 'planning';
    this.piece('download').hidden = this.piece('again').hidden = state !== 'done';
    this.piece('message').hidden = state !== 'failed';
  }

  protected piece<E extends HTMLElement = HTMLElement>(name: string): E {
    return this.root.querySelector(`[part~=${name}]`) as E;
  }

  private show(loaded: Loaded): void {
    this.loaded = loaded;
    this.become('planning', plural(worked(loaded).length, 'contour'));
    const machine = this.options.machine ?? this.getAttribute('machine');
    const preset = this.machines.find((m) => m.name === machine) ?? this.machines[0] ?? null;
    this.picture.show(loaded, typeof machine === 'object' && machine !== null ? machine : preset);
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
    // What comes of it is shown, and told by events.
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
    link.download = `${this.loaded?.name.replace(/\.dxf$/i, '')}${file.ending}`;
    link.click();
    // The browser has taken it by then.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }

  private tell<T extends keyof DrawingEvents<Result>>(type: T, detail: DrawingEvents<Result>[T]['detail']): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  private get input(): HTMLInputElement {
    return this.root.querySelector('input') as HTMLInputElement;
  }
}
