/** Before and after: the sheet shows the plan, or how the job would be cut nearest first or in the order of the drawing; or both side by side. */

import { h, button, setText } from '../core/dom.js';
import { seconds } from '../core/format.js';
import { messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import type { Playback } from '../playback/playback.js';
import { Timeline, type Moment } from '../playback/timeline.js';
import type { Alternative, Alternatives } from '../session/alternatives.js';
import type { Session } from '../session/session.js';
import { longestTime } from '../session/state.js';
import type { Travel } from '../stage/raster-messages.js';
import { Scene } from '../stage/scene.js';

export type Order = 'now' | 'greedy' | 'drawing';
const ORDERS: readonly Order[] = ['now', 'greedy', 'drawing'];

interface Parts {
  session: Session;
  scene: Scene;
  playback: Playback;
  stage: HTMLElement;
  alternatives(): Promise<Alternatives>;
  theme(): 'light' | 'dark';
  /** The stage is divided in another way. `begins`: from now on there are two sheets. */
  relayout(begins: boolean): void;
}

/** The plan as it is now, ready to be shown. */
interface Now extends Alternative {
  travel: Travel;
  still: number;
}

export class BeforeAfter {
  readonly root: HTMLElement;
  private readonly buttons: HTMLButtonElement[];
  private readonly split: HTMLButtonElement;
  /** Names the plan while another order is beside it. */
  private readonly first = h('p', { class: 'sheet-label first-label soft number' });
  private order: Order = 'now';
  private beside = false;
  private now: Now | null = null;
  /** The second stage, which shows the other order beside the plan; made when it is first asked for. */
  private other: { scene: Scene; canvas: HTMLCanvasElement; label: HTMLElement; timeline: Timeline | null; loaded: unknown } | null = null;
  private readonly moment: Moment = { stop: 0, cutting: false, cut: 0, leadIn: 0, leadOut: 0, x: 0, y: 0, gone: 1, lifted: false };
  private asked = 0;

  constructor(private readonly parts: Parts) {
    this.buttons = ORDERS.map((order) => button(words.result.short[order], { class: 'quiet small', 'aria-pressed': order === 'now', title: words.result[order === 'greedy' ? 'greedy' : order], onclick: () => void this.choose(order) }));
    this.split = button(words.result.beside, { icon: 'split', iconOnly: true, class: 'quiet small split-toggle', 'aria-pressed': false, onclick: () => void this.setBeside(!this.beside) });
    this.root = h('div', { class: 'orders', role: 'group', 'aria-label': words.result.compare, hidden: true }, ...this.buttons, this.split);
    parts.playback.on('moment', () => this.showMoment());
    parts.session.store.on('loaded', () => this.reset());
    parts.session.store.on('cleared', () => this.reset());
  }

  /** Whether two stages are side by side. */
  get isSplit(): boolean {
    return this.beside;
  }

  /** The plan has changed; null while there is none. */
  setNow(now: Now | null): void {
    this.now = now;
    this.root.hidden = now === null;
    if (now === null) {
      this.reset();
      return;
    }
    if (this.order === 'now' || this.beside) this.show(this.parts.scene, now, now);
    if (this.beside) this.showNames();
  }

  setTheme(theme: 'light' | 'dark'): void {
    this.other?.scene.setTheme(theme);
  }

  private reset(): void {
    this.asked += 1;
    this.order = 'now';
    if (this.beside) this.leaveSplit();
    this.press();
  }

  private async choose(order: Order): Promise<void> {
    this.order = order;
    this.press();
    if (this.beside && order === 'now') this.leaveSplit();
    await this.update();
  }

  async setBeside(on: boolean): Promise<void> {
    if (on === this.beside) return;
    if (!on) {
      this.leaveSplit();
      this.order = 'now';
    } else {
      this.beside = true;
      if (this.order === 'now') this.order = 'greedy';
      document.body.classList.add('split');
      this.second();
    }
    this.press();
    this.parts.relayout(on);
    await this.update();
  }

  private leaveSplit(): void {
    this.beside = false;
    document.body.classList.remove('split');
    this.parts.relayout(false);
    this.press();
  }

  private press(): void {
    this.buttons.forEach((b, i) => b.setAttribute('aria-pressed', String(ORDERS[i] === this.order)));
    this.split.setAttribute('aria-pressed', String(this.beside));
  }

  /** Shows the chosen order. */
  private async update(): Promise<void> {
    const { scene, session } = this.parts;
    const turn = (this.asked += 1);
    const { now } = this;
    if (!now) return;
    if (this.order === 'now' || this.beside) this.show(scene, now, now);
    if (this.order === 'now') return;
    try {
      const { asDrawn } = await import('../session/alternatives.js');
      const found = this.order === 'drawing' ? asDrawn(session.state) : await (await this.parts.alternatives()).nearest();
      if (turn !== this.asked || found === null || this.now === null) return;
      if (this.beside) this.showBeside(found);
      else this.show(scene, found, this.now);
    } catch (error) {
      if (turn === this.asked) session.store.notify(messageOf(error));
    }
  }

  private timeline({ path, total }: Alternative, { travel, still }: Now): Timeline | null {
    const { scene } = this.parts;
    return scene.shapes && new Timeline(path, total, scene.shapes, scene.lengths, travel, still);
  }

  private show(scene: Scene, what: Alternative, now: Now): void {
    scene.setPath(what.path, now.travel);
    this.parts.playback.setTimeline(this.timeline(what, now));
  }

  private showBeside(found: Alternative): void {
    const { now, other } = this;
    if (!now || !other) return;
    this.second();
    const { session: { state } } = this.parts;
    other.scene.setPrepared({ ...state, planFindings: [] });
    other.scene.setPath(found.path, now.travel);
    other.timeline = this.timeline(found, now);
    this.showNames();
    this.showMoment();
  }

  /** What each sheet shows and how long it takes, once the second shows something. */
  private showNames(): void {
    const { now, other } = this;
    if (!other) return;
    const second = other.timeline?.total ?? 0;
    const longest = Math.max(longestTime(this.parts.session.state), second);
    setText(this.first, now && second > 0 ? `${words.result.now} · ${seconds(now.total, longest)}` : '');
    setText(other.label, second > 0 ? `${words.result[this.order === 'now' ? 'greedy' : this.order]} · ${seconds(second, longest)}` : '');
  }

  private second(): void {
    const { other, parts: { session: { state } } } = this;
    if (other) {
      if (other.loaded === state.loaded) return;
      // Of another drawing neither its path nor its time is shown while those of this one are worked out.
      other.scene.setDrawing(state.loaded, state.extent, false);
      [other.loaded, other.timeline] = [state.loaded, null];
      this.showNames();
      return;
    }
    const canvas = h('canvas', { class: 'second', 'aria-hidden': 'true' });
    const label = h('p', { class: 'sheet-label second-label soft number' });
    this.parts.stage.insertBefore(canvas, this.parts.stage.querySelector('#hint'));
    this.parts.stage.append(this.first, label);
    this.other = { scene: new Scene(canvas, this.parts.scene.viewport, this.parts.theme()), canvas, label, timeline: null, loaded: null };
    this.parts.scene.shareBed(this.other.scene);
    this.second();
  }

  /** The second stage follows the playback, at the same second of its own job. */
  private showMoment(): void {
    const { other, parts: { playback } } = this;
    if (!other?.timeline || !this.beside) return;
    const { timeline } = other;
    const isPlaying = playback.time < playback.total || playback.playing;
    other.scene.highlight({ moment: isPlaying ? timeline.at(Math.min(playback.time, timeline.total), this.moment) : null });
  }
}
