/**
 * Several drawings dropped at once: planned one after the other, each for its time, with the machine and the method chosen.
 * What comes of each is kept as G-code; any of them can be looked at again, which plans it anew.
 */

import type { LoadOptions } from 'kerfway';
import { Emitter } from '../core/emitter.js';
import { messageOf } from '../core/strings.js';
import type { Session } from './session.js';
import { words } from '../core/words/index.js';

/** `asks`: it waits for an answer of a person; the others go on. */
export type ItemState = 'waits' | 'working' | 'asks' | 'done' | 'failed';

export interface Item {
  readonly file: File;
  state: ItemState;
  /** Seconds of the job as planned. */
  seconds: number | null;
  gcode: string | null;
  /** How it was read when it was left, contours pinned and left out among it. */
  load: LoadOptions | null;
  /** Why it failed. */
  sentence: string | null;
}

interface Events extends Record<string, unknown> {
  change: readonly Item[];
}

export class Queue extends Emitter<Events> {
  items: readonly Item[] = [];
  /** The one that is open. */
  current: Item | null = null;

  /** `open` reads a file and has the session take it with these options, if there are any; `begun` is called between the two. */
  constructor(
    private readonly session: Session,
    private readonly open: (file: File, load: LoadOptions | null, begun: () => void) => Promise<void>,
  ) {
    super();
    session.on('change', () => void this.hear());
  }

  /** Files that were dropped or chosen together. One alone makes no queue. */
  take(files: readonly File[]): void {
    const [first] = files;
    if (first === undefined) return;
    this.items = files.length < 2 ? [] : files.map((file) => ({ file, state: 'waits', seconds: null, gcode: null, load: null, sentence: null }));
    this.current = null;
    this.emit('change', this.items);
    if (this.items[0] === undefined) void this.open(first, null, () => {});
    else this.begin(this.items[0]);
  }

  /** Opens one of them, again or out of turn. */
  begin(item: Item): void {
    this.leave();
    item.state = 'working';
    void this.open(item.file, item.load, () => (this.current = item));
    this.emit('change', this.items);
  }

  /** Something else is opened: what is under way waits, until somebody comes back to it. */
  leave(): void {
    if (this.current?.state === 'working') this.current.state = 'waits';
    if (this.current !== null) this.current.load = this.session.state.load;
    this.current = null;
    this.emit('change', this.items);
  }

  private async hear(): Promise<void> {
    const { current: item, session: { state } } = this;
    if (item === null) return;
    if (state.phase === 'question' && item.state === 'working') this.end(item, 'asks');
    else if (state.phase === 'failed' && item.state !== 'failed') this.end(item, 'failed', { sentence: state.error });
    else if (state.phase === 'ready' && item.state === 'working') this.end(item, 'failed', { sentence: state.error ?? words.files.nothing });
    else if (state.phase === 'planning' && item.state !== 'working') {
      // Answered, or changed: it is planned anew.
      item.state = 'working';
      this.emit('change', this.items);
    } else if (state.phase === 'done' && item.state === 'working') {
      // Once: what follows is heard, too.
      item.state = 'done';
      const seconds = state.progress?.summary.total_time ?? null;
      try {
        const gcode = (await this.session.output('gcode')) as string;
        this.end(item, 'done', { gcode, seconds });
      } catch (error) {
        this.end(item, 'failed', { sentence: messageOf(error) });
      }
    }
  }

  // Whatever a person looks at stays open; only the one just ended makes room for the next.
  private end(item: Item, state: ItemState, found: Partial<Item> = {}): void {
    Object.assign(item, { state, ...found });
    this.emit('change', this.items);
    const next = this.items.find((other) => other.state === 'waits');
    if (next !== undefined && item === this.current) this.begin(next);
  }
}
