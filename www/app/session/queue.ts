/**
 * Several drawings that were dropped together. They are planned one after the other, each for its time, with the chosen machine and method.
 * The G-code of each is kept. Any of them can be opened again, which plans it again.
 */

import type { LoadOptions, MachineProfile } from 'kerfway';
import { Emitter } from '../core/emitter.js';
import { Latest } from '../core/latest.js';
import { messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import { isRefusedOffBed } from './off-bed.js';
import type { Session } from './session.js';

/** `question`: the file needs an answer from the person; the others are planned meanwhile. */
export type ItemState = 'waiting' | 'planning' | 'question' | 'done' | 'failed';

export interface Item {
  readonly file: File;
  state: ItemState;
  /** Seconds of the planned job. */
  seconds: number | null;
  gcode: string | null;
  /** The machine that the G-code is for. */
  machine: MachineProfile | null;
  /** The options it was read with when it was last open, with its pinned and skipped contours. */
  load: LoadOptions | null;
  /** Why it failed. */
  sentence: string | null;
}

/** Opens the drawing in a file, with the given options if there are any. Resolves to why it cannot be used, or to null. */
export type OpenFile = (file: File, load: LoadOptions | null) => Promise<string | null>;

interface Events extends Record<string, unknown> {
  change: readonly Readonly<Item>[];
}

export class Queue extends Emitter<Events> {
  private all: readonly Item[] = [];
  private opened: Item | null = null;
  /** Whether the drawing of the session is that of the open item: before, it is still the one before it. */
  private isShown = false;
  /** The item whose drawing the session has. It stays open where the next one cannot be used. */
  private shown: Item | null = null;
  /** The openings of items: an item that is opened again has an older one, which says nothing any more. */
  private readonly latest = new Latest();

  constructor(private readonly session: Session, private readonly open: OpenFile) {
    super();
    session.store.on('change', () => void this.follow());
  }

  get items(): readonly Readonly<Item>[] {
    return this.all;
  }

  /** The item that is open, or null. */
  get current(): Readonly<Item> | null {
    return this.opened;
  }

  /** Takes files that were dropped or chosen together. A single file makes no queue. */
  take(files: readonly File[]): void {
    const [file] = files;
    if (file === undefined) return;
    this.all = files.length < 2 ? [] : files.map((file) => ({ file, state: 'waiting', seconds: null, gcode: null, machine: null, load: null, sentence: null }));
    [this.opened, this.isShown, this.shown] = [null, false, null];
    this.emit('change', this.all);
    const [first] = this.all;
    if (first === undefined) void this.open(file, null);
    else this.begin(first);
  }

  /** Opens an item by its place in the list, again or out of turn. */
  openAt(index: number): void {
    const item = this.all[index];
    if (item !== undefined) this.begin(item);
  }

  /** Something else is about to be opened: an item that is being planned waits until somebody opens it again. */
  leave(): void {
    const item = this.opened;
    if (item?.state === 'planning') item.state = 'waiting';
    if (item !== null && this.isShown) item.load = this.session.state.load;
    [this.opened, this.isShown, this.shown] = [null, false, null];
    this.emit('change', this.all);
  }

  private begin(item: Item): void {
    const { shown } = this;
    this.leave();
    item.state = 'planning';
    [this.opened, this.shown] = [item, shown];
    const isLatest = this.latest.begin();
    this.emit('change', this.all);
    void this.open(item.file, item.load).then((refusal) => {
      if (!isLatest() || this.opened !== item) return;
      if (refusal === null) {
        [this.isShown, this.shown] = [true, item];
        void this.follow();
        return;
      }
      this.end(item, 'failed', { sentence: refusal });
      if (this.opened !== item || this.shown === null) return;
      [this.opened, this.isShown] = [this.shown, true];
      this.emit('change', this.all);
    });
  }

  private async follow(): Promise<void> {
    const { opened: item, session: { state } } = this;
    if (item === null || !this.isShown) return;
    if (state.phase === 'question' && item.state === 'planning') this.end(item, 'question');
    else if (state.phase === 'ready' && item.state === 'planning') this.end(item, 'failed', { sentence: state.error ?? words.files.nothing });
    else if (state.phase === 'planning' && item.state !== 'planning') {
      // The question was answered or a choice was made: the item is planned again.
      item.state = 'planning';
      this.emit('change', this.all);
    } else if (state.phase === 'done' && item.state === 'planning') {
      // The state is set at once, because further changes arrive while the G-code is being written.
      item.state = 'done';
      const seconds = state.progress?.summary.total_time ?? null;
      try {
        const gcode = (await this.session.output('gcode')) as string;
        this.end(item, 'done', { gcode, seconds, machine: state.machine });
      } catch (error) {
        this.end(item, 'failed', { sentence: isRefusedOffBed(state, 'gcode') ? words.dock.offBed : messageOf(error) });
      }
    }
  }

  /** Ends an item and opens the next one that waits, unless the person has opened another one meanwhile. */
  private end(item: Item, state: ItemState, found: Partial<Item> = {}): void {
    Object.assign(item, { state, ...found });
    this.emit('change', this.all);
    const next = this.all.find((other) => other.state === 'waiting');
    if (next !== undefined && item === this.opened) this.begin(next);
  }
}
