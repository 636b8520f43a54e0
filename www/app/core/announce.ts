/**
 * Polite announcements for screen readers: the newest sentence, at most one every two seconds, so that a search does not talk all the time.
 */

/** Milliseconds between two announcements. */
const PAUSE = 2000;

export class Announcer {
  private waiting: string | null = null;
  private spoken = -Infinity;
  private timer = 0;

  constructor(private readonly region: HTMLElement) {}

  /** Announces a sentence now, or when two seconds have passed since the last one. A newer sentence replaces one that waits. */
  say(sentence: string): void {
    this.waiting = sentence;
    if (this.timer) return;
    const wait = Math.max(0, this.spoken + PAUSE - performance.now());
    this.timer = window.setTimeout(() => this.speak(), wait);
  }

  private speak(): void {
    this.timer = 0;
    this.spoken = performance.now();
    if (this.waiting !== null) this.region.textContent = this.waiting;
    this.waiting = null;
  }
}
