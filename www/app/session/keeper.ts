/**
 * Keeps the current job in this browser, so that a reload, a crash or the next visit brings it back: the drawing, what was decided about it, and
 * its best plan. Samples are not kept here (see `kept-sample.ts`). Nothing leaves the machine, and one click forgets everything.
 *
 * Every tab has a job of its own, so that tabs with the same file do not overwrite each other. A new tab begins with the newest job. Where many
 * tabs are open, one may delete the job of another, which stores it again as soon as somebody comes back to it.
 */

import type { Project } from 'kerfway';
import { Database } from '../core/database.js';
import { Emitter } from '../core/emitter.js';
import { words } from '../core/words/index.js';
import type { Session } from './session.js';

/** Milliseconds between two writes: as much work may be lost in a crash. */
const PAUSE = 1000;
/** Jobs of tabs that are kept: enough for a few tabs, and drawings may have megabytes. */
const MOST = 4;
/** Where a tab remembers which job is its own. A reload and a crash keep it; a new tab has none. */
const TAB = 'kerfway.tab';

/** What is decided and found. The drawing has a table of its own, because it is written once. */
type Job = Omit<Project, 'drawing'> & { at: number };

interface Events extends Record<string, unknown> {
  change: void;
}

export class Keeper extends Emitter<Events> {
  private readonly database = new Database('kerfway', ['jobs', 'drawings']);
  private readonly before = rememberedTab();
  private tab: Promise<string> | null = null;
  private timer = 0;
  /** The drawing that is stored. */
  private stored: ArrayBuffer | Uint8Array | null = null;
  /** The drawing that the person wants forgotten. */
  private forgotten: ArrayBuffer | Uint8Array | null = null;
  private work: Promise<void> = Promise.resolve();
  /** Whether the person knows that nothing is kept. */
  private isSaid = false;

  constructor(private readonly session: Session) {
    super();
    const soon = () => {
      if (!this.timer) this.timer = window.setTimeout(() => void this.keep(), PAUSE);
    };
    session.store.on('change', soon);
    session.store.on('progress', soon);
    document.addEventListener('visibilitychange', () => void this.keep());
  }

  /** Whether the current job is stored in this browser. */
  get keeps(): boolean {
    return this.stored !== null && this.stored === this.session.drawing.source?.bytes;
  }

  /** The job to begin with: that of this tab, or for a new tab without settings of its own the newest; null if there is none. */
  async last(isPlain: boolean): Promise<Project | null> {
    try {
      const jobs = new Map(await this.database.all<Job>('jobs'));
      const newest = [...jobs].sort(([, a], [, b]) => b.at - a.at)[0]?.[0] ?? null;
      const key = this.before !== null && jobs.has(this.before) ? this.before : this.before === null && isPlain ? newest : null;
      const job = key === null ? undefined : jobs.get(key);
      const drawing = key === null ? undefined : await this.database.get<Uint8Array>('drawings', key);
      if (job === undefined || drawing === undefined) return null;
      const { at: _, ...rest } = job;
      return { ...rest, drawing };
    } catch {
      return null;
    }
  }

  /** Deletes everything that is stored. The current drawing is not stored again. */
  async forget(): Promise<void> {
    this.forgotten = this.session.drawing.source?.bytes ?? null;
    this.stored = null;
    await this.work;
    const keys = (await this.database.all('jobs')).map(([key]) => key);
    await this.database.change([], keys.flatMap((key) => [['jobs', key], ['drawings', key]] as const));
    this.emit('change', undefined);
  }

  /** Writes the current job at once, before the page is left. */
  settled(): Promise<void> {
    return this.keep();
  }

  /** Writes the current job. Where the browser stores nothing, the page works all the same, and says once what that means. */
  private keep(): Promise<void> {
    clearTimeout(this.timer);
    this.timer = 0;
    this.work = this.work.then(() => this.write()).catch(() => {
      if (!this.isSaid) this.session.store.notify(words.page.nothingKept);
      this.isSaid = true;
    });
    return this.work;
  }

  private async write(): Promise<void> {
    const { session } = this;
    const bytes = session.drawing.source?.bytes ?? null;
    await this.look();
    if (bytes === null || session.state.sample || bytes === this.forgotten) return;
    const { project } = session;
    if (project === null) return;
    this.tab ??= ownTab(this.before);
    const tab = await this.tab;
    const { drawing, ...rest } = project;
    const job: Job = { ...rest, at: Date.now() };
    const isNew = this.stored !== bytes;
    const old = isNew ? (await this.database.all<Job>('jobs')).filter(([key]) => key !== tab).sort(([, a], [, b]) => b.at - a.at).slice(MOST - 1) : [];
    await this.database.change(
      [['jobs', tab, job], ...(isNew ? [['drawings', tab, drawing] as const] : [])],
      old.flatMap(([key]) => [['jobs', key], ['drawings', key]] as const),
    );
    this.stored = bytes;
    if (isNew) this.emit('change', undefined);
  }

  /** Looks whether another tab has deleted what is stored. Where it has deleted everything, that is to be forgotten here, too. */
  private async look(): Promise<void> {
    if (this.stored === null || this.tab === null || (await this.database.has('drawings', await this.tab))) return;
    if (!(await this.database.has('jobs'))) this.forgotten = this.stored;
    this.stored = null;
    this.emit('change', undefined);
  }
}

/** The key of this tab, from before a reload; null for a new tab, or where the browser stores nothing. */
function rememberedTab(): string | null {
  try {
    return sessionStorage.getItem(TAB);
  } catch {
    return null;
  }
}

/** The key of this tab. A duplicated tab has the key of the tab it comes from, which holds a lock on it, and gets another one. */
async function ownTab(before: string | null): Promise<string> {
  const key = before !== null && (await locked(before)) ? before : newKey();
  if (key !== before) await locked(key);
  sessionStorage.setItem(TAB, key);
  return key;
}

/** Without a secure connection there is no `crypto.randomUUID`. */
const newKey = () => crypto.getRandomValues(new Uint32Array(4)).join('-');

/** Takes the lock of a key until the tab is closed; false if another tab has it. Without a secure connection there are no locks. */
async function locked(key: string): Promise<boolean> {
  const { locks } = navigator as { locks?: LockManager };
  if (locks === undefined) return true;
  return new Promise((answer) => {
    void locks.request(`${TAB}.${key}`, { ifAvailable: true }, (lock) => {
      answer(lock !== null);
      return lock === null ? undefined : new Promise(() => {});
    });
  });
}
