/**
 * Plays the job: the current time in it, playing and pausing, the order of the contours. At the end of the job the whole path is shown, before
 * that only what is cut by then.
 */

import { Emitter } from '../core/emitter.js';
import type { BestPath } from 'kerfway';
import { firstStops } from '../stage/shapes.js';
import { Timeline, type Moment } from './timeline.js';

/** Seconds in which a job of any length is played at the speed "whole job". */
export const WHOLE_JOB = 20;

export class Playback extends Emitter<{ moment: Moment | null; path: void; state: void }> {
  time = 0;
  playing = false;
  /** Seconds of the job per second; null: the whole job in twenty seconds. */
  speed: number | null = null;
  private timeline: Timeline | null = null;
  private stopOfContour: Int32Array | null = null;
  private atEnd = true;
  private frame = 0;
  private before = 0;
  private readonly moment: Moment = { stop: 0, cutting: false, cut: 0, leadIn: 0, leadOut: 0, x: 0, y: 0, gone: 1, lifted: false };

  get total(): number {
    return this.timeline?.total ?? 0;
  }

  get stops(): number {
    return this.timeline?.stops ?? 0;
  }

  /** Another path: the playback stays at the same share of the job. */
  setTimeline(timeline: Timeline | null): void {
    const share = this.total > 0 ? this.time / this.total : 1;
    this.timeline = timeline;
    this.stopOfContour = null;
    if (!timeline) {
      this.pause();
      this.atEnd = true;
    }
    this.time = this.atEnd ? this.total : share * this.total;
    this.emit('path', undefined);
    this.emitMoment();
  }

  get path(): BestPath | null {
    return this.timeline?.path ?? null;
  }

  /** The place of a contour in the order. A contour that is cut in several stretches is where it begins. */
  stopOf(contour: number): number | null {
    const path = this.path;
    if (!path) return null;
    if (!this.stopOfContour) {
      const most = path.contours.reduce((a, b) => Math.max(a, b), 0);
      this.stopOfContour = firstStops(path, most + 1);
    }
    const stop = this.stopOfContour[contour] ?? -1;
    return stop < 0 ? null : stop;
  }

  begin(stop: number): number {
    return this.timeline?.begin(stop) ?? 0;
  }

  /** The stop at the current time. */
  get stop(): number {
    return this.timeline ? Math.min(this.stops - 1, this.timeline.stopAt(this.time)) : 0;
  }

  seek(time: number): void {
    this.time = Math.max(0, Math.min(this.total, time));
    this.atEnd = this.time >= this.total;
    this.emitMoment();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  play(): void {
    if (!this.timeline || this.playing) return;
    if (this.atEnd) this.seek(0);
    this.playing = true;
    this.before = performance.now();
    this.frame = requestAnimationFrame((now) => this.run(now));
    this.emit('state', undefined);
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.frame);
    this.emit('state', undefined);
  }

  private run(now: number): void {
    const rate = this.speed ?? this.total / WHOLE_JOB;
    this.seek(this.time + (Math.max(0, now - this.before) / 1000) * rate);
    this.before = now;
    if (this.atEnd) this.pause();
    else this.frame = requestAnimationFrame((next) => this.run(next));
  }

  private emitMoment(): void {
    this.emit('moment', this.timeline && !this.atEnd ? this.timeline.at(this.time, this.moment) : null);
  }
}
