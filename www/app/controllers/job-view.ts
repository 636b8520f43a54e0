/** Shows the state of the session on the stage, in the playback, in the announcements and in the address. */

import { activeContours, type Loaded, type MachineProfile } from 'kerfway';
import type { Announcer } from '../core/announce.js';
import { count, seconds } from '../core/format.js';
import { words } from '../core/words/index.js';
import { headline } from '../panels/dock.js';
import type { Playback } from '../playback/playback.js';
import { writeAddress } from '../session/address.js';
import { reachOf } from '../session/off-bed.js';
import { bedAround, fitsBed, homeAround } from '../session/placing.js';
import type { Session } from '../session/session.js';
import { longestTime, type State } from '../session/state.js';
import type { Travel } from '../stage/raster-messages.js';
import type { Scene } from '../stage/scene.js';
import type { BeforeAfter } from './before-after.js';
import type { Notices } from './notices.js';
import type { Selection } from './selection.js';

interface Parts {
  session: Session;
  scene: Scene;
  playback: Playback;
  announcer: Announcer;
  notices: Notices;
  selection: Selection;
  orders: BeforeAfter;
  /** Closes what covers the stage on a phone. */
  showStage(): void;
  /** Shows in the legend whether anything is cut once for two parts. */
  showCommon(shown: boolean): void;
}

export class JobView {
  /** By how many degrees the shown job is turned. */
  private turn = 0;

  constructor(private readonly parts: Parts) {
    const { session: { store }, playback, scene, notices } = parts;
    store.on('notice', (sentence) => notices.show(sentence));
    store.on('loaded', (event) => this.showDrawing(event));
    store.on('cleared', () => this.showNothing());
    store.on('progress', (state) => this.showProgress(state));
    store.on('change', (state) => this.showState(state));
    playback.on('moment', (moment) => scene.highlight({ moment }));
  }

  private showDrawing({ loaded, fresh, same }: { loaded: Loaded; fresh: boolean; same: boolean }): void {
    const { session: { state }, scene, playback, announcer, selection, notices } = this.parts;
    playback.setTimeline(null);
    // What was said is about the drawing before, and so is the button beside it.
    if (fresh) notices.hide();
    // The selection stays when the contours are the same.
    const selected = same ? selection.contours : [];
    // A job that is turned lies somewhere else.
    const turn = state.load.turn ?? 0;
    scene.setDrawing(loaded, state.extent, !same || turn !== this.turn);
    this.turn = turn;
    selection.selectAll(selected);
    if (fresh) this.parts.showStage();
    const contours = activeContours(loaded).length;
    if (fresh) announcer.say(words.page.read(state.name, words.drawing.contours(contours, count(contours))));
  }

  private showNothing(): void {
    const { session: { state }, scene, playback, selection } = this.parts;
    playback.setTimeline(null);
    selection.select(null);
    scene.setDrawing(null, state.extent, false);
  }

  private showProgress(state: State): void {
    const { progress, path, machine, insights } = state;
    const { scene, announcer, selection } = this.parts;
    if (!progress?.path || !path || !machine || !scene.shapes) return;
    const travel = travelOf(machine, state);
    scene.highlight({ partitions: insights.now?.partitions ?? null });
    this.parts.orders.setNow({ path, total: progress.summary.total_time, travel, still: machine.pierce_time + machine.beam_on_delay });
    selection.refresh();
    announcer.report(words.page.best(seconds(progress.summary.total_time, longestTime(state))));
  }

  private showState(state: State): void {
    const { session, scene, playback, announcer, notices } = this.parts;
    document.body.dataset.phase = state.phase;
    this.showAddress();
    notices.showRefusal(state, () => session.store.refusalSeen());
    if (state.phase === 'done' || state.phase === 'paused') announcer.report(headline(state));
    this.parts.showCommon((state.common?.offsets.length ?? 0) > 1);
    scene.setBed(bedAround(state.placing, state.machine, state.loaded), state.loaded === null || fitsBed(state.placing, state.machine, state.loaded, reachOf(state)));
    if (!scene.shapes) return;
    scene.setPrepared(state);
    if (state.progress !== null) return;
    playback.setTimeline(null);
    this.parts.orders.setNow(null);
    scene.highlight({ partitions: null });
    if (state.machine) scene.setPath(null, travelOf(state.machine, state));
  }

  private showAddress(): void {
    const { session } = this.parts;
    if (session.catalog.methods.length > 0) writeAddress(session.address());
  }
}

function travelOf(machine: MachineProfile, { placing, loaded }: State): Travel {
  return { home: homeAround(placing, machine, loaded), returnHome: machine.return_home, perAxis: machine.travel === 'per-axis' ? machine.rapid.speed : null };
}
