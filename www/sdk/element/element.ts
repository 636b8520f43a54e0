/** The element that `<kerfway-planner>` is; how it is used: see `index.ts`. */

import { duration, plural } from '../cli/words.js';
import { functionsOn, type Functions, type Planned } from '../functions.js';
import { abortable } from '../lend.js';
import type { PlanningOptions, Source } from '../options.js';
import type { Planner } from '../planner.js';
import type { Loaded, MachineProfile, MethodInfo, OutputKind, Progress, Summary } from '../protocol.js';
import { furnish } from './looks.js';
import { attributed } from './options.js';
import { Picture } from './picture.js';

/** What the events carry as `detail`. They do not bubble. */
export interface PlannerEvents {
  /** The planner is there. */
  ready: CustomEvent<{ machines: readonly MachineProfile[]; methods: readonly MethodInfo[] }>;
  progress: CustomEvent<Progress>;
  result: CustomEvent<Planned<'gcode'>>;
  /** One sentence for people; it is shown, too. */
  error: CustomEvent<{ message: string }>;
}

export type PlannerState = 'empty' | 'reading' | 'planning' | 'done' | 'failed';

// Where there is no page (a server that renders one), the module can be imported all the same.
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

export class KerfwayPlanner extends Base {
  /** Where planners come from: see `definePlanner`. */
  static createPlanner: () => Promise<Planner>;

  /** Options of reading and planning besides the attributes, which they override. */
  options: PlanningOptions = {};
  /** What the drawing holds, once it is read. */
  loaded: Loaded | null = null;
  /** What the last plan came to. */
  result: Planned<'gcode'> | null = null;

  private planner: Promise<Planner> | null = null;
  /** Those of the planner, the default first. */
  private machines: readonly MachineProfile[] = [];
  private source: Source | null = null;
  /** Of the plan under way or the last one: a new one aborts it. */
  private job: { control: AbortController; stop: () => void } | null = null;
  private readonly root: ShadowRoot;
  private readonly picture: Picture;

  constructor() {
    super();
    this.root = this.attachShadow({ mode: 'open' });
    furnish(this.root);
    this.picture = new Picture(this.piece('contours'), this.piece('path'));
    this.root.addEventListener('click', (event) => this.press((event.target as HTMLElement).dataset['does']));
    this.input.addEventListener('change', () => this.take(this.input.files));
    for (const type of ['dragover', 'dragleave', 'drop'] as const) this.addEventListener(type, (event) => this.drag(event));
  }

  get state(): PlannerState {
    return (this.getAttribute('state') ?? 'empty') as PlannerState;
  }

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

  disconnectedCallback(): void {
    this.picture.unwatch();
    this.job?.control.abort();
    if (this.state === 'reading' || this.state === 'planning') this.become('empty', '');
    this.planner?.then((planner) => planner.close(), () => {});
    this.planner = null;
  }

  /** Reads and plans a drawing, as if it had been dropped. Resolves with the plan; rejects when it fails or another is opened. */
  async open(source: Source, name = 'drawing.dxf'): Promise<Planned<'gcode'>> {
    this.job?.control.abort();
    const control = new AbortController();
    this.source = source;
    [this.loaded, this.result] = [null, null];
    this.picture.show(null, null);
    this.become('reading', `Reading ${name}`);
    const run = this.functions().plan(source, {
      ...attributed(this),
      ...this.options,
      name,
      outputs: ['gcode'],
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
      const result = await run;
      this.finish(result);
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

  /** The finished plan in another form; see `render`. */
  async render(kind: Exclude<OutputKind, 'json'>, options: { width?: number } = {}): Promise<string | Uint8Array> {
    if (this.result === null || this.source === null) throw new Error('There is no plan yet. Open a drawing first.');
    return this.functions().render(this.source, this.result, kind, options);
  }

  private opened(): Promise<Planner> {
    this.planner ??= KerfwayPlanner.createPlanner().catch((error: unknown) => {
      this.planner = null;
      throw error;
    });
    return this.planner;
  }

  // All on one planner, which is kept: a new drawing ends the plan before.
  private functions(): Functions {
    return functionsOn(async (work, signal) => abortable(this.opened().then(work), signal));
  }

  private show(loaded: Loaded): void {
    this.loaded = loaded;
    this.become('planning', plural(loaded.contours.length, 'contour'));
    const machine = this.options.machine ?? this.getAttribute('machine');
    const preset = this.machines.find((m) => m.name === machine) ?? this.machines[0] ?? null;
    this.picture.show(loaded, typeof machine === 'object' && machine !== null ? machine : preset);
  }

  private follow(progress: Progress): void {
    if (progress.path !== null) this.picture.follow(progress.path);
    this.piece('numbers').textContent = told(progress.summary);
    this.tell('progress', progress);
  }

  private finish(result: Planned<'gcode'>): void {
    this.result = result;
    const saved = result.baselines.drawing.total_time - result.summary.total_time;
    this.picture.follow(result.path);
    this.become('done', `${told(result.summary)}${saved >= 0.05 ? `, ${duration(saved)} less than as drawn` : ''}`);
    this.tell('result', result);
  }

  private fail({ message }: Error): void {
    this.become('failed', '');
    this.piece('message').textContent = message;
    this.tell('error', { message });
  }

  // What can be seen and pressed follows from the state alone.
  private become(state: PlannerState, numbers: string): void {
    this.setAttribute('state', state);
    this.piece('numbers').textContent = numbers;
    this.piece('drop').hidden = state !== 'empty' && state !== 'failed';
    this.piece('stop').hidden = state !== 'planning';
    this.piece('download').hidden = this.piece('again').hidden = state !== 'done';
    this.piece('message').hidden = state !== 'failed';
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
    this.open(async () => file.arrayBuffer(), file.name).catch(() => {});
    this.input.value = '';
  }

  private download(): void {
    if (this.result === null) return;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([this.result.outputs.gcode], { type: 'text/plain' }));
    link.download = `${this.result.loaded.name.replace(/\.dxf$/i, '')}.nc`;
    link.click();
    // The browser has taken it by then.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }

  private tell<K extends keyof PlannerEvents>(type: K, detail: PlannerEvents[K]['detail']): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  private get input(): HTMLInputElement {
    return this.root.querySelector('input') as HTMLInputElement;
  }

  private piece<E extends HTMLElement = HTMLElement>(name: string): E {
    return this.root.querySelector(`[part~=${name}]`) as E;
  }
}

const told = ({ total_time, contours }: Summary): string => `Job ${duration(total_time)}, ${plural(contours, 'contour')}`;

declare global {
  interface HTMLElementTagNameMap {
    'kerfway-planner': KerfwayPlanner;
  }
}

/** Makes `<kerfway-planner>` known, once, on planners that `createPlanner` opens. */
export function definePlanner(createPlanner: () => Promise<Planner>): void {
  KerfwayPlanner.createPlanner ??= createPlanner;
  const registry = globalThis.customElements as CustomElementRegistry | undefined;
  if (registry?.get('kerfway-planner') === undefined) registry?.define('kerfway-planner', KerfwayPlanner);
}
